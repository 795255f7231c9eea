// Meshes of a family, drawn with the numbers that it has.
#pragma once

#include <cmath>

#include "contact/mesh/mesh_scenes.h"

namespace foresee::testing_by_hand {

class DrawMesh {
 public:
  DrawMesh(const MeshFamily& family, std::uint64_t seed) : family_(family), random_(seed) {}

  std::uint64_t below(std::uint64_t count) { return random_() % count; }
  /// Between -range and range; a half of a whole number, if the family's are.
  double number(double range);
  double above(double min, double range) { return min + std::abs(number(range)); }
  SpaceCorner place(double range) { return {number(range), number(range), number(range)}; }

  /// Of a, or of b.
  Mesh mesh(bool is_a);

 private:
  Mesh any_mesh();
  std::array<SpaceCorner, 3> triangle();
  /// Nearly a line.
  std::array<SpaceCorner, 3> sliver();
  Triangles tetrahedron();
  Triangles flat_tetrahedron();
  /// At a quarter of the way, or an ulp beside.
  double between(double a, double b);
  Triangles box(double range);
  /// One, or two that are stacked, side by side or crossing.
  Triangles boxes();
  Triangles l_shaped();
  /// Concave, upright: corners around the origin, alternately far and near.
  Triangles star();
  Triangles octahedron();
  /// With dents.
  Triangles ball();
  Triangles ground();
  /// A cavity, perhaps with something in it; a hole; walls.
  Triangles hollow();

  const MeshFamily& family_;
  std::mt19937_64 random_;
};

}  // namespace foresee::testing_by_hand
