// Outward rounding of bounds and moving boxes, checked with exact rationals.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>

#include "index/tpr_tree/bounds.h"
#include "index/tpr_tree/moving_box.h"
#include "index/tpr_tree/search/nearest_walk.h"
#include "tests/scenes.h"

namespace foresee {
namespace {

using Exact = boost::multiprecision::cpp_rational;
using testing::Random;

bool at_most(double bound, const Exact& value) {
  return bound == -std::numeric_limits<double>::infinity() || (std::isfinite(bound) && Exact(bound) <= value);
}

bool at_least(double bound, const Exact& value) {
  return bound == std::numeric_limits<double>::infinity() || (std::isfinite(bound) && Exact(bound) >= value);
}

struct Case {
  Motion<1> motion;
  Vec<1> half;
  double epoch, later, now;

  Exact velocity(double time) const { return Exact(motion.v[0]) + motion.a[0] * elapsed(time); }
  Exact centre(const Exact& s) const {
    return Exact(motion.x[0]) + motion.v[0] * s + Exact(motion.a[0]) * s * s / 2;
  }
  Exact elapsed(double time) const { return Exact(time) - Exact(motion.t); }
};

Case random_case(Random& random) {
  const double sizes[] = {0, 5e-324, 1e-310, 1e-20, 1, 3, 1e9, 1e15, 1e100, 1.7e308};
  const bool tame = random.below(2) != 0;
  auto any = [&] { return tame ? random.in(-1e9, 1e9) : random.in(-1, 1) * sizes[random.below(10)]; };
  Case c{};
  c.motion.t = any(), c.motion.x[0] = any(), c.motion.v[0] = any(), c.motion.a[0] = any();
  c.motion.until = std::numeric_limits<double>::infinity();
  c.half[0] = std::abs(any()), c.epoch = any(), c.later = any(), c.now = any();
  return c;
}

void expect_outside(const Bounds<1>& bounds, const Case& c, double epoch) {
  const Exact centre = c.centre(c.elapsed(epoch)), velocity = c.velocity(epoch);
  EXPECT_TRUE(at_most(bounds.x_lower[0], centre - Exact(c.half[0])));
  EXPECT_TRUE(at_least(bounds.x_upper[0], centre + Exact(c.half[0])));
  EXPECT_TRUE(at_most(bounds.v_lower[0], velocity) && at_least(bounds.v_upper[0], velocity));
  EXPECT_TRUE(at_most(bounds.a_lower[0], c.motion.a[0]) && at_least(bounds.a_upper[0], c.motion.a[0]));
}

TEST(TreeBounds, ContainTheExactMotionAtEveryEpoch) {
  Random random(1);
  for (int i = 0; i < 500; ++i) {
    const Case c = random_case(random);
    const Bounds<1> bounds = bounds_at(c.motion, symmetric<1>(c.half), c.epoch);
    expect_outside(bounds, c, c.epoch);
    expect_outside(carried(bounds, c.epoch, c.later), c, c.later);
  }
}

void expect_outside(const MovingBox<1>& box, const Case& c, const Horizon& horizon, double margin) {
  for (double part : {0.0, 0.25, 0.5, 1.0}) {
    const Exact tau = Exact(horizon.h) * part, centre = c.centre(c.elapsed(c.now) + tau),
                reach = Exact(c.half[0]) + margin;
    EXPECT_TRUE(std::isinf(box.lower[0]) ||
                Exact(box.lower[0]) + Exact(box.v_lower[0]) * tau <= centre - reach);
    EXPECT_TRUE(std::isinf(box.upper[0]) ||
                Exact(box.upper[0]) + Exact(box.v_upper[0]) * tau >= centre + reach);
  }
}

TEST(TreeBounds, MovingBoxesContainTheExactMotion) {
  Random random(2);
  for (int i = 0; i < 500; ++i) {
    const Case c = random_case(random);
    const double h = std::abs(random.in(0, 1) * (random.below(2) ? 1e3 : 1e-300));
    const Horizon horizon{c.now, h};
    Motion<1> motion = c.motion;
    motion.t = std::min(motion.t, c.now);  // the object exists throughout
    const Bounds<1> at_epoch = bounds_at(motion, symmetric<1>(c.half), c.epoch);
    const Case moved{motion, c.half, c.epoch, c.later, c.now};
    expect_outside(moving_box<1>(at_epoch, c.epoch, {0, h}, horizon), moved, horizon, 0);
    expect_outside(moving_box<1>(motion, symmetric<1>(c.half), horizon, Vec<1>::constant(1)), moved, horizon,
                   1);
  }
}

/// Two points and a window of size 0, all at the same place at half the horizon.
template <int D>
void expect_to_meet(double speed, double other, double h) {
  const Horizon horizon{0, h};
  const Vec<D> none = Vec<D>::zero(), place = Vec<D>::constant(3), gone = Vec<D>::constant(other * (h / 2));
  const auto moving = [&](double v) {
    return moving_box<D>({h / 2, place, Vec<D>::constant(v), none, 1e300}, Extents<D>::none(), horizon, none);
  };
  const MovingBox<D> a = moving(speed), b = moving(other),
                     window = moving_window<D>(place - gone, place - gone, Vec<D>::constant(other), horizon);
  for (const MovingBox<D>& met : {b, window}) {
    SharedInterval span = shared_span(a, met), turned = span;
    EXPECT_TRUE(narrow_to_contact(a, met, span) && span.begin <= h / 2);
    EXPECT_TRUE(narrow_to_contact(met, a, turned) && turned.begin <= h / 2);
    EXPECT_EQ(min_distance(a, met, shared_span(a, met)), 0);
  }
}

TEST(TreeBounds, BoxesThatMeetAreSeparatedByNoSpeed) {
  for (double h : {0.0, 5e-324, 1e-300, 1e-20, 1.0, 1e300})
    for (double speed : {-1.7e308, -1e308, -1e300, 0.0, 1e299, 1e308, 1.7e308})
      for (double other : {-1.7e308, 0.0, 1.7e308}) {
        SCOPED_TRACE(::testing::Message() << h << ", " << speed << ", " << other);
        expect_to_meet<1>(speed, other, h);
        expect_to_meet<2>(speed, other, h);
        expect_to_meet<3>(speed, other, h);
      }
}

/// A tree narrows an interval again whose ends are already rounded.
TEST(TreeBounds, BoxesThatMeetBetweenTwoDoublesMeetStill) {
  constexpr double time = 5e-324, speed = 1e299;
  const Vec<1> none = Vec<1>::zero();
  const Horizon horizon{0, 40 * time};
  for (double part = 1.125; part < 40; part += 1.125) {
    const Vec<1> offset = Vec<1>::constant(speed * time * part), fast = Vec<1>::constant(speed);
    const MovingBox<1> a = moving_box<1>({0, none, fast, none, 1}, Extents<1>::none(), horizon, none),
                       b = moving_box<1>({0, offset, none, none, 1}, Extents<1>::none(), horizon, none);
    SharedInterval span = shared_span(a, b);
    EXPECT_TRUE(narrow_to_contact(a, b, span) && narrow_to_contact(a, b, span)) << part;
  }
}

TEST(TreeBounds, AreTightForEverydayNumbers) {
  const Motion<1> motion{0, Vec<1>::constant(100), Vec<1>::constant(2), Vec<1>::constant(0.5), 1e9};
  const Bounds<1> bounds = bounds_at(motion, symmetric<1>(Vec<1>::constant(1)), 10);
  EXPECT_NEAR(bounds.x_lower[0], 100 + 20 + 25 - 1, 1e-11);
  EXPECT_NEAR(bounds.v_upper[0], 7, 1e-12);
}

TEST(TreeBounds, SpansOfTheHorizonAreNeverTooShort) {
  Random random(3);
  for (int i = 0; i < 2000; ++i) {
    const Case c = random_case(random);
    const Horizon horizon{c.now, 1e12};
    const SharedInterval span = span_between(std::min(c.epoch, c.later), std::max(c.epoch, c.later), horizon);
    const Exact first = Exact(std::min(c.epoch, c.later)) - Exact(c.now),
                last = Exact(std::max(c.epoch, c.later)) - Exact(c.now);
    if (first > Exact(horizon.h) || last < 0) continue;
    EXPECT_TRUE(span.begin == 0 || Exact(span.begin) <= first);
    EXPECT_TRUE(span.end == horizon.h || Exact(span.end) >= last);
    EXPECT_FALSE(span.is_empty());
  }
}

}  // namespace
}  // namespace foresee
