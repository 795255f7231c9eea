// Welds a triangle soup into a mesh: equal corners become one, so that the triangles are connected.
//
//   Mesh tent = welded(Mesh::Kind::surface, {{0, 0, 0}, {4, 0, 0}, {2, 5, 3},
//                                            {4, 0, 0}, {0, 0, 0}, {2, -5, 3}});
//   tent.corners().size() == 4
//
// Corners are numbered in the order of their first use, so that equal triangles in the same order give equal
// meshes. Cost: n log n, some 200 ns per triangle.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "shape/mesh/mesh.h"

namespace foresee {

/// `corners`: three per triangle; -0 becomes 0. Requires: finite numbers, at least one triangle.
Mesh welded(Mesh::Kind kind, std::vector<SpaceCorner> corners);

/// An edge between two corners of a mesh, and the number of triangles that have it.
struct MeshEdge {
  std::uint32_t from, to;
  std::size_t triangles;
};

/// The first edge that does not belong to exactly two triangles; empty: the surface is closed.
std::optional<MeshEdge> open_edge_of(std::span<const Triangle> triangles);

/// The first two corners that are equal; empty for a welded mesh.
std::optional<std::array<std::uint32_t, 2>> equal_corners_of(std::span<const SpaceCorner> corners);

}  // namespace foresee
