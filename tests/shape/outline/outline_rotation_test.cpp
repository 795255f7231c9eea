// The judge has 300 bits: no double is nearer to the exact coordinate than that which the turn gives.
#include "shape/outline/outline_rotation.h"

#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <random>

#include "base/error.h"
#include "contact/case_count.h"
#include "shape/outline/wkt.h"

namespace foresee {
namespace {

using testing_by_hand::scaled_count;

using Wide = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<300, boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;

struct Judge {
  explicit Judge(double heading)
      : heading(heading),
        sine(sin(Wide(heading) * boost::math::constants::pi<Wide>() / 180)),
        cosine(cos(Wide(heading) * boost::math::constants::pi<Wide>() / 180)) {}

  void expect_nearest(const Corner& corner, const Corner& there) const {
    expect_nearest(Wide(corner.x) * cosine + Wide(corner.y) * sine, there.x, corner);
    expect_nearest(Wide(corner.y) * cosine - Wide(corner.x) * sine, there.y, corner);
  }
  void expect_nearest(const Wide& exact, double rounded, const Corner& corner) const {
    const Wide off = abs(exact - rounded);
    EXPECT_TRUE(off <= abs(exact - std::nextafter(rounded, HUGE_VAL)) &&
                off <= abs(exact - std::nextafter(rounded, -HUGE_VAL)))
        << shown(corner) << " turned by " << heading << " gives " << rounded << ", not " << exact;
    EXPECT_FALSE(rounded == 0 && std::signbit(rounded));
  }

  double heading;
  Wide sine, cosine;
};

void expect_correct(double heading, const std::vector<Corner>& corners) {
  const Judge judge(heading);
  Turn turn(heading);
  for (const Corner& corner : corners) judge.expect_nearest(corner, turn(corner));
}

std::vector<Corner> random_corners(std::mt19937_64& random, int count) {
  std::normal_distribution<double> normal(0, 100);
  std::vector<Corner> corners;
  for (int i = 0; i < count; ++i) corners.push_back({normal(random), normal(random)});
  return corners;
}

TEST(Turn, GoesClockwiseFromTheYAxis) {
  EXPECT_EQ(Turn(90)({0, 1}), (Corner{1, 0}));
  EXPECT_EQ(write_outline(turned(read_outline("POLYGON((-8 -90, 8 -90, 0 90, -8 -90))"), 90)),
            "POLYGON((-90 8, -90 -8, 90 0, -90 8))");
}

TEST(Turn, IsExactByRightAngles) {
  for (const int turns : {-4, -3, -2, -1, 0, 1, 2, 3, 4}) {
    const Corner there = Turn(90 * turns)({0x1.fffffffffffffp1023, 5e-324});
    const Corner expected[] = {{0x1.fffffffffffffp1023, 5e-324},
                               {5e-324, -0x1.fffffffffffffp1023},
                               {-0x1.fffffffffffffp1023, -5e-324},
                               {-5e-324, 0x1.fffffffffffffp1023}};
    EXPECT_EQ(there, expected[turns & 3]) << turns;
  }
}

TEST(Turn, IsExactWhereTheRealNumbersAreRational) {
  EXPECT_EQ(Turn(30)({0, 2}).x, 1);
  EXPECT_EQ(Turn(60)({2, 0}).x, 1);
  EXPECT_EQ(Turn(150)({0, -6}).x, -3);
  EXPECT_EQ(Turn(-30)({0, 5e-324}).x, 0);  // half of it: a tie, to even
  EXPECT_EQ(Turn(30)({0, 3 * 5e-324}).x, 1e-323);
  for (const double heading : {45.0, 135.0, 225.0, 315.0, -45.0}) {
    const Corner along = Turn(heading)({0.1, 0.1}), across = Turn(heading)({0.1, -0.1});
    EXPECT_EQ((along.x == 0) + (along.y == 0), 1) << heading;
    EXPECT_EQ((across.x == 0) + (across.y == 0), 1) << heading;
  }
}

TEST(Turn, IsNeverMinusZero) {
  for (int heading = -360; heading <= 360; heading += 15)
    for (const Corner& corner : {Corner{0, 0}, Corner{0, 1}, Corner{1, 0}, Corner{1, 1}, Corner{1, -1}}) {
      const Corner there = Turn(heading)(corner);
      EXPECT_FALSE(there.x == 0 && std::signbit(there.x)) << heading;
      EXPECT_FALSE(there.y == 0 && std::signbit(there.y)) << heading;
    }
}

TEST(Turn, IsRoundedOnceByAnyHeading) {
  std::mt19937_64 random(21);
  std::uniform_real_distribution<double> heading(-360, 360);
  for (int i = 0; i < scaled_count(1000); ++i) expect_correct(heading(random), random_corners(random, 100));
}

TEST(Turn, IsRoundedOnceByHardHeadings) {
  std::mt19937_64 random(22);
  std::vector<Corner> corners = random_corners(random, 10);
  corners.insert(corners.end(), {{0, 1}, {1, 0}, {1, 1}, {1, -1}, {3, 4}, {1e-30, 1e30}, {0x1p-1060, 1}});
  for (int h = -360; h <= 360; h += 15)
    for (const double heading : {double(h), std::nextafter(h, 500.0), std::nextafter(h, -500.0)})
      if (std::abs(heading) <= 360) expect_correct(heading, corners);
  corners.insert(corners.end(), {{0x1p890, 0}, {0, 0x1p890}});  // which a sine of few digits reaches
  for (const double heading : {5e-324, 1e-321, 1e-300, -1e-300, 1e-17, 1e-8, 90 + 1e-13})
    expect_correct(heading, corners);
}

TEST(Turn, IsRoundedOnceWhereTheSumCancels) {
  std::mt19937_64 random(23);
  std::uniform_real_distribution<double> heading(-360, 360), length(1, 1000);
  for (int i = 0; i < scaled_count(200); ++i) {
    const Judge judge(heading(random));
    Turn turn(judge.heading);
    const double y = length(random);
    const double x = static_cast<double>(-Wide(y) * judge.sine / judge.cosine);
    for (const Corner& corner : {Corner{x, y}, Corner{std::nextafter(x, HUGE_VAL), y}, Corner{y, -x}})
      judge.expect_nearest(corner, turn(corner));
  }
}

TEST(Turn, IsRoundedOnceAtAllScales) {
  std::mt19937_64 random(24);
  for (const int exponent : {-1070, -1030, -1000, -700, -300, 200, 700, 900, 1010})
    for (const double heading : {37.5, 30.0, 45.0, 200.25, 359.0}) {
      std::vector<Corner> corners = random_corners(random, 10);
      for (Corner& c : corners) c = {std::ldexp(c.x, exponent), std::ldexp(c.y, exponent)};
      expect_correct(heading, corners);
    }
}

TEST(Turn, BeyondTheLargestDoubleIsRefused) {
  try {
    turned(read_outline("POLYGON((0 0, 1.7e308 1.7e308, 0 1, 0 0))"), 45);
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(),
                 "turned by 45 degrees the corner (1.7e+308 1.7e+308) is beyond the largest double");
  }
}

TEST(Turn, DropsCornersThatBecomeOne) {
  const Outline outline = read_outline("POLYGON((0 0, 100 0, 100 1e-30, 0 100, 0 0))");
  EXPECT_EQ(outline.corners().size(), 4u);
  EXPECT_EQ(turned(outline, 20).corners().size(), 3u);
}

}  // namespace
}  // namespace foresee
