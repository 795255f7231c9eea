// Reads and writes meshes as well-known text (WKT), as strictly as outlines (outline/wkt.h).
//
//   Mesh roof = read_mesh("TIN Z(((0 0 3, 4 0 3, 0 5 4, 0 0 3)))");
//
// TIN Z is a surface, POLYHEDRALSURFACE Z a solid, MULTIPOLYGON Z a solid if it is closed. Every face is a
// triangle: a ring of three corners with three numbers each; the first corner is repeated at the end. Equal
// corners become one; -0 is 0. At most `max_triangles`: a larger mesh is refused at the first triangle
// beyond. Areas of triangles and the closedness of a solid are checked in mesh.h.
//
// Throws Error, which names the face or the character (the first is 1) and quotes at most 40 characters.
// Cost: about a microsecond per triangle; n log n for any text.
#pragma once

#include <string>
#include <string_view>

#include "base/error.h"
#include "shape/mesh/mesh.h"

namespace foresee {

Mesh read_mesh(std::string_view text);

// Writes a mesh as TIN Z, POLYHEDRALSURFACE Z or MULTIPOLYGON Z, as it was read.
//
//   write_mesh(roof) == "TIN Z(((0 0 3, 4 0 3, 0 5 4, 0 0 3)))"
//
// Numbers have the fewest digits that read back to the same doubles, and faces are closed, so that
// read_mesh(write_mesh(mesh)) == mesh. Cost: some 500 ns per triangle.

std::string write_mesh(const Mesh& mesh);

/// "0 0 3", as in texts and messages.
std::string shown(const SpaceCorner& corner);

}  // namespace foresee
