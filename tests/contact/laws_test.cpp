// Laws that hold for every pair, bit for bit: exchanging the two, exchanging and mirroring axes, scaling
// lengths and time by powers of two, shifting the scene in space, splitting the horizon, reversing time. Over
// the families of hard_pairs.h and every pair of shapes.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "contact/case_count.h"
#include "contact/hard_pairs.h"

namespace foresee::contact {
namespace {

using namespace testing_by_hand;

/// Everything that contact says about a pair.
struct Said {
  std::optional<ContactTimes> times;
  std::optional<ClosestApproach> approach;  ///< where both exist at some moment
};

Said said_of(const Case& c) {
  const oracle::Asked asked = oracle::asked_about(c.a, c.b, c.question.horizon);
  Said said{contact(c.a, c.b, c.question), {}};
  if (asked.begin <= asked.end) said.approach = closest(c.a, c.b, c.question);
  return said;
}

void expect_same(const Said& right, const Said& other, double time, double length, const Case& c) {
  ASSERT_EQ(right.times.has_value(), other.times.has_value()) << c;
  if (right.times) {
    EXPECT_EQ(other.times->t, time * right.times->t) << c;
    EXPECT_EQ(other.times->dt, time * right.times->dt) << c;
    EXPECT_EQ(other.times->t_end, time * right.times->t_end) << c;
    EXPECT_EQ(other.times->dt_end, time * right.times->dt_end) << c;
  }
  ASSERT_EQ(right.approach.has_value(), other.approach.has_value()) << c;
  if (right.approach) {
    EXPECT_EQ(other.approach->t, time * right.approach->t) << c;
    EXPECT_EQ(other.approach->dt, time * right.approach->dt) << c;
    // A distance below the normal numbers has lost bits that the scaled one has.
    const double d = length * right.approach->d;
    const bool full = right.approach->d == 0 || std::min(right.approach->d, d) >= 0x1p-1022;
    if (full) {
      EXPECT_EQ(other.approach->d, d) << c;
    }
  }
}

/// Every pair of shapes, on every number of axes that it has.
using Scenery = std::pair<Shapes, int>;

std::vector<Scenery> all_sceneries() {
  std::vector<Scenery> all;
  for (const Shapes shapes : {Shapes::boxes, Shapes::balls, Shapes::box_and_ball})
    for (const int axes : {1, 2, 3}) all.push_back({shapes, axes});
  for (const Shapes shapes : {Shapes::points_within, Shapes::box_and_point_within})
    for (const int axes : {2, 3}) all.push_back({shapes, axes});
  all.insert(all.end(), {{Shapes::cylinders, 3}, {Shapes::cylinder_and_box, 3}});
  return all;
}

/// `change` makes another case whose answers are the first one's, times scaled by `time`, lengths by
/// `length`; false where its numbers would not be exact.
using Change = std::function<bool(Case&)>;
using Compare = std::function<void(const Case& c, const Case& changed)>;

void check_law(const Change& change, const Compare& compare) {
  std::uint64_t seed = 70000;
  int applied = 0;
  const auto check_scene = [&](const Family& family, const Scenery& scenery, int cases) {
    Generator generate(family, seed++);
    for (int i = 0; i < scaled_count(cases); ++i) {
      const Case c = make_case(generate, family, scenery.first, scenery.second);
      Case changed = c;
      if (!change(changed)) continue;
      ++applied;
      compare(c, changed);
      if (::testing::Test::HasFailure()) return;
    }
  };
  for (const Scenery& scenery : all_sceneries()) {
    for (const Family& family : ordinary_families()) check_scene(family, scenery, 10);
    for (const Family& family : growing_families()) check_scene(family, scenery, 3);
  }
  EXPECT_GT(applied, sanitized ? 5 : 100);
}

Compare scaled_by(double time, double length) {
  return [time, length](const Case& c, const Case& changed) {
    expect_same(said_of(c), said_of(changed), time, length, c);
  };
}
const Compare unchanged = scaled_by(1, 1);

/// number * scale, if that is exact.
bool multiply(double& number, double scale) {
  const double before = number;
  number *= scale;
  return number / scale == before;
}

template <std::size_t N>
bool multiply(double (&numbers)[N], double scale) {
  bool exact = true;
  for (double& number : numbers) exact = multiply(number, scale) && exact;
  return exact;
}

double speed_of(const Object& o, int axis) {
  return o.layout.law == Law::rest ? 0 : o.v[axis];
}
double turn_of(const Object& o, int axis) {
  return o.layout.law < Law::accelerated ? 0 : o.a[axis];
}

/// Tells the same motion by where and how fast it is `s` after its own reference time; false if that is not
/// exact.
bool retell(Object& o, double s) {
  using oracle::Exact;
  bool exact = true;
  for (int j = 0; j < o.layout.axes; ++j) {
    const double x = o.x[j], v = speed_of(o, j), a = turn_of(o, j);
    o.v[j] = v + s * a, o.x[j] = x + s * v + s * s * a / 2;
    exact = exact && Exact(o.v[j]) == Exact(v) + Exact(s) * Exact(a) &&
            Exact(o.x[j]) == Exact(x) + Exact(s) * Exact(v) + oracle::half(Exact(s) * Exact(s) * Exact(a));
  }
  return exact;
}

TEST(Laws, IsSymmetric) {
  check_law(
      [](Case& c) {
        std::swap(c.a, c.b);
        return true;
      },
      unchanged);
}

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

TEST(Laws, ExchangingAxesChangesNothing) {
  check_law(
      [](Case& c) {
        // A cylinder's axis stays, and so does that of a limit of its own.
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

TEST(Laws, ReferenceTimesDoNotMatter) {
  check_law(
      [](Case& c) {
        bool exact = true;
        for (Object* o : {&c.a, &c.b}) {
          const double before = o->t;
          o->t -= 3;
          exact = exact && !grows(o->layout) && before <= c.question.horizon.now &&
                  oracle::Exact(before) - oracle::Exact(3) == oracle::Exact(o->t) && retell(*o, -3);
        }
        return exact;
      },
      unchanged);
}

/// From the end of the horizon backwards, the same pair touches or not and comes as near. Instants are
/// rounded towards other doubles.
TEST(Laws, TimeReversalChangesNoDecision) {
  check_law(
      [](Case& c) {
        const auto [now, h] = c.question.horizon;
        bool exact = true;
        for (Object* o : {&c.a, &c.b}) {
          exact = exact && !grows(o->layout) && o->t == now &&
                  o->until == std::numeric_limits<double>::infinity() && retell(*o, h);
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

/// The first contact of a horizon is that of its first half, or else that of its second.
TEST(Laws, HorizonsCanBeSplit) {
  check_law(
      [](Case& c) {
        const auto [now, h] = c.question.horizon;
        c.question.horizon.h = h / 2;
        return (now + h / 2) - now == h / 2 && h / 2 * 2 == h;
      },
      [](const Case& c, const Case& first_half) {
        const auto whole = contact(c.a, c.b, c.question), first = contact(c.a, c.b, first_half.question);
        Case second_half = first_half;
        second_half.question.horizon.now += first_half.question.horizon.h;
        const auto second = contact(c.a, c.b, second_half.question);
        ASSERT_EQ(whole.has_value(), first.has_value() || second.has_value()) << c;
        if (!whole) return;
        EXPECT_EQ(whole->t, (first ? first : second)->t) << c;
        if (!first) {
          EXPECT_EQ(whole->t_end, second->t_end) << c;
        }
      });
}

TEST(Laws, FasterGrowthIsNeverLater) {
  check_law(
      [](Case& c) {
        if (!grows(c.a.layout)) std::swap(c.a, c.b);
        c.a.growth *= 1.25, c.a.growth_z *= 1.25;
        return grows(c.a.layout);
      },
      [](const Case& c, const Case& grown) {
        const auto before = contact(c.a, c.b, c.question), after = contact(grown.a, grown.b, c.question);
        ASSERT_TRUE(after || !before) << c;
        EXPECT_TRUE(!before || after->dt <= before->dt) << c;
      });
}

TEST(Laws, GrowingIsNeverLater) {
  check_law(
      [](Case& c) {
        c.question.within += 0.25;
        return true;
      },
      [](const Case& c, const Case& grown) {
        const auto before = contact(c.a, c.b, c.question), after = contact(c.a, c.b, grown.question);
        if (!before) return;
        ASSERT_TRUE(after.has_value()) << c;
        EXPECT_LE(after->t, before->t) << c;
        EXPECT_LE(after->dt, before->dt) << c;
      });
}

}  // namespace
}  // namespace foresee::contact
