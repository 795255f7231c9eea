#include "contact/outline_contact.h"

#include <algorithm>

#include "contact/outline/flat_kit.h"
#include "contact/pieces/union_contact.h"
#include "contact/pieces/window_near.h"

namespace foresee::contact {
namespace {

/// What the row of a table looks like.
void take_row(ObjectPieces& pieces, const Bodies& bodies, const OutlineRows* outlines, std::size_t i) {
  const ConvexPieces* const known = outlines ? outlines->pieces(i, pieces.own()) : nullptr;
  if (known) return pieces.take(*known);
  const double* const row = bodies.row(i);
  const Offsets& at = bodies.at;
  if (!outlines && at.bounds != Offsets::absent) {
    const double* const bounds = row + at.bounds;
    return pieces.take_box({Vec<2>(bounds[0], bounds[1]), Vec<2>(bounds[2], bounds[3])});
  }
  if (at.half == Offsets::absent) return pieces.take_point();
  pieces.take_box(row[at.half], row[at.half + 1]);
}

}  // namespace

template <int D, int Degree>
void FlatKit<D, Degree>::take(Pieces& a, Pieces& b, const Setup& setup, const Tables& tables,
                              const Pair& pair) {
  if (setup.window && !tables.a)
    a.take_box(window_near<2>(setup, setup.b.row(pair.b)));
  else
    take_row(a, setup.a, tables.a, pair.a);
  take_row(b, setup.b, tables.b, pair.b);
  if (a.is_point() && b.is_point()) a.take_box(0, 0);  // a sum needs edges
}

std::unique_ptr<Contact> make_outline_contact(const Setup& setup, const OutlineTables& outlines, int degree) {
  if (setup.a.layout.axes < 3) {
    if (degree < 2) return std::make_unique<UnionContact<FlatKit<2, 1>>>(setup, outlines);
    return std::make_unique<UnionContact<FlatKit<2, 2>>>(setup, outlines);
  }
  if (degree < 2) return std::make_unique<UnionContact<FlatKit<3, 1>>>(setup, outlines);
  return std::make_unique<UnionContact<FlatKit<3, 2>>>(setup, outlines);
}

}  // namespace foresee::contact
