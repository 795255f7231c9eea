// Is a mesh one, and is it still one after it was turned?
//
//   check_mesh(mesh);                     // throws Error: "face 2 (0 0 0, 1 0 0, 2 0 0) has no area: …"
//   check_turned(mesh, turned(mesh, 37.5), 37.5);
//
// Every triangle has an area, by exact signs, and each edge of a POLYHEDRALSURFACE is one of exactly two: an
// edge that was not welded would make a solid hollow. Triangles may touch and cross. The same on every
// machine. Cost: n log n; some 10 ns a triangle, turned some 100 ns a corner.
#pragma once

#include <optional>

#include "shape/mesh/weld.h"

namespace foresee {

/// The first triangle whose corners lie on one line, counted from 0.
std::optional<std::size_t> flat_triangle_of(const Mesh& mesh);

/// Whether check_mesh() accepts it.
bool is_sound(const Mesh& mesh);

/// Throws Error, which says what is wrong and where: for whoever wrote the mesh. Requires: a welded mesh.
void check_mesh(const Mesh& mesh);

/// The same for `turned`, which is the sound `mesh` turned by `heading` degrees: rounding may take away the
/// area of a triangle, and make two corners one.
void check_turned(const Mesh& mesh, const Mesh& turned, double heading);

}  // namespace foresee
