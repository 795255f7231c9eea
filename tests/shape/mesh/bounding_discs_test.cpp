// Every corner below a node lies within its box and its bounding disc, before and after a rotation.

#include <gtest/gtest.h>

#include <random>

#include "shape/mesh/mesh.h"
#include "shape/mesh/triangle_tree.h"

namespace foresee {
namespace {

using Node = BoxTree<3>::Node;

/// Some of them slender or in one plane, all `size` from the origin or so.
Mesh drawn_mesh(std::mt19937_64& random, std::uint32_t triangles, double size) {
  const auto number = [&random](double bound) {
    return std::uniform_real_distribution<double>(-bound, bound)(random);
  };
  const double flat = random() % 3 == 0 ? 0 : 1, slender = random() % 3 == 0 ? 1e-9 : 0.2;
  std::vector<SpaceCorner> corners;
  std::vector<Triangle> all;
  for (std::uint32_t i = 0; i < triangles; ++i) {
    const SpaceCorner at{size * number(1), size * number(1), size * flat * number(1)};
    corners.push_back(at);
    corners.push_back(
        {at.x + size * number(0.3), at.y + size * number(0.3), at.z + size * flat * number(0.3)});
    corners.push_back({at.x + size * number(slender), at.y + size * number(slender), at.z});
    all.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return {Mesh::Kind::surface, false, std::move(corners), std::move(all)};
}

long double along(const BoundingDisc& disc, const SpaceCorner& corner) {
  return static_cast<long double>(disc.normal[0]) * (corner.x - static_cast<long double>(disc.middle[0])) +
         static_cast<long double>(disc.normal[1]) * (corner.y - static_cast<long double>(disc.middle[1])) +
         static_cast<long double>(disc.normal[2]) * (corner.z - static_cast<long double>(disc.middle[2]));
}
/// The square of the distance from the line along the normal.
long double square_beside(const BoundingDisc& disc, const SpaceCorner& corner) {
  const long double place[] = {corner.x, corner.y, corner.z};
  long double gap[3], square = 0, length = 0;
  for (std::size_t j = 0; j < 3; ++j)
    gap[j] = place[j] - disc.middle[j], length += static_cast<long double>(disc.normal[j]) * disc.normal[j];
  for (std::size_t j = 0; j < 3; ++j) {
    const long double beside = gap[j] - along(disc, corner) / length * disc.normal[j];
    square += beside * beside;
  }
  return square;
}

void expect_holds(const BoundingDisc& disc, const SpaceCorner& corner) {
  EXPECT_LE(std::abs(along(disc, corner)), disc.half);
  EXPECT_LE(square_beside(disc, corner), static_cast<long double>(disc.radius) * disc.radius);
  const double place[] = {corner.x, corner.y, corner.z};
  for (std::size_t j = 0; j < 3; ++j) {
    EXPECT_LE(disc.lower[j], place[j]);
    EXPECT_GE(disc.upper[j], place[j]);
  }
}

void expect_sound(const TriangleTree& triangles) {
  ASSERT_TRUE(triangles.discs().are_there());
  for (std::size_t t = 0; t < triangles.count(); ++t)
    for (std::size_t node = triangles.tree().leaf(t) + 1; node > 0; node /= 2)
      for (int i = 0; i < 3; ++i)
        expect_holds(triangles.discs().of(static_cast<Node>(node - 1)), triangles.corner(t, i));
}

TEST(BoundingDiscs, HoldWhatIsBelowTheirNodes) {
  std::mt19937_64 random(14);
  for (int run = 0; run < 60; ++run) {
    const Mesh mesh = drawn_mesh(random, 1 + static_cast<std::uint32_t>(random() % 40),
                                 run % 5 == 0   ? 1e-15
                                 : run % 5 == 1 ? 1e15
                                                : 30);
    const TriangleTree building(mesh);
    expect_sound(building);
    for (const double heading : {90.0, 37.5, -359.9})
      expect_sound(TriangleTree(building, turned(mesh, heading)));
  }
}

TEST(BoundingDiscs, AreThinWhereASurfaceIsFlat) {
  // A roof at 45 degrees, of which every box is as high as it is wide.
  std::vector<SpaceCorner> corners;
  std::vector<Triangle> triangles;
  for (std::uint32_t i = 0; i < 64; ++i) {
    const double x = i / 8, y = i % 8;
    corners.insert(corners.end(), {{x, y, x}, {x + 1, y, x + 1}, {x, y + 1, x}});
    triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const TriangleTree roof({Mesh::Kind::surface, false, corners, triangles});
  const BoundingDisc& disc = roof.discs().of(0);
  EXPECT_LT(disc.half, 1e-3F);
  EXPECT_GT(disc.radius, 4.0F);
  EXPECT_GT(disc.size, 20.0F);
}

TEST(BoundingDiscs, AreNotThereWhereFloatsDoNotHoldThem) {
  for (const double size : {1e-30, 1e30, 1e300})
    EXPECT_FALSE(
        TriangleTree({Mesh::Kind::surface, false, {{0, 0, 0}, {size, 0, 0}, {0, size, 0}}, {{0, 1, 2}}})
            .discs()
            .are_there());
}

}  // namespace
}  // namespace foresee
