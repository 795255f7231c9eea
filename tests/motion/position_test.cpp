#include "motion/position.h"

#include <gtest/gtest.h>

namespace foresee {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

Motion<2> falling() {
  return {.t = 10, .x = {1, 2}, .v = {3, 4}, .a = {0, -2}, .until = 20};
}

TEST(Position, FollowsEquationOne) {
  const State<2> state = state_at(falling(), 13);
  EXPECT_EQ(state.x[0], 10);
  EXPECT_EQ(state.x[1], 5);
  EXPECT_EQ(state.v[0], 3);
  EXPECT_EQ(state.v[1], -2);
}

TEST(Position, ExistsDuringItsClosedSpan) {
  EXPECT_FALSE(exists_at(falling(), 9.999));
  EXPECT_TRUE(exists_at(falling(), 10));
  EXPECT_TRUE(exists_at(falling(), 20));
  EXPECT_FALSE(exists_at(falling(), std::nextafter(20, inf)));
}

TEST(Position, CarriesTheElapsedTimeExactly) {
  // 1e9 - 1e-9 needs more bits than a double has; the velocity brings the lost part to light.
  const Motion<1> fast{.t = 1e-9, .x = Vec<1>(-1e18), .v = Vec<1>(1e9), .a = Vec<1>(0.0), .until = inf};
  EXPECT_NEAR(state_at(fast, 1e9).x[0], -1, 1e-6);
}

TEST(Position, AtRestIsTheSameAtAnyTime) {
  const Motion<1> rock{.t = -1.7e308, .x = Vec<1>(5.0), .v = Vec<1>(0.0), .a = Vec<1>(0.0), .until = inf};
  EXPECT_EQ(state_at(rock, 1.7e308).x[0], 5);
}

TEST(Position, IsInfiniteOnlyWhereNoDoubleHoldsIt) {
  const auto at = [](double t, double x, double v, double a, double time) {
    return state_at(Motion<1>{.t = t, .x = Vec<1>(x), .v = Vec<1>(v), .a = Vec<1>(a), .until = inf}, time);
  };
  // v·s = 1e400 and a·s²/2 = -1e400 cancel; what is left is x.
  EXPECT_EQ(at(0, 7, 0x1p700, -0x1p-99, 0x1p800).x[0], 7);
  EXPECT_EQ(at(0, 0, 1e200, -1e200, 1e200).x[0], -inf);
  EXPECT_EQ(at(0, 0, -1e200, 1e200, 1e200).x[0], inf);
  EXPECT_EQ(at(0, 0, -1e200, 1e200, 1e200).v[0], inf);
  EXPECT_EQ(at(0, -1.5e308, 1, 0, 1.7e308).x[0], -1.5e308 + 1.7e308);
  EXPECT_EQ(at(0, -1.5e308, 2, 0, 1.5e308).x[0], 1.5e308);
  EXPECT_EQ(at(0, 0, -1.5e308, 1.5, 1.5e308).v[0], 0.5 * 1.5e308);
  // The time itself overflows.
  EXPECT_EQ(at(-0x1p1023, 0, 0.25, 0, 0x1p1023).x[0], 0x1p1022);
  EXPECT_EQ(at(-0x1p1023, 0, 0, 0x1p-1025, 0x1p1023).x[0], 0x1p1022);
}

}  // namespace
}  // namespace foresee
