// Validity of a mesh: triangles with an area, and a closed surface; also after a rotation with its rounding.
//
//   check_mesh(mesh);                     // throws Error: "face 2 (0 0 0, 1 0 0, 2 0 0) has no area: …"
//   check_turned(mesh, turned(mesh, 37.5), 37.5);
//
// Every triangle has an area, by exact signs, and each edge of a POLYHEDRALSURFACE belongs to exactly two: an
// edge that was not welded would make a solid hollow. Triangles may touch and intersect. The same on every
// machine. Cost: n log n; some 10 ns per triangle, after a rotation some 100 ns per corner.
#pragma once

#include <optional>

#include "shape/mesh/weld.h"

namespace foresee {

/// The index of the first triangle whose corners are collinear.
std::optional<std::size_t> flat_triangle_of(const Mesh& mesh);

/// Whether check_mesh() accepts it.
bool is_sound(const Mesh& mesh);

/// Throws Error, which says what is wrong and where, for the author of the mesh. Requires: a welded mesh.
void check_mesh(const Mesh& mesh);

/// The same for `turned`, the sound `mesh` rotated by `heading` degrees: rounding may take away the area of a
/// triangle, or merge two corners.
void check_turned(const Mesh& mesh, const Mesh& turned, double heading);

}  // namespace foresee
