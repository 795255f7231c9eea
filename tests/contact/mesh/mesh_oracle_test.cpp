// The judge of meshes itself, by answers that are known.
#include "contact/mesh/mesh_oracle.h"

#include <gtest/gtest.h>

#include "contact/mesh/integer_triangles.h"
#include "contact/mesh/mesh_shapes.h"

namespace foresee::oracle {
namespace {

using namespace testing_by_hand;

const Body unit_cube = body_of(solid_of(box_between({0, 0, 0}, {1, 1, 1})));
const Body point = box_body(0, 0, 0);
const Body slope = body_of(surface_of({{{{0, 0, 0}, {4, 0, 4}, {0, 4, 0}}}}));

std::optional<RationalInterval> within_ten(const Body& a, const Body& b, const SpacePlace& place,
                                           const SpacePlace& velocity) {
  return first_contact(a, b, place, velocity, {0, 10});
}

void expect_contact(const std::optional<RationalInterval>& found, const Rational& begin,
                    const Rational& end) {
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->begin, begin);
  EXPECT_EQ(found->end, end);
}

TEST(MeshOracle, APointGoesInAndOut) {
  const Rational third(1, 3);
  expect_contact(within_ten(unit_cube, point, {-1, third, third}, {1, 0, 0}), 1, 2);
  expect_contact(within_ten(unit_cube, point, {-1, third, third}, {third, 0, 0}), 3, 6);
  expect_contact(within_ten(unit_cube, point, {third, third, third}, {0, 0, -third}), 0, 1);
  expect_contact(within_ten(unit_cube, point, {third, third, third}, {0, 0, 0}), 0, 10);
  EXPECT_FALSE(within_ten(unit_cube, point, {2, third, third}, {0, 0, 0}));
  EXPECT_FALSE(within_ten(unit_cube, point, {-1, third, third}, {Rational(1, 11), 0, 0}));
}

TEST(MeshOracle, ABoxIsAPointAnEdgeOrARectangleWhereItsHalvesAreZero) {
  const SpacePlace down{0, 0, -1};
  for (const double half : {0.0, 0.5, 4.0}) {
    expect_contact(within_ten(slope, box_body(0, 0, half), {1, 1, 9}, down),
                   std::max<Rational>(0, 8 - Rational(half)), std::min<Rational>(10, 8 + Rational(half)));
    expect_contact(within_ten(slope, box_body(0, half, 0), {1, 1, 9}, down), 8, 8);
  }
  expect_contact(within_ten(slope, box_body(0.5, 0, 0), {1, 1, 9}, down), Rational(15, 2), Rational(17, 2));
  expect_contact(within_ten(slope, box_body(0.5, 0.5, 0.5), {1, 1, 9}, down), 7, 9);
}

TEST(MeshOracle, ASurfaceHasNoInside) {
  const Body skin = body_of(surface_of(box_between({0, 0, 0}, {1, 1, 1})));
  const Rational half(1, 2);
  expect_contact(within_ten(skin, point, {-1, half, half}, {1, 0, 0}), 1, 1);
  EXPECT_FALSE(within_ten(skin, point, {half, half, half}, {0, 0, 0}));
  expect_contact(within_ten(skin, box_body(0.25, 0.25, 0.25), {half, half, half}, {half / 2, 0, 0}), 1, 3);
}

TEST(MeshOracle, TrianglesThatCrossAtRestTouchAllTheTime) {
  const Body upright = body_of(surface_of({{{{-1, 0, -1}, {3, 0, 9}, {3, 0, -9}}}}));
  expect_contact(within_ten(slope, upright, {0, 1, 0}, {0, 0, 0}), 0, 10);
  EXPECT_FALSE(within_ten(slope, upright, {0, -1, 0}, {0, 0, 0}));
  expect_contact(within_ten(slope, upright, {0, -1, 0}, {0, Rational(1, 2), 0}), 2, 10);
}

TEST(MeshOracle, FacesThatSlideOnEachOtherTouchThroughout) {
  const SpacePlace along{1, Rational(1, 7), 0};
  expect_contact(within_ten(unit_cube, unit_cube, {-2, 0, 1}, along), 1, 3);
  EXPECT_FALSE(within_ten(unit_cube, unit_cube, {-2, 0, Rational(1) + Rational(1, 1000000)}, along));
  // Edge along edge, and corner on corner.
  expect_contact(within_ten(unit_cube, unit_cube, {-2, 1, 1}, {1, 0, 0}), 1, 3);
  expect_contact(within_ten(unit_cube, unit_cube, {-2, 4, 1}, {1, -1, 0}), 3, 3);
}

TEST(MeshOracle, EdgesThatCrossAreTheFirstToTouch) {
  const Body roof = body_of(surface_of({{{{-1, 0, 0}, {1, 0, 0}, {0, 0, -1}}}}));
  const Body keel = body_of(surface_of({{{{0, -1, 0}, {0, 1, 0}, {0, 0, 1}}}}));
  expect_contact(within_ten(roof, keel, {0, Rational(1, 3), 1}, {Rational(1, 5), 0, -1}), 1, Rational(20, 9));
  expect_contact(within_ten(roof, keel, {-1, 0, 0}, {1, 0, 0}), 0, 2);
}

TEST(MeshOracle, WhatIsInACavityTouchesNothing) {
  const Body hollow = body_of(
      solid_of(together({box_between({-3, -3, -3}, {3, 3, 3}), box_between({-2, -2, -2}, {2, 2, 2})})));
  expect_contact(within_ten(hollow, point, {0, 0, 0}, {1, 0, 0}), 2, 3);
  EXPECT_FALSE(within_ten(hollow, box_body(1, 1, 1), {0, 0, 0}, {0, 0, 0}));
  expect_contact(within_ten(hollow, box_body(2.5, 2.5, 2.5), {0, 0, 0}, {0, 0, 0}), 0, 10);
  expect_contact(within_ten(unit_cube, hollow, {0, 0, 0}, {1, 0, 0}), 2, 4);
}

TEST(MeshOracle, WhereTwoPartsOverlapIsNoSolid) {
  const Body parts =
      body_of(solid_of(together({box_between({0, 0, 0}, {4, 4, 4}), box_between({2, 1, 1}, {6, 3, 3})})));
  expect_contact(within_ten(parts, point, {-1, 2, 2}, {1, 0, 0}), 1, 3);
  expect_contact(within_ten(parts, point, {3, 2, 2}, {1, 0, 0}), 1, 3);
}

TEST(MeshOracle, ThroughAHoleThereIsNoContact) {
  const Body ring = body_of(solid_of(frame(1, 2, -1, 1)));
  EXPECT_FALSE(within_ten(ring, point, {0, 0, -5}, {0, 0, 1}));
  expect_contact(within_ten(ring, point, {1, 0, -5}, {0, 0, 1}), 4, 6);
  expect_contact(within_ten(ring, point, {-3, 0, 0}, {1, 0, 0}), 1, 2);
}

TEST(MeshOracle, DistancesAreExact) {
  EXPECT_TRUE(touch_at(unit_cube, point, {4, 5, 1}, 5));
  EXPECT_FALSE(touch_at(unit_cube, point, {4, 5, 1}, Rational(4999999, 1000000)));
  EXPECT_TRUE(touch_at(unit_cube, point, {Rational(1, 2), Rational(1, 3), 3}, 2));
  EXPECT_FALSE(touch_at(unit_cube, point, {Rational(1, 2), Rational(1, 3), 3}, Rational(19, 10)));
  EXPECT_TRUE(touch_at(unit_cube, point, {Rational(1, 2), Rational(1, 3), Rational(1, 4)}, 0));
  EXPECT_TRUE(touch_at(point, unit_cube, {Rational(-1, 2), Rational(-1, 3), Rational(-1, 4)}, 0));
  // Edges that cross at a right angle.
  EXPECT_TRUE(touch_at(box_body(1, 0, 0), box_body(0, 1, 0), {Rational(1, 3), Rational(1, 7), 2}, 2));
  EXPECT_FALSE(touch_at(box_body(1, 0, 0), box_body(0, 1, 0), {Rational(1, 3), Rational(1, 7), 2}, 1));
}

TEST(MeshOracle, RaysAreDistinguishedFromEdges) {
  const Facet facet({Arrow{0, 0, 0}, Arrow{4, 0, 0}, Arrow{0, 4, 0}});
  EXPECT_EQ(crossings({1, 1, 1}, {0, 0, -1}, facet), 1);
  EXPECT_EQ(crossings({1, 1, 1}, {0, 0, 1}, facet), 0);
  EXPECT_EQ(crossings({5, 5, 1}, {0, 0, -1}, facet), 0);
  EXPECT_EQ(crossings({5, 5, 0}, {0, 0, -1}, facet), 0);
  EXPECT_EQ(crossings({1, 0, 1}, {0, 0, -1}, facet), std::nullopt);
  EXPECT_EQ(crossings({9, 9, 0}, {-1, -1, 0}, facet), std::nullopt);
}

}  // namespace
}  // namespace foresee::oracle
