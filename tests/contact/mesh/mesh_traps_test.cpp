// What is easy to get wrong about meshes, one by one, by cases whose answer is known.
#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>

#include "contact/mesh/mesh_scenes.h"

namespace foresee::contact {
namespace {

using namespace testing_by_hand;

const Mesh unit_cube = solid_of(box_between({0, 0, 0}, {1, 1, 1}));
/// A room from -4 to 4 whose walls are one thick.
const Mesh room =
    solid_of(together({box_between({-5, -5, -5}, {5, 5, 5}), box_between({-4, -4, -4}, {4, 4, 4})}));
/// Two walls, from 0 to 1 and from 3 to 4.
const Mesh walls =
    solid_of(together({box_between({0, -9, -9}, {1, 9, 9}), box_between({3, -9, -9}, {4, 9, 9})}));
/// A hole of two by two, along z.
const Mesh ring = solid_of(frame(1, 3, -1, 1));
/// Level ground at 0.
const Mesh ground =
    surface_of({{{{-10, -10, 0}, {10, -10, 0}, {10, 10, 0}}}, {{{-10, -10, 0}, {10, 10, 0}, {-10, 10, 0}}}});

double after(double x) {
  return std::nextafter(x, HUGE_VAL);
}
double before(double x) {
  return std::nextafter(x, -HUGE_VAL);
}

MeshObject moving_cube(const SpaceCorner& place, const SpaceCorner& velocity) {
  return moving(resting(unit_cube), place, velocity);
}
MeshObject moving_point(const SpaceCorner& place, const SpaceCorner& velocity) {
  return moving(box_object({0, 0, 0}), place, velocity);
}
MeshObject moving_box(const SpaceCorner& half, const SpaceCorner& place, const SpaceCorner& velocity) {
  return moving(box_object(half), place, velocity);
}
MeshObject moving_ball(double r, const SpaceCorner& place, const SpaceCorner& velocity) {
  return moving(ball_object(r, false), place, velocity);
}

std::optional<ContactTimes> within_ten(const MeshObject& a, const MeshObject& b, double within = 0) {
  return mesh_contact({a, b, {.horizon = {.now = 0, .h = 10}, .within = within}});
}
std::optional<ContactTimes> within_ten(const Mesh& a, const MeshObject& b, double within = 0) {
  return within_ten(resting(a), b, within);
}

void expect_contact(const std::optional<ContactTimes>& found, double t, double t_end) {
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->t, t);
  EXPECT_EQ(found->t_end, t_end);
}

TEST(MeshTraps, FacesThatSlideOnEachOtherTouchAllTheWay) {
  const auto above = [](double z) { return moving_cube({-3, 0.25, z}, {1, 0, 0}); };
  expect_contact(within_ten(unit_cube, above(1)), 2, 4);
  EXPECT_FALSE(within_ten(unit_cube, above(after(1))));
  // The same face on the same face, and across it.
  expect_contact(within_ten(unit_cube, moving_cube({0, 0, -1}, {0, 0.5, 0})), 0, 2);
  expect_contact(within_ten(unit_cube, moving_cube({-2, -2, 1}, {0.5, 0.5, 0})), 2, 6);
}

TEST(MeshTraps, EdgesThatSlideAlongEachOtherTouchAllTheWay) {
  const auto beside = [](double y) { return moving_cube({-3, y, 1}, {1, 0, 0}); };
  expect_contact(within_ten(unit_cube, beside(1)), 2, 4);
  expect_contact(within_ten(unit_cube, beside(-1)), 2, 4);
  EXPECT_FALSE(within_ten(unit_cube, beside(after(1))));
}

TEST(MeshTraps, CornersThatMeetTouchForAMoment) {
  expect_contact(within_ten(unit_cube, moving_cube({-1, 3, 3}, {1, -1, -1})), 2, 2);
  expect_contact(within_ten(unit_cube, moving_cube({-1, 3, 1}, {1, -1, 0})), 2, 2);
  expect_contact(within_ten(unit_cube, moving_point({-1, 3, 2}, {1, -1, -0.5})), 2, 2);
  EXPECT_FALSE(within_ten(unit_cube, moving_point({-1, after(3), 2}, {1, -1, -0.5})));
}

TEST(MeshTraps, EdgesThatCrossTouch) {
  // An edge on top, along x, and one at the bottom, along y.
  const Mesh roof = surface_of({{{{-1, 0, 0}, {1, 0, 0}, {0, 0, -1}}}});
  const Mesh keel = surface_of({{{{0, -1, 0}, {0, 1, 0}, {0, 0, 1}}}});
  const auto passing = [&](double z) { return moving(resting(keel), {-3, 0.25, z}, {1, 0, 0}); };
  expect_contact(within_ten(roof, passing(0)), 2, 4);
  EXPECT_FALSE(within_ten(roof, passing(0x1p-1074)));
  expect_contact(within_ten(roof, moving(resting(keel), {-3, -3, 3}, {1, 1, -1})), 3, 11.0 / 3);
  expect_contact(within_ten(roof, moving(resting(keel), {-3, -3, -3}, {1, 1, 1})), 7.0 / 3, 3);
}

TEST(MeshTraps, WithoutRelativeMotionTheyTouchAlwaysOrNever) {
  expect_contact(within_ten(unit_cube, moving_cube({1, 1, 1}, {0, 0, 0})), 0, 10);
  expect_contact(within_ten(unit_cube, moving_cube({0, 0, 1}, {0, 0, 0})), 0, 10);
  expect_contact(within_ten(unit_cube, moving_cube({0, 0, 0}, {0, 0, 0})), 0, 10);
  EXPECT_FALSE(within_ten(unit_cube, moving_cube({after(1), 1, 1}, {0, 0, 0})));
  EXPECT_FALSE(within_ten(unit_cube, moving_cube({0, 0, before(-1)}, {0, 0, 0})));
}

TEST(MeshTraps, TrianglesThatCrossAtRestTouchAlways) {
  // No corner is on a face, and no edges meet.
  const Mesh upright = surface_of({{{{-3, 0, -1}, {3, 0, -1}, {0, 0, 5}}}});
  expect_contact(within_ten(ground, resting(upright)), 0, 10);
  EXPECT_FALSE(within_ten(ground, moving(resting(upright), {0, 0, after(1)}, {0, 0, 0})));
}

TEST(MeshTraps, WhatIsInsideTouchesWithoutMeetingTheSurface) {
  const Mesh hall = solid_of(box_between({-5, -5, -5}, {5, 5, 5}));
  expect_contact(within_ten(hall, moving_cube({1, 1, 1}, {0, 0, 0})), 0, 10);
  expect_contact(within_ten(moving_cube({1, 1, 1}, {0, 0, 0}), resting(hall)), 0, 10);
  expect_contact(within_ten(hall, moving_point({1, 1, 1}, {2, 0, 0})), 0, 2);
  expect_contact(within_ten(hall, moving_box({1, 0, 0}, {1, 1, 1}, {2, 0, 0})), 0, 2.5);
  // A mesh within a box, which is a solid too.
  expect_contact(within_ten(unit_cube, moving_box({4, 4, 4}, {0, 0, 0}, {0, 0, 1})), 0, 5);
}

TEST(MeshTraps, ASurfaceHasNoInside) {
  const Mesh skin = surface_of(box_between({-5, -5, -5}, {5, 5, 5}));
  EXPECT_FALSE(within_ten(skin, moving_point({0, 0, 0}, {0.25, 0, 0})));
  expect_contact(within_ten(skin, moving_point({0, 0, 0}, {1, 0, 0})), 5, 5);
  expect_contact(within_ten(skin, moving_cube({0, 0, 0}, {1, 0, 0})), 4, 5);
  expect_contact(within_ten(resting(unit_cube), moving(resting(skin), {0, 0, 0}, {1, 0, 0})), 5, 6);
}

TEST(MeshTraps, WhatIsBelowTheGroundDoesNotTouchIt) {
  EXPECT_FALSE(within_ten(ground, moving_point({0, 1, -5}, {1, 0, 0})));
  EXPECT_FALSE(within_ten(ground, moving_cube({0, 0, before(-1)}, {1, 0, 0})));
  expect_contact(within_ten(ground, moving_cube({0, 0, -1}, {1, 0, 0})), 0, 10);
  expect_contact(within_ten(ground, moving_cube({0, 0, -5}, {0, 0, 1})), 4, 5);
}

TEST(MeshTraps, WhatIsInARoomTouchesNothingUntilItReachesAWall) {
  expect_contact(within_ten(room, moving_cube({0, 0, 0}, {1, 0, 0})), 3, 5);
  EXPECT_FALSE(within_ten(room, moving_cube({0, 0, 0}, {0.25, 0, 0})));
  expect_contact(within_ten(room, moving_point({0, 0, 0}, {1, 1, 0.5})), 4, 5);
  EXPECT_FALSE(within_ten(room, moving_ball(3, {0, 0, 0}, {0, 0, 0})));
  expect_contact(within_ten(room, moving_ball(3, {0, 0, 0}, {0.125, 0, 0})), 8, 10);
}

TEST(MeshTraps, WhatFillsARoomTouchesItsWalls) {
  expect_contact(within_ten(room, moving_box({4, 4, 4}, {0, 0, 0}, {0, 0, 0})), 0, 10);
  expect_contact(within_ten(room, moving_box({4, 1, 1}, {0, 0, 0}, {0, 0.25, 0})), 0, 10);
  const double less = before(4);
  EXPECT_FALSE(within_ten(room, moving_box({less, less, less}, {0, 0, 0}, {0, 0, 0})));
  EXPECT_FALSE(within_ten(room, moving_ball(less, {0, 0, 0}, {0, 0, 0})));
  expect_contact(within_ten(room, moving_ball(4, {0, 0, 0}, {0, 0, 0})), 0, 10);
}

TEST(MeshTraps, WhatIsInARoomWithinARoomMeetsThatFirst) {
  const Mesh nested =
      solid_of(together({box_between({-9, -9, -9}, {9, 9, 9}), box_between({-8, -8, -8}, {8, 8, 8}),
                         box_between({-2, -2, -2}, {2, 2, 2})}));
  expect_contact(within_ten(nested, moving_point({0, 0, 0}, {1, 0, 0})), 0, 2);
  expect_contact(within_ten(nested, moving_point({3, 0, 0}, {1, 0, 0})), 5, 6);
  EXPECT_FALSE(within_ten(nested, moving_cube({3, 3, 3}, {0.25, 0, 0})));
}

TEST(MeshTraps, ContactEndsWithTheFirstWallAndBeginsAgain) {
  expect_contact(within_ten(walls, moving_point({-1, 0, 0}, {1, 0, 0})), 1, 2);
  expect_contact(within_ten(walls, moving_point({2, 0, 0}, {1, 0, 0})), 1, 2);
  expect_contact(within_ten(walls, moving_box({0.5, 0.5, 0.5}, {-1, 0, 0}, {1, 0, 0})), 0.5, 2.5);
  // Between the walls there is just room, or none.
  expect_contact(within_ten(walls, moving_box({before(1), 1, 1}, {-2, 0, 0}, {1, 0, 0})), 1, 4);
  expect_contact(within_ten(walls, moving_box({1, 1, 1}, {-2, 0, 0}, {1, 0, 0})), 1, 7);
}

TEST(MeshTraps, OneFliesThroughAHole) {
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

TEST(MeshTraps, APointGoesAcrossSharedEdgesAsIfThereWereNone) {
  // On a face across and along its diagonal, and along an edge of the cube.
  for (const double y : {0.0, 0.25, 1.0})
    expect_contact(within_ten(unit_cube, moving_point({-1, y, 1}, {1, 0, 0})), 1, 2);
  expect_contact(within_ten(unit_cube, moving_point({-1, -1, 1}, {1, 1, 0})), 1, 2);
  expect_contact(within_ten(unit_cube, moving_point({-1, 2, 1}, {1, -1, 0})), 1, 2);
  // In and out through diagonals, and through corners.
  expect_contact(within_ten(unit_cube, moving_point({0.5, 0.5, -1}, {0, 0, 1})), 1, 2);
  expect_contact(within_ten(unit_cube, moving_point({-1, -1, -1}, {1, 1, 1})), 1, 2);
  expect_contact(within_ten(ground, moving_point({-5, -5, 5}, {1, 1, -1})), 5, 5);
  expect_contact(within_ten(ground, moving_point({-5, 5, 0}, {1, -1, 0})), 0, 10);
}

TEST(MeshTraps, APointBesideAReflexEdgeIsOutForLessThanAnUlp) {
  const Mesh notched = solid_of(prism({{-2, -2}, {2, -2}, {2, 1}, {0, 0}, {-2, 1}}, {0, 0}, -1, 1));
  for (const double way : {-1.0, 1.0}) {
    const auto passing = [way](double y) { return moving_point({-3 * way, y, 0.25}, {way, 0, 0}); };
    expect_contact(within_ten(notched, passing(0x1p-60)), 1, 3);
    expect_contact(within_ten(notched, passing(0)), 1, 5);
    expect_contact(within_ten(notched, passing(-0x1p-60)), 1, 5);
  }
}

TEST(MeshTraps, WhatIsMissedByAnUlpAndTouchedLaterIsNotTheFirst) {
  // Up from just above the lower of two cubes, just into the upper, and down again onto the lower.
  const Mesh cubes =
      solid_of(together({box_between({0, 0, 0}, {1, 1, 1}), box_between({0, 0, 2}, {1, 1, 3})}));
  MeshObject point = moving_point({0.5, 0.5, after(1)}, {0, 0, 1});
  point.row.layout.law = Law::accelerated;
  point.row.a[2] = -0.5;
  expect_contact(within_ten(cubes, point), 2 - 0x1p-25, 2 + 0x1p-25);
}

TEST(MeshTraps, AParabolaGrazesAFace) {
  const auto grazing = [](double height, double r) {
    MeshObject ball = moving_ball(r, {-1, 0.25, height}, {1, 0, -1});
    ball.row.layout.law = Law::accelerated;
    ball.row.a[2] = 0.5;
    return within_ten(ground, ball);
  };
  expect_contact(grazing(1, 0), 2, 2);
  expect_contact(grazing(1.5, 0.5), 2, 2);
  for (const double r : {0.0, 0.5}) {
    EXPECT_FALSE(grazing(after(1 + r), r));
    const auto into = grazing(before(1 + r), r);
    ASSERT_TRUE(into.has_value());
    EXPECT_LT(into->t, 2);
  }
}

TEST(MeshTraps, FacesOfNearlyTheSameTiltAreToldApart) {
  // z = x top / 8, and a solid below.
  const auto wedge = [](double top) {
    const SpaceCorner a{0, 0, 0}, b{8, 0, 0}, c{8, 0, top}, d{0, 8, 0}, e{8, 8, 0}, f{8, 8, top};
    return solid_of({{a, b, c}, {d, e, f}, {a, b, e}, {a, e, d}, {a, c, f}, {a, f, d}, {b, e, f}, {b, f, c}});
  };
  const auto lid = [](double top, double z, double velocity) {
    return moving(resting(surface_of({{{{0, 1, 0}, {8, 1, top}, {8, 2, top}}}})), {0, 0, z},
                  {0, 0, velocity});
  };
  expect_contact(within_ten(wedge(3), lid(3, 4, -1)), 4, 7);
  expect_contact(within_ten(wedge(3), lid(after(3), 4, -1)), 4, 7);
  expect_contact(within_ten(wedge(3), lid(before(3), 4, -1)), before(4), 7);
  const double little = 0x1p-1074;
  EXPECT_TRUE(within_ten(wedge(after(3)), lid(3, little, 0)));
  EXPECT_FALSE(within_ten(wedge(after(3)), lid(after(3), little, 0)));
  EXPECT_TRUE(within_ten(wedge(after(3)), lid(after(3), 0, 0)));
}

TEST(MeshTraps, WhereTwoPartsCrossThereIsNothing) {
  const Mesh parts =
      solid_of(together({box_between({0, 0, 0}, {4, 4, 4}), box_between({2, 1, 1}, {6, 3, 3})}));
  expect_contact(within_ten(parts, moving_point({-1, 2, 2}, {1, 0, 0})), 1, 3);
  expect_contact(within_ten(parts, moving_point({2.5, 2, 2}, {0.5, 0, 0})), 3, 7);
  EXPECT_FALSE(within_ten(parts, moving_box({0.5, 0.5, 0.5}, {3, 2, 2}, {0, 0, 0})));
}

TEST(MeshTraps, ASolidOfTwoSidesOfOneTriangleIsThatTriangle) {
  const std::array<SpaceCorner, 3> side{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};
  const Mesh sheet = solid_of({side, side});
  ASSERT_TRUE(sheet.is_solid());
  expect_contact(within_ten(sheet, moving_point({1, 1, -3}, {0, 0, 1})), 3, 3);
  EXPECT_FALSE(within_ten(sheet, moving_point({3, 3, -3}, {0, 0, 1})));
  expect_contact(within_ten(sheet, moving_cube({1, 1, -3}, {0, 0, 1})), 2, 3);
}

TEST(MeshTraps, ATouchAtTheEndOfWhatIsAskedCounts) {
  expect_contact(within_ten(unit_cube, moving_point({11, 0.5, 0.5}, {-1, 0, 0})), 10, 10);
  EXPECT_FALSE(within_ten(unit_cube, moving_point({after(11), 0.5, 0.5}, {-1, 0, 0})));
  expect_contact(within_ten(unit_cube, moving_cube({11, 1, 1}, {-1, 0, 0})), 10, 10);
  expect_contact(within_ten(unit_cube, moving_cube({1, 1, 1}, {1, 0, 0})), 0, 0);
}

TEST(MeshTraps, ATouchAtTheEndOfALifeCounts) {
  MeshObject cube = moving_cube({6, 0.5, 0.5}, {-1, 0, 0});
  cube.row.until = 5;
  expect_contact(within_ten(unit_cube, cube), 5, 5);
  cube.row.until = before(5);
  EXPECT_FALSE(within_ten(unit_cube, cube));
}

TEST(MeshTraps, AMomentIsAsked) {
  const auto now = [](double x) {
    return mesh_contact({resting(unit_cube), moving_cube({x, 0, 0}, {1, 1, 1}), {.horizon = {0, 0}}});
  };
  expect_contact(now(1), 0, 0);
  expect_contact(now(0.5), 0, 0);
  EXPECT_FALSE(now(after(1)));
}

TEST(MeshTraps, ADistanceFromACornerIsReachedExactly) {
  // Of seven, along two, three and six; it is passed by at a right angle.
  const MeshObject point = moving_point({-9, 12, 7}, {3, -2, 0});
  expect_contact(within_ten(unit_cube, point, 7), 4, 4);
  EXPECT_FALSE(within_ten(unit_cube, point, before(7)));
}

TEST(MeshTraps, ADistanceFromAnEdgeIsReachedExactly) {
  const MeshObject point = moving_point({4, -3, 5}, {0, 1, 0});
  expect_contact(within_ten(unit_cube, point, 5), 3, 4);
  EXPECT_FALSE(within_ten(unit_cube, point, before(5)));
}

TEST(MeshTraps, ADistanceFromAFaceIsReachedExactly) {
  const MeshObject cube = moving_cube({-13, 0, 3}, {1, 0, 0});
  expect_contact(within_ten(ground, cube, 3), 2, 10);
  EXPECT_FALSE(within_ten(ground, cube, before(3)));
}

TEST(MeshTraps, ADistanceBetweenCrossingEdgesIsReachedExactly) {
  const Mesh roof = surface_of({{{{-1, 0, 0}, {1, 0, 0}, {0, 0, -1}}}});
  const Mesh keel = surface_of({{{{0, -1, 0}, {0, 1, 0}, {0, 0, 1}}}});
  const MeshObject passing = moving(resting(keel), {-3, 0.25, 2}, {1, 0, 0});
  expect_contact(within_ten(roof, passing, 2), 2, 4);
  EXPECT_FALSE(within_ten(roof, passing, before(2)));
}

TEST(MeshTraps, NothingAndABallMeetAMeshAlike) {
  for (const bool is_in_table_of_meshes : {false, true}) {
    MeshObject ball = moving(ball_object(2, is_in_table_of_meshes), {0.5, 0.5, 5}, {0, 0, -1});
    expect_contact(within_ten(unit_cube, ball), 2, 7);
    expect_contact(within_ten(unit_cube, ball, 1), 1, 8);
    ball.row.r = 0;
    expect_contact(within_ten(unit_cube, ball), 4, 5);
    MeshObject grown = resting(unit_cube);
    grown.row.r = 0.5;
    expect_contact(within_ten(grown, ball), 3.5, 5.5);
    expect_contact(within_ten(ball, grown, 0.25), 3.25, 5.75);
  }
}

TEST(MeshTraps, TwoWithoutMeshesAreBalls) {
  const MeshObject a = ball_object(1, true), b = moving(ball_object(1, true), {-4, 0, 0}, {1, 0, 0});
  expect_contact(within_ten(a, b), 2, 6);
  expect_contact(within_ten(a, moving_box({1, 1, 1}, {-4, 0, 0}, {1, 0, 0})), 2, 6);
  expect_contact(within_ten(a, moving_point({-4, 0, 0}, {1, 0, 0})), 3, 5);
}

TEST(MeshTraps, APositionMayLieFarFromItsMesh) {
  const Mesh apart = solid_of(box_between({100, 200, 300}, {101, 201, 301}));
  expect_contact(within_ten(apart, moving_point({98, 200.5, 300.5}, {1, 0, 0})), 2, 3);
  EXPECT_FALSE(within_ten(apart, moving_point({-2, 0.5, 0.5}, {1, 0, 0})));
  expect_contact(within_ten(apart, moving(resting(apart), {-3, 0, 0}, {1, 0, 0})), 2, 4);
}

TEST(MeshTraps, ZeroHasNoSign) {
  const MeshObject cube = moving_cube({-0.0, 1, -0.0}, {-0.0, -0.0, -0.0});
  expect_contact(within_ten(unit_cube, cube), 0, 10);
  expect_contact(within_ten(unit_cube, moving_cube({-3, -0.0, 1}, {1, -0.0, -0.0})), 2, 4);
}

TEST(MeshTraps, RoundingOfTheHostChangesNothing) {
  const MeshFamily any{.name = "any", .whole = false};
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const MeshScene scene =
        draw_scene(any, seed % 2 ? MeshPairing::mesh_and_ball : MeshPairing::meshes, seed);
    const auto nearest = mesh_contact(scene);
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
      std::fesetround(mode);
      const auto other = mesh_contact(scene);
      std::fesetround(FE_TONEAREST);
      ASSERT_EQ(other.has_value(), nearest.has_value());
      if (!other) continue;
      EXPECT_EQ(other->dt, nearest->dt);
      EXPECT_EQ(other->dt_end, nearest->dt_end);
    }
  }
}

TEST(MeshTraps, FarFromTheOriginNothingIsLost) {
  const MeshObject a = moving_cube({1e7, -1e7, 1e7}, {0, 0, 0});
  MeshObject b = moving_cube({1e7 + 3, -1e7 + 1, 1e7 - 1}, {-1, 0, 0});
  expect_contact(within_ten(a, b), 2, 4);
  b.row.x[2] = before(b.row.x[2]);
  EXPECT_FALSE(within_ten(a, b));
}

}  // namespace
}  // namespace foresee::contact
