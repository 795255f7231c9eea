#include "motion/vec.h"

#include <gtest/gtest.h>

#include <limits>
#include <type_traits>

namespace foresee {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                 infinity = std::numeric_limits<double>::infinity();

TEST(Vec, IsPlainNumbersInARow) {
  static_assert(std::is_trivially_copyable_v<Vec<3>> && std::is_trivially_default_constructible_v<Vec<3>>);
  static_assert(sizeof(Vec<1>) == 8 && sizeof(Vec<2>) == 16 && sizeof(Vec<3>) == 24);
  const double numbers[] = {9, 1, 2, 3};
  EXPECT_TRUE((Vec<3>::at(numbers + 1) == Vec<3>(1, 2, 3)).all());
  EXPECT_TRUE((vector_of<2>({4, 5, 6}) == Vec<2>(4, 5)).all());
  EXPECT_TRUE((Vec<3>(7, 8, 9).first<2>() == Vec<2>(7, 8)).all());
}

TEST(Vec, ArithmeticIsOfEachAxis) {
  const Vec<2> a(6, -8), b(2, 4);
  EXPECT_TRUE((a + b == Vec<2>(8, -4)).all() && (a - b == Vec<2>(4, -12)).all());
  EXPECT_TRUE((a * b == Vec<2>(12, -32)).all() && (a / b == Vec<2>(3, -2)).all());
  EXPECT_TRUE((a + 1 == Vec<2>(7, -7)).all() && (1 - a == Vec<2>(-5, 9)).all());
  EXPECT_TRUE((2 * a == Vec<2>(12, -16)).all() && (24 / a == Vec<2>(4, -3)).all() &&
              (-a == Vec<2>(-6, 8)).all());
  EXPECT_TRUE((a.abs() == Vec<2>(6, 8)).all() && (a.square() == Vec<2>(36, 64)).all());
  EXPECT_TRUE((Vec<3>(-7, 0, 7).sign() == Vec<3>(-1, 0, 1)).all());
  EXPECT_EQ(a.length(), 10);
}

TEST(Vec, SumsFromTheFirstAxis) {
  EXPECT_EQ(Vec<3>(1, 0x1p-53, 0x1p-53).sum(), 1);  // from the last it would be 1 + 2^-52
  EXPECT_EQ(Vec<3>(0x1p-53, 0x1p-53, 1).sum(), 1 + 0x1p-52);
  EXPECT_EQ(Vec<3>(0x1p-1000, 0x1p1000, 0x1p1000).product(), 0x1p1000);  // from the last: infinity
}

TEST(Vec, ComparisonsAreMasks) {
  const Vec<3> a(1, 2, nan), b(1, 3, 3);
  EXPECT_FALSE((a <= b).all());
  EXPECT_TRUE((a < b).any());
  EXPECT_TRUE((a == b)[0] && !(a == b)[1] && !(a == b)[2] && (a != b)[2]);
  EXPECT_TRUE(((a < b || a == b).select(a, -1) == Vec<3>(1, 2, -1)).all());
  EXPECT_TRUE((!(a < 2))[1] && (a < 2 && b < 2)[0]);
  EXPECT_TRUE(Vec<3>(1, infinity, nan).is_finite()[0]);
  EXPECT_FALSE(Vec<3>(1, infinity, nan).is_finite()[1] || Vec<3>(1, infinity, nan).is_finite()[2]);
}

TEST(Vec, ExtremesKeepTheFirstWhereNumbersDoNotCompare) {
  const Vec<2> a(nan, 1), b(1, nan);
  EXPECT_TRUE(std::isnan(a.max(b)[0]) && a.max(b)[1] == 1);
  EXPECT_TRUE(std::isnan(a.min(b)[0]) && a.min(b)[1] == 1);
  EXPECT_EQ(Vec<3>(2, 5, 5).largest(), 5);
  EXPECT_EQ(Vec<3>(2, 5, 5).largest_axis(), 1);
  EXPECT_TRUE((Vec<2>(-1, 1).max(0) == Vec<2>(0, 1)).all() && (Vec<2>(-1, 1).min(0) == Vec<2>(-1, 0)).all());
}

}  // namespace
}  // namespace foresee
