#include <gtest/gtest.h>

#include <random>

#include "shape/outline/outline.h"
#include "shape/outline/outline_judge.h"

namespace foresee {
namespace {

void expect_exact(const Corner& a, const Corner& b, const Corner& c) {
  EXPECT_EQ(orientation(a, b, c), side_of(exact(a), exact(b), exact(c)));
}

TEST(Orientation, IsLeftRightOrOnTheLine) {
  EXPECT_EQ(orientation({0, 0}, {1, 0}, {0, 1}), 1);
  EXPECT_EQ(orientation({0, 0}, {1, 0}, {0, -1}), -1);
  EXPECT_EQ(orientation({0, 0}, {1, 1}, {7, 7}), 0);
}

TEST(Orientation, IsExactNearALine) {
  std::mt19937_64 random(51);
  std::uniform_real_distribution<double> coordinate(-100, 100), share(-1, 2);
  for (int i = 0; i < 3000; ++i) {
    const Corner a{coordinate(random), coordinate(random)}, b{coordinate(random), coordinate(random)};
    const double f = share(random);
    Corner c{a.x + f * (b.x - a.x), a.y + f * (b.y - a.y)};
    expect_exact(a, b, c);
    c.x = std::nextafter(c.x, 1000);
    expect_exact(a, b, c);
    expect_exact(c, a, b);
  }
}

TEST(Orientation, IsExactAmongWholeNumbers) {
  std::mt19937_64 random(52);
  const auto whole = [&] { return static_cast<double>(static_cast<int>(random() % 7) - 3) * 0x1.fffffep40; };
  for (int i = 0; i < 3000; ++i) expect_exact({whole(), whole()}, {whole(), whole()}, {whole(), whole()});
}

TEST(Orientation, IsExactWhereProductsOverflowAndVanish) {
  std::mt19937_64 random(53);
  const auto any = [&] {
    const int exponent = static_cast<int>(random() % 4) * 690 - 1073;
    return std::ldexp(static_cast<double>(random() % 9) - 4, std::min(exponent, 1021));
  };
  for (int i = 0; i < 3000; ++i) expect_exact({any(), any()}, {any(), any()}, {any(), any()});
}

TEST(Orientation, OfARingIsThatOfAllItsCorners) {
  EXPECT_EQ(convex_direction(std::vector<Corner>{{0, 0}, {2, 0}, {2, 2}, {0, 2}}), 1);
  EXPECT_EQ(convex_direction(std::vector<Corner>{{0, 0}, {0, 2}, {2, 2}, {2, 0}, {1, 0}}), -1);
  EXPECT_EQ(convex_direction(std::vector<Corner>{{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}}), 0);
  EXPECT_EQ(convex_direction(std::vector<Corner>{{0, 0}, {2, 0}, {1, 0}}), 0);
  EXPECT_EQ(convex_direction(std::vector<Corner>{{0, 0}, {2, 0}}), 0);
  // A pentagram turns left everywhere, and goes round twice.
  EXPECT_EQ(convex_direction(std::vector<Corner>{{0, 10}, {-6, -8}, {9, 3}, {-9, 3}, {6, -8}}), 0);
}

}  // namespace
}  // namespace foresee
