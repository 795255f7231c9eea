// When do two touch of which one has a mesh? Two meshes, or one and a point, ball or box, by the Euclidean
// distance. Like outline_contact.h a class of its own behind the room's door, as its sets are made pair by
// pair.
//
//   const MeshRows* rows = …;  // whose triangles are made when a row is first asked for
//   auto contact = make_mesh_contact(setup, {.a = rows, .b = nullptr}, degree);
//
// The surfaces of both are triangles under a tree of boxes, or the one box that a row's half extents make; a
// solid is also touched by what lies within it. The stages of a pair are those of outlines: trees, triangles
// in doubles with error bounds, the crossing in DoubleDouble, exact numbers for what is left
// (docs/exactness.md).
#pragma once

#include <memory>

#include "contact/contact.h"
#include "contact/set/relative_motion.h"
#include "shape/mesh/mesh_rows.h"

namespace foresee {

/// Of both tables; null: one without meshes, whose rows are what their layout says. Those of a layout of
/// meshes are the smallest boxes around them, grown by r.
struct MeshTables {
  const MeshRows *a = nullptr, *b = nullptr;
};

/// Where the setup has a window the first table is that window. `degree`: of the relative motion, at most 2.
/// Requires: three axes, no cylinders and no prisms; the tables outlive the contact.
std::unique_ptr<Contact> make_mesh_contact(const Setup& setup, const MeshTables& meshes, int degree);

}  // namespace foresee
