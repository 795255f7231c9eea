// When do two touch of which one has an outline? Two outlines, or one and a point, disc, box or cylinder; on
// three axes outlines are those of upright prisms. A class of its own behind the room's door: its sets are
// made pair by pair, from the pieces of both, and not once a statement from a few lengths in the rows.
//
//   const OutlineRows* rows = …;                       // whose pieces are made when a row is first asked for
//   auto contact = make_outline_contact(setup, {.a = rows, .b = nullptr}, degree);
//
// For make_contact() to choose, by the declarations, where a side has outlines: once a statement, so that a
// table without never comes here and pays nothing. Setup and bodies are those of any contact, with what else
// a row says (r, hz) in its place. The stages of a pair: plain doubles, trees of boxes, pieces in doubles
// with error bounds, the crossing in DoubleDouble, exact numbers for the pieces that are left
// (docs/exactness.md).
#pragma once

#include <memory>

#include "contact/contact.h"
#include "contact/set/relative_motion.h"
#include "shape/outline/outline_rows.h"

namespace foresee {

/// Of both tables; null: one without outlines, whose rows are what their layout says. That of a layout of
/// outlines are the smallest rectangles around them, grown by r.
struct OutlineTables {
  const OutlineRows *a = nullptr, *b = nullptr;
};

/// Where the setup has a window the first table is that window, or the zone whose outline it has: then the
/// window bounds it along z alone. `degree`: of the relative motion, at most 2. Requires: two axes, or three,
/// and then the outlines are those of upright prisms; the tables outlive the contact.
std::unique_ptr<Contact> make_outline_contact(const Setup& setup, const OutlineTables& outlines, int degree);

}  // namespace foresee
