// closest_approach() against its oracle: t, dt and d are each the double nearest to the exact one, over the
// families of hard_pairs.h and motions made for ties.
//
// FORESEE_LONG=1 multiplies the number of cases by 50.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "contact/approach_oracle.h"
#include "contact/case_count.h"
#include "contact/hard_pairs.h"

namespace foresee {
namespace {

using namespace testing_by_hand;

void expect_exact(const Object& a, const Object& b, const Horizon& horizon, const char* family, int number) {
  const oracle::QueriedInterval queried = oracle::queried_interval(a, b, horizon);
  if (queried.begin > queried.end) return;
  const Case c{a, b, {.horizon = horizon}};
  const ClosestApproach answer = closest(a, b, c.question);
  const std::string complaint = oracle::judge_approach(a, b, horizon, answer);
  std::ostringstream story;
  if (!complaint.empty())
    story << c << "\n  answer dt " << answer.dt << " t " << answer.t << " d " << answer.d;
  ASSERT_EQ(complaint, "") << family << ", case " << number << "\n" << story.str();
  // Exchanging the two changes no bit.
  const ClosestApproach swapped = closest(b, a, c.question);
  ASSERT_TRUE(swapped.t == answer.t && swapped.dt == answer.dt && swapped.d == answer.d) << family;
}

void check_families(std::span<const Family> families, int axes, int cases) {
  std::uint64_t seed = 9000 + 100 * axes;
  for (const Family& family : families) {
    Generator generate(family, seed++);
    for (int i = 0; i < scaled_count(cases); ++i) {
      const Case c = make_case(generate, family, Shapes::points_within, axes);
      expect_exact(c.a, c.b, c.question.horizon, family.name, i);
      if (::testing::Test::HasFatalFailure()) return;
    }
  }
}

TEST(ClosestApproachOracle, InOneDimension) {
  check_families(ordinary_families(), 1, 80);
}
TEST(ClosestApproachOracle, InTwoDimensions) {
  check_families(ordinary_families(), 2, 80);
}
TEST(ClosestApproachOracle, InThreeDimensions) {
  check_families(ordinary_families(), 3, 80);
}
TEST(ClosestApproachOracle, OfExtremeNumbers) {
  for (int axes : {1, 2, 3}) check_families(extreme_families(), axes, 20);
}

/// Motions that are symmetric in time: two equal minima, or ends of equal distance, or a triple root of the
/// slope. Some are moved by a few units in the last place.
TEST(ClosestApproachOracle, OfMirroredMotions) {
  std::mt19937_64 random(5);
  auto whole = [&random](int limit) {
    return static_cast<double>(static_cast<int>(random() % (2 * limit + 1)) - limit) / 2;
  };
  for (int i = 0; i < scaled_count(1500); ++i) {
    const int axes = 1 + static_cast<int>(random() % 3);
    Object a = object(axes, Shape::point), b = object(axes, Shape::point);
    const double middle = std::abs(whole(8));
    for (int j = 0; j < axes; ++j) {
      const double bend = random() % 4 ? whole(4) : 0, apart = random() % 4 ? whole(16) : 0;
      a.x[j] = whole(4), b.x[j] = a.x[j] + apart + bend * middle * middle;
      b.v[j] = -2 * bend * middle, b.a[j] = 2 * bend;
    }
    double& moved = random() % 2 ? b.x[axes - 1] : b.v[0];
    if (moved != 0 && random() % 2) moved = std::nextafter(moved, random() % 2 ? 1e300 : -1e300);
    const Horizon horizon{0, random() % 2 ? 2 * middle : std::abs(whole(40))};
    expect_exact(a, b, horizon, "mirrored", i);
    if (HasFatalFailure()) return;
  }
}

TEST(ClosestApproachOracle, ObjectsToAnyOtherAnswer) {
  const Family& crowded = ordinary_families()[1];
  Generator generate(crowded, 3);
  for (int i = 0; i < 100; ++i) {
    const Case c = make_case(generate, crowded, Shapes::points_within, 2);
    const ClosestApproach right = closest(c.a, c.b, c.question);
    for (double ClosestApproach::*number : {&ClosestApproach::t, &ClosestApproach::dt, &ClosestApproach::d})
      for (double towards : {-1e9, 1e9}) {
        ClosestApproach wrong = right;
        wrong.*number = std::nextafter(wrong.*number, towards);
        EXPECT_NE(oracle::judge_approach(c.a, c.b, c.question.horizon, wrong), "");
      }
  }
}

}  // namespace
}  // namespace foresee
