// Which mesh does a text mean? Well-known text, read as strictly as that of outlines (outline/wkt.h).
//
//   Mesh roof = read_mesh("TIN Z(((0 0 3, 4 0 3, 0 5 4, 0 0 3)))");
//
// TIN Z is a surface, POLYHEDRALSURFACE Z a solid, MULTIPOLYGON Z a solid if it is closed. Every face is a
// triangle: a ring of three corners, three numbers each, of which the first comes again at the end. Equal
// corners become one; -0 is 0. At most `max_triangles`: what has more is refused when the first too many is
// read. Whether triangles have an area, and whether a solid is closed, is not asked here (mesh_check.h).
//
// Throws Error, which names the face or the character (the first is 1) and quotes at most 40 characters.
// Cost: about a microsecond a triangle; n log n in the text, whatever it is.
#pragma once

#include <string>
#include <string_view>

#include "shape/mesh/mesh.h"

namespace foresee {

Mesh read_mesh(std::string_view text);

// What is a mesh as well-known text? TIN Z, POLYHEDRALSURFACE Z or MULTIPOLYGON Z, as it was read.
//
//   write_mesh(roof) == "TIN Z(((0 0 3, 4 0 3, 0 5 4, 0 0 3)))"
//
// Numbers have as few digits as read back to the same doubles, and faces are closed, so that
// read_mesh(write_mesh(mesh)) == mesh. Cost: some 500 ns a triangle.

std::string write_mesh(const Mesh& mesh);

/// "0 0 3", as in texts and messages.
std::string shown(const SpaceCorner& corner);

/// The word of a text that begins a mesh of this kind.
const char* word_of(Mesh::Kind kind);

}  // namespace foresee
