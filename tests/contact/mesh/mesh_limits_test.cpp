// Contacts that the last digit decides: at ends of the queried time and of lifetimes, at exact
// distances, far away.
#include <gtest/gtest.h>

#include <cfenv>

#include "contact/mesh/meshes_by_hand.h"

namespace foresee {
namespace {

using namespace testing_by_hand;

TEST(MeshLimits, ATouchAtTheEndOfTheQueriedTimeCounts) {
  expect_contact(within_ten(unit_cube, moving_point({11, 0.5, 0.5}, {-1, 0, 0})), 10, 10);
  EXPECT_FALSE(within_ten(unit_cube, moving_point({after(11), 0.5, 0.5}, {-1, 0, 0})));
  expect_contact(within_ten(unit_cube, moving_cube({11, 1, 1}, {-1, 0, 0})), 10, 10);
  expect_contact(within_ten(unit_cube, moving_cube({1, 1, 1}, {1, 0, 0})), 0, 0);
}

TEST(MeshLimits, ATouchAtTheEndOfALifeCounts) {
  MeshObject cube = moving_cube({6, 0.5, 0.5}, {-1, 0, 0});
  cube.row.until = 5;
  expect_contact(within_ten(unit_cube, cube), 5, 5);
  cube.row.until = before(5);
  EXPECT_FALSE(within_ten(unit_cube, cube));
}

TEST(MeshLimits, AnInstantIsQueried) {
  const auto now = [](double x) {
    return mesh_contact({resting(unit_cube), moving_cube({x, 0, 0}, {1, 1, 1}), {.horizon = {0, 0}}});
  };
  expect_contact(now(1), 0, 0);
  expect_contact(now(0.5), 0, 0);
  EXPECT_FALSE(now(after(1)));
}

TEST(MeshLimits, ADistanceFromACornerIsReachedExactly) {
  // Of seven, along two, three and six; it is passed by at a right angle.
  const MeshObject point = moving_point({-9, 12, 7}, {3, -2, 0});
  expect_contact(within_ten(unit_cube, point, 7), 4, 4);
  EXPECT_FALSE(within_ten(unit_cube, point, before(7)));
}

TEST(MeshLimits, ADistanceFromAnEdgeIsReachedExactly) {
  const MeshObject point = moving_point({4, -3, 5}, {0, 1, 0});
  expect_contact(within_ten(unit_cube, point, 5), 3, 4);
  EXPECT_FALSE(within_ten(unit_cube, point, before(5)));
}

TEST(MeshLimits, ADistanceFromAFaceIsReachedExactly) {
  const MeshObject cube = moving_cube({-13, 0, 3}, {1, 0, 0});
  expect_contact(within_ten(ground, cube, 3), 2, 10);
  EXPECT_FALSE(within_ten(ground, cube, before(3)));
}

TEST(MeshLimits, ADistanceBetweenCrossingEdgesIsReachedExactly) {
  const Mesh roof = surface_of({{{{-1, 0, 0}, {1, 0, 0}, {0, 0, -1}}}});
  const Mesh keel = surface_of({{{{0, -1, 0}, {0, 1, 0}, {0, 0, 1}}}});
  const MeshObject passing = moving(resting(keel), {-3, 0.25, 2}, {1, 0, 0});
  expect_contact(within_ten(roof, passing, 2), 2, 4);
  EXPECT_FALSE(within_ten(roof, passing, before(2)));
}

TEST(MeshLimits, NothingAndABallMeetAMeshAlike) {
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

TEST(MeshLimits, TwoWithoutMeshesAreBalls) {
  const MeshObject a = ball_object(1, true), b = moving(ball_object(1, true), {-4, 0, 0}, {1, 0, 0});
  expect_contact(within_ten(a, b), 2, 6);
  expect_contact(within_ten(a, moving_box({1, 1, 1}, {-4, 0, 0}, {1, 0, 0})), 2, 6);
  expect_contact(within_ten(a, moving_point({-4, 0, 0}, {1, 0, 0})), 3, 5);
}

TEST(MeshLimits, APositionMayBeFarFromItsMesh) {
  const Mesh apart = solid_of(box_between({100, 200, 300}, {101, 201, 301}));
  expect_contact(within_ten(apart, moving_point({98, 200.5, 300.5}, {1, 0, 0})), 2, 3);
  EXPECT_FALSE(within_ten(apart, moving_point({-2, 0.5, 0.5}, {1, 0, 0})));
  expect_contact(within_ten(apart, moving(resting(apart), {-3, 0, 0}, {1, 0, 0})), 2, 4);
}

TEST(MeshLimits, ZeroHasNoSign) {
  const MeshObject cube = moving_cube({-0.0, 1, -0.0}, {-0.0, -0.0, -0.0});
  expect_contact(within_ten(unit_cube, cube), 0, 10);
  expect_contact(within_ten(unit_cube, moving_cube({-3, -0.0, 1}, {1, -0.0, -0.0})), 2, 4);
}

TEST(MeshLimits, RoundingOfTheHostChangesNothing) {
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

TEST(MeshLimits, FarFromTheOriginNothingIsLost) {
  const MeshObject a = moving_cube({1e7, -1e7, 1e7}, {0, 0, 0});
  MeshObject b = moving_cube({1e7 + 3, -1e7 + 1, 1e7 - 1}, {-1, 0, 0});
  expect_contact(within_ten(a, b), 2, 4);
  b.row.x[2] = before(b.row.x[2]);
  EXPECT_FALSE(within_ten(a, b));
}

}  // namespace
}  // namespace foresee
