// The filter of outlines in plain doubles decides only what is far from doubtful.
#include "contact/outline/outline_filter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace foresee {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr BoxedPair only_pair[] = {{0, 0, true}};

/// The filter's answer for two squares, ten wide, of which b moves.
FilterAnswer squares(const Corner& from, const Corner& to, double radius, double bend = 0,
                     bool times_wanted = true) {
  ObjectPieces a, b;
  a.take_box(5, 5), b.take_box(5, 5);
  return filter_outlines({from, to, 0x1p-40, bend}, a, b, only_pair, Bounded{radius}, times_wanted);
}

TEST(OutlineFilter, DecidesTwoAtRest) {
  for (const double x : {-3.0, 0.0, 7.5, 14.0}) {
    const FilterAnswer near = squares({x, 9}, {x, 9}, 5);
    EXPECT_EQ(near.touches, Verdict::yes) << x;
    EXPECT_TRUE(near.at_start && near.all_along) << x;
  }
  EXPECT_EQ(squares({14, 14}, {14, 14}, 5).touches, Verdict::no) << "corner from corner";
  EXPECT_EQ(squares({15.5, 0}, {15.5, 0}, 5).touches, Verdict::no);
  EXPECT_TRUE(squares({1, 2}, {1, 2}, 0).all_along) << "one upon the other";
}

TEST(OutlineFilter, LeavesTouchesOpen) {
  EXPECT_EQ(squares({15, 0}, {15, 0}, 5).touches, Verdict::uncertain);
  EXPECT_EQ(squares({13, 14}, {13, 14}, 5).touches, Verdict::uncertain) << "three and four away";
  EXPECT_EQ(squares({10, 3}, {10, 3}, 0).touches, Verdict::uncertain);
  EXPECT_EQ(squares({-30, 10}, {30, 10}, 0).touches, Verdict::uncertain) << "along a side";
}

TEST(OutlineFilter, DecidesThoseThatMove) {
  EXPECT_EQ(squares({-30, 16}, {30, 16}, 5).touches, Verdict::no);
  EXPECT_EQ(squares({-30, 30}, {0, 16}, 5).touches, Verdict::no);
  const FilterAnswer through = squares({-30, 3}, {30, 3}, 5);
  EXPECT_EQ(through.touches, Verdict::yes);
  EXPECT_FALSE(through.at_start);
  const FilterAnswer leaving = squares({12, 0}, {30, 0}, 5);
  EXPECT_TRUE(leaving.at_start);
  EXPECT_FALSE(leaving.all_along);
  EXPECT_TRUE(squares({12, 0}, {-12, 1}, 5).all_along) << "near at both ends of a line";
}

TEST(OutlineFilter, LeavesRoomForWhatIsBesideTheChord) {
  EXPECT_EQ(squares({-30, 18}, {30, 18}, 5, 2).touches, Verdict::no);
  EXPECT_EQ(squares({-30, 18}, {30, 18}, 5, 4).touches, Verdict::uncertain);
  EXPECT_EQ(squares({-30, 13}, {30, 13}, 5, 1).touches, Verdict::yes);
  EXPECT_EQ(squares({-30, 13}, {30, 13}, 5, 3).touches, Verdict::uncertain);
  const FilterAnswer swings = squares({12, 0}, {12, 1}, 5, 4);
  EXPECT_TRUE(swings.at_start);
  EXPECT_FALSE(swings.all_along);
}

TEST(OutlineFilter, DecidesNothingBeyondTheRangeOfDoubles) {
  const double large = std::numeric_limits<double>::max();
  for (const double far : {large, inf, -inf, std::nan("")}) {
    EXPECT_EQ(squares({far, 0}, {far, 0}, 5).touches, Verdict::uncertain);
    EXPECT_EQ(squares({0, far}, {1, far}, 5).touches, Verdict::uncertain);
    EXPECT_FALSE(squares({0, 0}, {far, 0}, 5).all_along);
  }
  ObjectPieces a, b;
  a.take_box(5, 5), b.take_box(5, 5);
  EXPECT_EQ(filter_outlines({{30, 0}, {40, 0}, 0, 0}, a, b, only_pair, Bounded{inf, inf}, true).touches,
            Verdict::uncertain);
  for (const double scale : {0x1p-600, 0x1p600}) {
    a.take_box(scale, scale);
    b.take_box(scale, scale);
    for (const double x : {1.0, 3.0})
      EXPECT_EQ(filter_outlines({{x * scale, 0}, {x * scale, 0}, 0, 0}, a, b, only_pair, Bounded{0.0}, true)
                    .touches,
                Verdict::uncertain);
  }
}

}  // namespace
}  // namespace foresee
