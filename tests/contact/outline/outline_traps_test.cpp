// What is easy to get wrong about outlines, one by one, by cases whose answer is known.
#include <gtest/gtest.h>

#include "contact/outline/outline_scenes.h"

namespace foresee {
namespace {

using namespace testing_by_hand;

const Ring unit_square{0, 0, 1, 0, 1, 1, 0, 1};
/// 4 high; two teeth of width 1, 2 high, at both ends of a bar of length 4.
const Ring comb{0, 0, 4, 0, 4, 4, 3, 4, 3, 2, 1, 2, 1, 4, 0, 4};
/// Ten long and high, with a hole from 2 to 8.
const std::vector<Ring> frame{{0, 0, 10, 0, 10, 10, 0, 10}, {2, 2, 8, 2, 8, 8, 2, 8}};

/// At rest at the origin unless moved.
OutlinedObject resting(const std::vector<Ring>& rings) {
  OutlinedObject o{object(2, Shape::point), {}};
  o.row.layout.law = Law::uniform;
  if (!rings.empty()) o.outline = outline_of({rings});
  return o;
}

OutlinedObject moving(const std::vector<Ring>& rings, Corner place, Corner velocity) {
  OutlinedObject o = resting(rings);
  o.row.x[0] = place.x, o.row.x[1] = place.y;
  o.row.v[0] = velocity.x, o.row.v[1] = velocity.y;
  return o;
}

OutlinedObject moving_point(Corner place, Corner velocity) {
  return moving({}, place, velocity);
}

std::optional<ContactTimes> within_ten(const OutlinedObject& a, const OutlinedObject& b, double within = 0) {
  return outline_contact({a, b, {.horizon = {.now = 0, .h = 10}, .within = within}});
}

void expect_contact(const std::optional<ContactTimes>& found, double t, double t_end) {
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->t, t);
  EXPECT_EQ(found->t_end, t_end);
}

TEST(OutlineTraps, EdgesThatSlideAlongEachOtherTouchThroughout) {
  const auto above = [](double y) { return moving({unit_square}, {-3, y}, {1, 0}); };
  expect_contact(within_ten(resting({unit_square}), above(1)), 2, 4);
  EXPECT_FALSE(within_ten(resting({unit_square}), above(std::nextafter(1, 2))));
}

TEST(OutlineTraps, CornersThatMeetTouchForAMoment) {
  expect_contact(within_ten(resting({unit_square}), moving({unit_square}, {3, -3}, {-1, 1})), 2, 4);
  expect_contact(within_ten(resting({unit_square}), moving({unit_square}, {-1, 3}, {1, -1})), 2, 2);
}

TEST(OutlineTraps, WithoutRelativeMotionTheyTouchAlwaysOrNever) {
  expect_contact(within_ten(resting({unit_square}), moving({unit_square}, {1, 1}, {0, 0})), 0, 10);
  EXPECT_FALSE(within_ten(resting({unit_square}), moving({unit_square}, {std::nextafter(1, 2), 1}, {0, 0})));
}

TEST(OutlineTraps, WhatIsInAHoleTouchesNothingUntilItReachesTheRing) {
  expect_contact(within_ten(resting(frame), moving({unit_square}, {4, 4}, {1, 0})), 3, 6);
  EXPECT_FALSE(within_ten(resting(frame), moving({unit_square}, {4, 4}, {0.25, 0})));
}

TEST(OutlineTraps, WhatFillsAHoleTouchesAtOnce) {
  expect_contact(within_ten(resting(frame), moving({{0, 0, 6, 0, 6, 6, 0, 6}}, {2, 2}, {0, 0})), 0, 10);
}

TEST(OutlineTraps, WhatIsInsideTouchesWithoutMeetingTheBoundary) {
  expect_contact(within_ten(resting({frame[0]}), moving({unit_square}, {4, 4}, {0, 0})), 0, 10);
  expect_contact(within_ten(moving({unit_square}, {4, 4}, {0, 0}), resting({frame[0]})), 0, 10);
}

TEST(OutlineTraps, ContactEndsWithTheFirstToothAndStartsAgain) {
  expect_contact(within_ten(resting({comb}), moving({unit_square}, {-3, 3}, {1, 0})), 2, 4);
  expect_contact(within_ten(resting({comb}), moving({unit_square}, {-3, 2}, {1, 0})), 2, 7);
}

TEST(OutlineTraps, APointGoesThroughCutsAsIfThereWereNone) {
  expect_contact(within_ten(resting({comb}), moving_point({-1, 1}, {1, 0})), 1, 5);
  expect_contact(within_ten(resting({comb}), moving_point({-1, 1.25}, {1, 0.125})), 1, 5);
  // Along a cut, through a reflex corner, and through a corner at which it leaves.
  expect_contact(within_ten(resting({comb}), moving_point({-1, 2}, {1, 0})), 1, 5);
  expect_contact(within_ten(resting({comb}), moving_point({-1, 4}, {1, -1})), 1, 4);
  expect_contact(within_ten(resting({comb}), moving_point({-1, 2}, {1, 1})), 1, 2);
}

TEST(OutlineTraps, APointBesideAReflexCornerIsOutForLessThanAnUlp) {
  const Ring notched{-2, -2, 2, -2, 2, 1, 0, 0, -2, 1};
  for (const double side : {-1, 1}) {
    const auto passing = [side](double y) { return moving_point({-3 * side, y}, {side, 0}); };
    expect_contact(within_ten(resting({notched}), passing(0x1p-60)), 1, 3);
    expect_contact(within_ten(resting({notched}), passing(0)), 1, 5);
    expect_contact(within_ten(resting({notched}), passing(-0x1p-60)), 1, 5);
  }
}

TEST(OutlineTraps, AMissByAnUlpIsNotTheFirstContact) {
  // Up from just above the lower of two squares, just into the upper, and down again onto the lower.
  OutlinedObject squares{object(2, Shape::point), outline_of({{unit_square}, {{0, 2, 1, 2, 1, 3, 0, 3}}})};
  OutlinedObject point{object(2, Shape::point), {}};
  point.row.x[0] = 0.5, point.row.x[1] = std::nextafter(1, 2);
  point.row.v[1] = 1, point.row.a[1] = -0.5;
  expect_contact(within_ten(squares, point), 2 - 0x1p-25, 2 + 0x1p-25);
}

TEST(OutlineTraps, ATouchAtTheEndOfTheQueriedTimeCounts) {
  expect_contact(within_ten(resting({unit_square}), moving_point({11, 0.5}, {-1, 0})), 10, 10);
  EXPECT_FALSE(within_ten(resting({unit_square}), moving_point({std::nextafter(11, 12), 0.5}, {-1, 0})));
  expect_contact(within_ten(resting({unit_square}), moving_point({1, 0.5}, {1, 0})), 0, 0);
}

TEST(OutlineTraps, ATouchAtTheEndOfALifeCounts) {
  OutlinedObject point = moving_point({6, 0.5}, {-1, 0});
  point.row.until = 5;
  expect_contact(within_ten(resting({unit_square}), point), 5, 5);
  point.row.until = std::nextafter(5, 0);
  EXPECT_FALSE(within_ten(resting({unit_square}), point));
}

TEST(OutlineTraps, AnInstantIsQueried) {
  const auto now = [](double x) {
    return outline_contact({resting({unit_square}), moving_point({x, 0}, {1, 1}), {.horizon = {0, 0}}});
  };
  expect_contact(now(1), 0, 0);
  EXPECT_FALSE(now(std::nextafter(1, 2)));
}

TEST(OutlineTraps, ADistanceIsReachedExactly) {
  // Of five, from a corner, along three and four; it is passed by at a right angle.
  const OutlinedObject point = moving_point({1 + 3 - 4, 1 + 4 + 3}, {1, -0.75});
  expect_contact(within_ten(resting({unit_square}), point, 5), 4, 4);
  EXPECT_FALSE(within_ten(resting({unit_square}), point, std::nextafter(5, 0)));
}

TEST(OutlineTraps, AnEdgeWhoseSquaredLengthVanishesGrowsAsFarAsOthers) {
  const Ring wedge{-1, -5, 0, 0, -1, 5}, blunt{-1, -5, 0, 0, -1e-161, 1e-160, -1, 5};
  for (const double side : {-10, 10}) {
    const OutlinedObject point = moving_point({side < 0 ? 60.0 : 1.0, 5}, {side, 0});
    const auto found = within_ten(resting({wedge}), point, 50);
    ASSERT_TRUE(found.has_value());
    expect_contact(within_ten(resting({blunt}), point, 50), found->t, found->t_end);
  }
}

TEST(OutlineTraps, FarFromTheOriginNothingIsLost) {
  OutlinedObject a = moving({frame[0]}, {1e7, -1e7}, {0, 0});
  OutlinedObject b = moving({frame[0]}, {1e7 + 12, -1e7 + 10}, {-1, 0});
  expect_contact(within_ten(a, b), 2, 10);
  b.row.x[1] = std::nextafter(b.row.x[1], 0);
  EXPECT_FALSE(within_ten(a, b));
}

TEST(OutlineTraps, NothingAndADiscMeetAnOutlineAlike) {
  OutlinedObject disc = moving_point({-4, 3}, {1, 0});
  disc.row.layout.shape = Shape::ball;
  disc.row.r = 2;
  expect_contact(within_ten(resting({unit_square}), disc), 4, 5);
  disc.row.r = 0;
  EXPECT_FALSE(within_ten(resting({unit_square}), disc));
}

}  // namespace
}  // namespace foresee
