// Contact of what has an outline: two outlines, or one and a point, a box, a prism's flat outline included.
// A class of its own behind the room's door: its sets are made for each pair, from its pieces, and not once a
// statement from a few lengths in the rows. A table that declares no shape never comes here, and pays
// nothing.
//
//   const OutlineRows* rows = …;                       // whose pieces are made when a row is first asked for
//   auto contact = make_outline_contact(setup, {.a = rows, .b = nullptr}, degree);
//
// make_contact() chooses it where a side declares `shape`; setup and bodies are those of any contact, with
// the rest of a row (r, hz) in its place. The stages of a pair: trees of boxes, pieces in doubles with error
// bounds, the crossing in DoubleDouble, exact numbers for the pieces that are left (docs/exactness.md).
#pragma once

#include <memory>

#include "contact/contact.h"
#include "contact/set/relative_motion.h"
#include "shape/outline/convex_pieces.h"

namespace foresee::contact {

/// Who knows the outlines of a table's rows. Asked by several threads at a time.
class OutlineRows {
 public:
  virtual ~OutlineRows() = default;
  /// The pieces of this row's outline as it lies, which live as long as this; null: it has none, and is the
  /// point, disc or cylinder that its sizes say.
  virtual const ConvexPieces* pieces(std::size_t row) const = 0;
};

/// Of both tables; null: one without outlines, whose rows are what their layout says.
struct OutlineTables {
  const OutlineRows *a = nullptr, *b = nullptr;
};

/// `degree`: of the relative motion, at most 2. Requires: two axes, or three, and then the outlines are those
/// of upright prisms; the tables outlive the contact.
std::unique_ptr<Contact> make_outline_contact(const Setup& setup, const OutlineTables& outlines, int degree);

}  // namespace foresee::contact
