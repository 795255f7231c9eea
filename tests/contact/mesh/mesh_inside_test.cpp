// What is easy to get wrong about the inside of solids, and about surfaces, which have none.
#include <gtest/gtest.h>

#include "contact/mesh/meshes_by_hand.h"

namespace foresee {
namespace {

using namespace testing_by_hand;

/// A hollow cube from -4 to 4 whose walls are one thick.
const Mesh room =
    solid_of(together({box_between({-5, -5, -5}, {5, 5, 5}), box_between({-4, -4, -4}, {4, 4, 4})}));
/// Two walls, from 0 to 1 and from 3 to 4.
const Mesh walls =
    solid_of(together({box_between({0, -9, -9}, {1, 9, 9}), box_between({3, -9, -9}, {4, 9, 9})}));
/// A hole of two by two, along z.
const Mesh ring = solid_of(frame(1, 3, -1, 1));

TEST(MeshInside, WhatIsInsideTouchesWithoutMeetingTheSurface) {
  const Mesh hall = solid_of(box_between({-5, -5, -5}, {5, 5, 5}));
  expect_contact(within_ten(hall, moving_cube({1, 1, 1}, {0, 0, 0})), 0, 10);
  expect_contact(within_ten(moving_cube({1, 1, 1}, {0, 0, 0}), resting(hall)), 0, 10);
  expect_contact(within_ten(hall, moving_point({1, 1, 1}, {2, 0, 0})), 0, 2);
  expect_contact(within_ten(hall, moving_box({1, 0, 0}, {1, 1, 1}, {2, 0, 0})), 0, 2.5);
  // A mesh within a box, which is a solid too.
  expect_contact(within_ten(unit_cube, moving_box({4, 4, 4}, {0, 0, 0}, {0, 0, 1})), 0, 5);
}

TEST(MeshInside, ASurfaceHasNoInside) {
  const Mesh skin = surface_of(box_between({-5, -5, -5}, {5, 5, 5}));
  EXPECT_FALSE(within_ten(skin, moving_point({0, 0, 0}, {0.25, 0, 0})));
  expect_contact(within_ten(skin, moving_point({0, 0, 0}, {1, 0, 0})), 5, 5);
  expect_contact(within_ten(skin, moving_cube({0, 0, 0}, {1, 0, 0})), 4, 5);
  expect_contact(within_ten(resting(unit_cube), moving(resting(skin), {0, 0, 0}, {1, 0, 0})), 5, 6);
}

TEST(MeshInside, WhatIsBelowTheGroundDoesNotTouchIt) {
  EXPECT_FALSE(within_ten(ground, moving_point({0, 1, -5}, {1, 0, 0})));
  EXPECT_FALSE(within_ten(ground, moving_cube({0, 0, before(-1)}, {1, 0, 0})));
  expect_contact(within_ten(ground, moving_cube({0, 0, -1}, {1, 0, 0})), 0, 10);
  expect_contact(within_ten(ground, moving_cube({0, 0, -5}, {0, 0, 1})), 4, 5);
}

TEST(MeshInside, WhatIsInARoomTouchesNothingUntilItReachesAWall) {
  expect_contact(within_ten(room, moving_cube({0, 0, 0}, {1, 0, 0})), 3, 5);
  EXPECT_FALSE(within_ten(room, moving_cube({0, 0, 0}, {0.25, 0, 0})));
  expect_contact(within_ten(room, moving_point({0, 0, 0}, {1, 1, 0.5})), 4, 5);
  EXPECT_FALSE(within_ten(room, moving_ball(3, {0, 0, 0}, {0, 0, 0})));
  expect_contact(within_ten(room, moving_ball(3, {0, 0, 0}, {0.125, 0, 0})), 8, 10);
}

TEST(MeshInside, WhatFillsARoomTouchesItsWalls) {
  expect_contact(within_ten(room, moving_box({4, 4, 4}, {0, 0, 0}, {0, 0, 0})), 0, 10);
  expect_contact(within_ten(room, moving_box({4, 1, 1}, {0, 0, 0}, {0, 0.25, 0})), 0, 10);
  const double less = before(4);
  EXPECT_FALSE(within_ten(room, moving_box({less, less, less}, {0, 0, 0}, {0, 0, 0})));
  EXPECT_FALSE(within_ten(room, moving_ball(less, {0, 0, 0}, {0, 0, 0})));
  expect_contact(within_ten(room, moving_ball(4, {0, 0, 0}, {0, 0, 0})), 0, 10);
}

TEST(MeshInside, WhatIsInARoomWithinARoomMeetsThatFirst) {
  const Mesh nested =
      solid_of(together({box_between({-9, -9, -9}, {9, 9, 9}), box_between({-8, -8, -8}, {8, 8, 8}),
                         box_between({-2, -2, -2}, {2, 2, 2})}));
  expect_contact(within_ten(nested, moving_point({0, 0, 0}, {1, 0, 0})), 0, 2);
  expect_contact(within_ten(nested, moving_point({3, 0, 0}, {1, 0, 0})), 5, 6);
  EXPECT_FALSE(within_ten(nested, moving_cube({3, 3, 3}, {0.25, 0, 0})));
}

TEST(MeshInside, ContactEndsWithTheFirstWallAndStartsAgain) {
  expect_contact(within_ten(walls, moving_point({-1, 0, 0}, {1, 0, 0})), 1, 2);
  expect_contact(within_ten(walls, moving_point({2, 0, 0}, {1, 0, 0})), 1, 2);
  expect_contact(within_ten(walls, moving_box({0.5, 0.5, 0.5}, {-1, 0, 0}, {1, 0, 0})), 0.5, 2.5);
  // Between the walls there is just room, or none.
  expect_contact(within_ten(walls, moving_box({before(1), 1, 1}, {-2, 0, 0}, {1, 0, 0})), 1, 4);
  expect_contact(within_ten(walls, moving_box({1, 1, 1}, {-2, 0, 0}, {1, 0, 0})), 1, 7);
}

TEST(MeshInside, OneFliesThroughAHole) {
  EXPECT_FALSE(within_ten(ring, moving_point({0, 0, -5}, {0, 0, 1})));
  expect_contact(within_ten(ring, moving_point({1, 0, -5}, {0, 0, 1})), 4, 6);
  EXPECT_FALSE(within_ten(ring, moving_point({before(1), 0, -5}, {0, 0, 1})));
  EXPECT_FALSE(within_ten(ring, moving_box({0.5, 0.5, 0.5}, {0.25, 0, -5}, {0, 0, 1})));
  expect_contact(within_ten(ring, moving_box({0.5, 0.5, 0.5}, {0.5, 0, -5}, {0, 0, 1})), 3.5, 6.5);
  EXPECT_FALSE(within_ten(ring, moving_ball(before(1), {0, 0, -5}, {0, 0, 1})));
  expect_contact(within_ten(ring, moving_ball(1, {0, 0, -5}, {0, 0, 1})), 4, 6);
  // Through both sides of the frame.
  expect_contact(within_ten(ring, moving_point({-4, 0, 0}, {1, 0, 0})), 1, 3);
}

TEST(MeshInside, WhereTwoPartsCrossThereIsNothing) {
  const Mesh parts =
      solid_of(together({box_between({0, 0, 0}, {4, 4, 4}), box_between({2, 1, 1}, {6, 3, 3})}));
  expect_contact(within_ten(parts, moving_point({-1, 2, 2}, {1, 0, 0})), 1, 3);
  expect_contact(within_ten(parts, moving_point({2.5, 2, 2}, {0.5, 0, 0})), 3, 7);
  EXPECT_FALSE(within_ten(parts, moving_box({0.5, 0.5, 0.5}, {3, 2, 2}, {0, 0, 0})));
}

TEST(MeshInside, ASolidOfTwoSidesOfOneTriangleIsThatTriangle) {
  const std::array<SpaceCorner, 3> side{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};
  const Mesh sheet = solid_of({side, side});
  ASSERT_TRUE(sheet.is_solid());
  expect_contact(within_ten(sheet, moving_point({1, 1, -3}, {0, 0, 1})), 3, 3);
  EXPECT_FALSE(within_ten(sheet, moving_point({3, 3, -3}, {0, 0, 1})));
  expect_contact(within_ten(sheet, moving_cube({1, 1, -3}, {0, 0, 1})), 2, 3);
}

}  // namespace
}  // namespace foresee
