// Which mesh are these triangles? Equal corners become one, and so what hangs together is known.
//
//   Mesh tent = welded(Mesh::Kind::surface, {{0, 0, 0}, {4, 0, 0}, {2, 5, 3},
//                                            {4, 0, 0}, {0, 0, 0}, {2, -5, 3}});
//   tent.corners().size() == 4
//
// Corners are numbered in the order in which triangles name them, so that equal triangles in the same order
// are equal meshes. Cost: n log n, some 200 ns a triangle.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "shape/mesh/mesh.h"

namespace foresee {

/// Three corners a triangle; -0 becomes 0. Requires: finite numbers, a triangle.
Mesh welded(Mesh::Kind kind, std::vector<SpaceCorner> corners);

/// An edge between corners of a mesh, and how many triangles have it.
struct MeshEdge {
  std::uint32_t from, to;
  std::size_t triangles;
};

/// The first edge that is not one of exactly two triangles; none: the triangles are closed.
std::optional<MeshEdge> open_edge_of(std::span<const Triangle> triangles);

/// Two corners that are equal, the first that are; none in a welded mesh.
std::optional<std::array<std::uint32_t, 2>> equal_corners_of(std::span<const SpaceCorner> corners);

}  // namespace foresee
