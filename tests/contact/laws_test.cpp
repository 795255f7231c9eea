// Laws 1 to 9 of contact (contact/contact.h), bit for bit: equivalent descriptions of a case have the same
// answers.
#include "contact/laws.h"

namespace foresee {
namespace {

using namespace testing_by_hand;

/// Law 1.
TEST(Laws, IsSymmetric) {
  check_law(
      [](Case& c) {
        std::swap(c.a, c.b);
        return true;
      },
      unchanged);
}

/// Law 2.
TEST(Laws, MirroringChangesNothing) {
  for (int axis : {0, 1, 2})
    check_law(
        [axis](Case& c) {
          for (Object* o : {&c.a, &c.b})
            o->x[axis] = -o->x[axis], o->v[axis] = -o->v[axis], o->a[axis] = -o->a[axis];
          return axis < c.a.layout.axes;
        },
        unchanged);
}

/// Law 3.
TEST(Laws, ExchangingAxesChangesNothing) {
  check_law(
      [](Case& c) {
        // The axis of a cylinder, or of a separate limit, is not exchanged.
        const bool upright = c.a.layout.shape == Shape::cylinder || c.b.layout.shape == Shape::cylinder ||
                             c.a.layout.has_growth_z || c.b.layout.has_growth_z ||
                             c.question.within_z.has_value();
        const int last = upright ? 1 : c.a.layout.axes - 1;
        for (Object* o : {&c.a, &c.b})
          for (auto* numbers : {&o->x, &o->v, &o->a, &o->half}) std::swap((*numbers)[0], (*numbers)[last]);
        return last > 0;
      },
      unchanged);
}

/// Law 4.
TEST(Laws, ScalingLengthsChangesNoTime) {
  for (double scale : {0x1p-7, 0x1p30, 0x1p-100, 0x1p100, 0x1p-478, 0x1p478})
    check_law(
        [scale](Case& c) {
          bool exact = multiply(c.question.within, scale);
          if (c.question.within_z) exact = multiply(*c.question.within_z, scale) && exact;
          for (Object* o : {&c.a, &c.b})
            exact = multiply(o->x, scale) && multiply(o->v, scale) && multiply(o->a, scale) &&
                    multiply(o->half, scale) && multiply(o->r, scale) && multiply(o->hz, scale) &&
                    multiply(o->growth, scale) && multiply(o->growth_z, scale) && exact;
          return exact;
        },
        scaled_by(1, scale));
}

/// Law 5.
TEST(Laws, ScalingTimeScalesContact) {
  for (double scale : {0x1p-3, 0x1p10, 0x1p-60, 0x1p60, 0x1p-200, 0x1p200})
    check_law(
        [scale](Case& c) {
          bool exact = multiply(c.question.horizon.now, scale) && multiply(c.question.horizon.h, scale);
          for (Object* o : {&c.a, &c.b})
            exact = multiply(o->v, 1 / scale) && multiply(o->a, 1 / scale / scale) && multiply(o->t, scale) &&
                    multiply(o->until, scale) && multiply(o->growth, 1 / scale) &&
                    multiply(o->growth_z, 1 / scale) && exact;
          return exact;
        },
        scaled_by(scale, 1));
}

/// Law 6.
TEST(Laws, ShiftingTheSceneChangesNothing) {
  for (double offset : {4096.0, -1048576.0})
    check_law(
        [offset](Case& c) {
          bool exact = true;
          for (Object* o : {&c.a, &c.b})
            for (double& x : o->x) {
              const double before = x;
              x += offset;
              exact = exact && oracle::Exact(x) == oracle::Exact(before) + oracle::Exact(offset);
            }
          return exact;
        },
        unchanged);
}

/// Law 7. Absolute times are other doubles, so only times measured from now are the same bits.
TEST(Laws, ShiftingTimeChangesNothing) {
  for (double offset : {4096.0, -1048576.0})
    check_law(
        [offset](Case& c) {
          bool exact = true;
          for (double* time : {&c.question.horizon.now, &c.a.t, &c.b.t, &c.a.until, &c.b.until}) {
            if (!std::isfinite(*time)) continue;
            const double before = *time;
            *time += offset;
            exact = exact && oracle::Exact(*time) == oracle::Exact(before) + oracle::Exact(offset);
          }
          return exact;
        },
        [](const Case& c, const Case& shifted) {
          const Said right = said_of(c), other = said_of(shifted);
          ASSERT_EQ(right.times.has_value(), other.times.has_value()) << c;
          if (right.times) {
            EXPECT_EQ(right.times->dt, other.times->dt) << c;
            EXPECT_EQ(right.times->dt_end, other.times->dt_end) << c;
          }
          ASSERT_EQ(right.approach.has_value(), other.approach.has_value()) << c;
          if (right.approach) {
            EXPECT_EQ(right.approach->dt, other.approach->dt) << c;
            EXPECT_EQ(right.approach->d, other.approach->d) << c;
          }
        });
}

/// Law 8.
TEST(Laws, ReferenceTimesDoNotMatter) {
  check_law(
      [](Case& c) {
        bool exact = true;
        for (Object* o : {&c.a, &c.b}) {
          const double before = o->t;
          o->t -= 3;
          exact = exact && !grows(o->layout) && before <= c.question.horizon.now &&
                  oracle::Exact(before) - oracle::Exact(3) == oracle::Exact(o->t) &&
                  move_reference_time(*o, -3);
        }
        return exact;
      },
      unchanged);
}

/// Law 9: with time reversed from the end of the horizon, the same pairs touch, and at the same distance.
/// Times are rounded to other doubles.
TEST(Laws, TimeReversalChangesNoDecision) {
  check_law(
      [](Case& c) {
        const auto [now, h] = c.question.horizon;
        bool exact = true;
        for (Object* o : {&c.a, &c.b}) {
          exact = exact && !grows(o->layout) && o->t == now &&
                  o->until == std::numeric_limits<double>::infinity() && move_reference_time(*o, h);
          for (double& v : o->v) v = -v;
        }
        return exact;
      },
      [](const Case& c, const Case& reversed) {
        const Said forward = said_of(c), backward = said_of(reversed);
        EXPECT_EQ(forward.times.has_value(), backward.times.has_value()) << c;
        EXPECT_EQ(forward.approach->d, backward.approach->d) << c;
      });
}

}  // namespace
}  // namespace foresee
