// Factories of the implementations of Contact, for make_contact() and make_window_contact() to choose from,
// once per statement: contact sets, boxes in lanes, outlines and meshes.
//
//   make_typed<SetContact>(setup.a.layout.axes, degree, setup, contact_set(setup));      // SetContact<2, 1>
//
//   const OutlineRows* outlines = …;                   // makes the pieces of a row at the first access
//   auto contact = make_outline_contact(setup, {.a = outlines, .b = nullptr}, degree);
//
//   const MeshRows* meshes = …;                        // makes the triangles of a row at the first access
//   auto solids = make_mesh_contact(setup, {.a = meshes, .b = nullptr}, degree);
//
// The distance of meshes is Euclidean on all axes; that of outlines is Euclidean in x and y. On three axes
// outlines are those of upright prisms, and the distance along z is a separate limit.
//
// Outlines and meshes have classes of their own, because their contact sets depend on the pair. They are made
// from the pieces of both objects, not from a few lengths in the rows. A table without outlines and meshes
// pays nothing for them. The stages of a pair (docs/explanation/exactness.md) are trees of boxes, then pieces or
// triangles in doubles with error bounds. The crossing follows in DoubleDouble, and exact numbers decide the
// pieces that are left.
#pragma once

#include <memory>
#include <utility>

#include "base/axes.h"
#include "contact/contact.h"
#include "contact/minkowski/contact_set.h"
#include "contact/setup.h"
#include "shape/form_rows.h"

namespace foresee {

/// Contact of one contact set for all pairs (set/set_traits.h). `degree`: of the relative motion, at most 2.
std::unique_ptr<Contact> make_set_contact(const Setup& setup, ContactSet set, int degree);
/// Contact by the distance per axis, sixteen pairs at a time (boxes/box_lanes.h).
std::unique_ptr<Contact> make_box_contact(const Setup& setup, int degree);

/// A Made<D, Degree> of these arguments: axes and degree, known at run time, become template arguments.
/// Requires: axes is 1, 2 or 3; degree is at most 2, and 0 counts as 1.
template <template <int D, int Degree> class Made, class... Arguments>
std::unique_ptr<Contact> make_typed(int axes, int degree, Arguments&&... arguments) {
  return with_axes(axes, [&]<int D>(Axes<D>) -> std::unique_ptr<Contact> {
    if (degree < 2) return std::make_unique<Made<D, 1>>(std::forward<Arguments>(arguments)...);
    return std::make_unique<Made<D, 2>>(std::forward<Arguments>(arguments)...);
  });
}

/// The outlines or meshes of both tables. Null: the rows are what their layout says; for a layout of outlines
/// or meshes these are the smallest rectangles or boxes around them, inflated by r.
template <class Pieces>
struct FormTables {
  const FormRows<Pieces>*a = nullptr, *b = nullptr;
};
using OutlineTables = FormTables<ConvexPieces>;
using MeshTables = FormTables<TriangleTree>;

/// Contact of two outlines, or of one with a point, disc, box or cylinder. If the setup has a window, then
/// the first table is that window, or the zone whose outline it has; a window of a zone is bounded along z
/// alone. `degree`: of the relative motion, at most 2. Requires: two or three axes; the tables outlive the
/// contact.
std::unique_ptr<Contact> make_outline_contact(const Setup& setup, const OutlineTables& outlines, int degree);

/// Contact of two meshes, or of one with a point, ball or box. Surfaces are triangles under a tree of boxes,
/// or the one box of a row's half extents; a solid also touches what is inside it. If the setup has a window,
/// then the first table is that window. `degree`: of the relative motion, at most 2. Requires: three axes, no
/// cylinders and no prisms; the tables outlive the contact.
std::unique_ptr<Contact> make_mesh_contact(const Setup& setup, const MeshTables& meshes, int degree);

}  // namespace foresee
