// What is a mesh as well-known text? TIN Z, POLYHEDRALSURFACE Z or MULTIPOLYGON Z, as it was read.
//
//   write_mesh(roof) == "TIN Z(((0 0 3, 4 0 3, 0 5 4, 0 0 3)))"
//
// Numbers have as few digits as read back to the same doubles, and faces are closed, so that
// read_mesh(write_mesh(mesh)) == mesh. Cost: some 500 ns a triangle.
#pragma once

#include <string>

#include "shape/mesh/mesh.h"

namespace foresee {

std::string write_mesh(const Mesh& mesh);

/// "0 0 3", as in texts and messages.
std::string shown(const SpaceCorner& corner);

/// The word of a text that begins a mesh of this kind.
const char* word_of(Mesh::Kind kind);

}  // namespace foresee
