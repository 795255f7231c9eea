// When do two touch of which one has an outline? Two outlines, or one and a point, disc, box or cylinder; on
// three axes outlines are those of upright prisms. A class of its own behind the room's door: its sets are
// made pair by pair, from the pieces of both, and not once a statement from a few lengths in the rows.
//
//   const OutlineRows* rows = …;                       // whose pieces are made when a row is first asked for
//   auto contact = make_outline_contact(setup, {.a = rows, .b = nullptr}, degree);
//
// For make_contact() to choose, by the declarations, where a side has outlines: once a statement, so that a
// table without never comes here and pays nothing. Setup and bodies are those of any contact, with what else
// a row says (r, hz) in its place. The stages of a pair: trees of boxes, pieces in doubles with error bounds,
// the crossing in DoubleDouble, exact numbers for the pieces that are left (docs/exactness.md).
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
