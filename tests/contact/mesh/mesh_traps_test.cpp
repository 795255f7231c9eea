// What is easy to get wrong where surfaces meet, one by one, by cases whose answer is known.
#include <gtest/gtest.h>

#include "contact/mesh/meshes_by_hand.h"

namespace foresee {
namespace {

using namespace testing_by_hand;

TEST(MeshTraps, FacesThatSlideOnEachOtherTouchThroughout) {
  const auto above = [](double z) { return moving_cube({-3, 0.25, z}, {1, 0, 0}); };
  expect_contact(within_ten(unit_cube, above(1)), 2, 4);
  EXPECT_FALSE(within_ten(unit_cube, above(after(1))));
  // The same face on the same face, and across it.
  expect_contact(within_ten(unit_cube, moving_cube({0, 0, -1}, {0, 0.5, 0})), 0, 2);
  expect_contact(within_ten(unit_cube, moving_cube({-2, -2, 1}, {0.5, 0.5, 0})), 2, 6);
}

TEST(MeshTraps, EdgesThatSlideAlongEachOtherTouchThroughout) {
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
  for (const double side : {-1.0, 1.0}) {
    const auto passing = [side](double y) { return moving_point({-3 * side, y, 0.25}, {side, 0, 0}); };
    expect_contact(within_ten(notched, passing(0x1p-60)), 1, 3);
    expect_contact(within_ten(notched, passing(0)), 1, 5);
    expect_contact(within_ten(notched, passing(-0x1p-60)), 1, 5);
  }
}

TEST(MeshTraps, AMissByAnUlpIsNotTheFirstContact) {
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

TEST(MeshTraps, FacesOfNearlyTheSameTiltAreDistinguished) {
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

}  // namespace
}  // namespace foresee
