// Minkowski sums of pieces in doubles against their definition: support function and signed distance, rotated
// or not.
#include "contact/clearance/piece_sum.h"

#include <gtest/gtest.h>

#include "contact/outline/outline_scenes.h"
#include "scenes.h"
#include "shape/outline/outline_rotation.h"

namespace foresee {
namespace {

using testing::Random;
using namespace testing_by_hand;

/// The differences of all corners, the own ones rotated and rounded as they are stored.
std::vector<Corner> differences(const ConvexPiece& own, const ConvexPiece& other, double degrees) {
  std::vector<Corner> all;
  Turn turn(degrees);
  for (const Corner& p : own.corners)
    for (const Corner& q : other.corners) {
      const Corner at = turn(p);
      all.push_back({at.x - q.x, at.y - q.y});
    }
  return all;
}

double support_of(const std::vector<Corner>& corners, double x, double y) {
  double support = -HUGE_VAL;
  for (const Corner& corner : corners) support = std::max(support, x * corner.x + y * corner.y);
  return support;
}

/// By the lines that may separate a point from a hull: along two of its corners, or perpendicular to the vector
/// from one.
double plain_outside(const std::vector<Corner>& corners, double x, double y) {
  double outside = -HUGE_VAL;
  const auto probe_along = [&](double nx, double ny) {
    const double length = std::hypot(nx, ny);
    if (length < 1e-9) return;
    outside = std::max(outside, (nx * x + ny * y - support_of(corners, nx, ny)) / length);
  };
  for (const Corner& from : corners) {
    probe_along(x - from.x, y - from.y);
    for (const Corner& to : corners) probe_along(to.y - from.y, from.x - to.x);
  }
  return outside;
}

/// `sum`: as it was made. Its own pose does not matter.
void expect_support_in_pose(const PieceSum& sum, const std::vector<Corner>& all, Random& random,
                            double degrees) {
  const SineCosine<double> pose = quick_sine_cosine(degrees);
  const double size = sum.size() + 1e-9;
  for (int i = 0; i < 20; ++i) {
    const double x = random.in(-3, 3), y = i % 4 ? random.in(-3, 3) : 0, support = support_of(all, x, y);
    ASSERT_GE(sum.support(x, y, pose), support);
    ASSERT_LE(sum.support(x, y, pose), support + 1e-12 * 6 * size);
    const auto [mine, its] = sum.farthest_pair(x, y, pose);
    const Corner farthest{mine.x * pose.cosine + mine.y * pose.sine - its.x,
                          mine.y * pose.cosine - mine.x * pose.sine - its.y};
    ASSERT_NEAR(x * farthest.x + y * farthest.y, support, 1e-12 * 6 * size);
  }
}

void expect_sum(const ConvexPiece& own, const ConvexPiece& other, Random& random, double degrees) {
  PieceSum sum(own, other);
  const std::vector<Corner> all = differences(own, other, degrees);
  ASSERT_NO_FATAL_FAILURE(expect_support_in_pose(sum, all, random, degrees));
  if (degrees != 0) sum.turn(degrees);
  const double size = sum.size() + 1e-9;
  for (int i = 0; i < 20; ++i) {
    const double x = random.in(-3, 3), y = i % 4 ? random.in(-3, 3) : 0, support = support_of(all, x, y);
    ASSERT_GE(sum.support(x, y), support);
    ASSERT_LE(sum.support(x, y), support + 1e-12 * 6 * size);
  }
  for (int i = 0; i < 3; ++i) {
    const double x = random.in(-2, 2) * size, y = random.in(-2, 2) * size;
    double nx = 0, ny = 0;
    const double outside = sum.signed_distance(x, y, nx, ny);
    ASSERT_NEAR(outside, plain_outside(all, x, y), 1e-9 * size);
    ASSERT_NEAR(nx * nx + ny * ny, 1, 1e-12);
    ASSERT_NEAR(nx * x + ny * y - support_of(all, nx, ny), outside, 1e-9 * size);
  }
}

TEST(PieceSum, IsTheHullOfAllDifferences) {
  Random random(3);
  for (const OutlineFamily& family : outline_families())
    for (std::uint64_t seed = 0; seed < 2 && family.scale == 0; ++seed) {
      const OutlineScene scene = draw_scene(family, OutlinePairing::outlines, seed);
      const ConvexPieces cut_a = convex_pieces(scene.a.outline), cut_b = convex_pieces(scene.b.outline);
      ObjectPieces a, b;
      a.take(cut_a), b.take(cut_b);
      const std::size_t i = random.below(cut_a.count()), j = random.below(cut_b.count());
      for (const double degrees : {0.0, 90.0, random.in(-360, 360)}) {
        ASSERT_NO_FATAL_FAILURE(expect_sum(a.piece(i), b.piece(j), random, degrees))
            << family.name << ' ' << seed << " turned by " << degrees;
      }
      for (const double half : {0.0, 2.0}) {
        b.take_box(half, 1);
        ASSERT_NO_FATAL_FAILURE(expect_sum(a.piece(i), b.piece(0), random, 30)) << family.name;
        ASSERT_NO_FATAL_FAILURE(expect_sum(b.piece(0), a.piece(i), random, 0)) << family.name;
      }
      b.take_point();
      ASSERT_NO_FATAL_FAILURE(expect_sum(a.piece(i), b.piece(0), random, 30)) << family.name;
    }
}

TEST(PieceSum, HasTheNormalOfTheNearestEdgeRightBesideIt) {
  const Outline hull = outline_of({{{-1, -1, 1, -1, 1, 1, -1, 1}}});
  const ConvexPieces cut = convex_pieces(hull);
  ObjectPieces a, b;
  a.take(cut), b.take_point();
  PieceSum sum(a.piece(0), b.piece(0));
  double nx = 0, ny = 0;
  EXPECT_EQ(sum.signed_distance(std::nextafter(1.0, 2), 0.5, nx, ny), 0x1p-52);
  EXPECT_EQ(nx, 1);
  EXPECT_EQ(ny, 0);
  EXPECT_EQ(sum.signed_distance(0, 0.25, nx, ny), -0.75);
  EXPECT_EQ(ny, 1);
}

/// A corner that stays inside means contact in every pose of the range. Own piece and place rotate about the origin.
void expect_corner_inside(const ConvexPiece& own, const ConvexPiece& other, Random& random, int& found) {
  PieceSum sum(own, other);
  const double size = sum.size() + 1e-9, radius = random.below(2) ? 0 : random.in(0, 0.3) * size;
  const double degrees = random.in(-180, 180), half = random.in(0, 20);
  const Corner own_place{random.in(-2, 2) * size, random.in(-2, 2) * size};
  const Corner other_place{own_place.x + random.in(-0.6, 0.6) * size,
                           own_place.y + random.in(-0.6, 0.6) * size};
  sum.turn(degrees);
  if (!sum.has_corner_inside(other_place, own_place, quick_sine_cosine(half), radius, 1e-12 * size)) return;
  ++found;
  for (int i = 0; i <= 8; ++i) {
    const double by = half * (i / 4.0 - 1);
    const SineCosine<double> turned = quick_sine_cosine(by);
    PieceSum there(own, other);
    there.turn(degrees + by);
    double nx = 0, ny = 0;
    const double x = own_place.x * turned.cosine + own_place.y * turned.sine;
    const double y = own_place.y * turned.cosine - own_place.x * turned.sine;
    ASSERT_LE(there.signed_distance(other_place.x - x, other_place.y - y, nx, ny), radius + 1e-9 * size)
        << by;
  }
}

TEST(PieceSum, FindsOnlyCornersInsideInEveryPose) {
  Random random(7);
  int found = 0;
  for (const OutlineFamily& family : outline_families())
    for (std::uint64_t seed = 0; seed < 4 && family.scale == 0; ++seed) {
      const OutlineScene scene = draw_scene(family, OutlinePairing::outlines, seed);
      const ConvexPieces cut_a = convex_pieces(scene.a.outline), cut_b = convex_pieces(scene.b.outline);
      ObjectPieces a, b;
      a.take(cut_a), b.take(cut_b);
      for (int i = 0; i < 60; ++i)
        ASSERT_NO_FATAL_FAILURE(expect_corner_inside(a.piece(random.below(cut_a.count())),
                                                     b.piece(random.below(cut_b.count())), random, found))
            << family.name << ' ' << seed << ' ' << i;
    }
  EXPECT_GT(found, 100);
}

}  // namespace
}  // namespace foresee
