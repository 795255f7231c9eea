// Contact decided and timed exactly: the last word where certified doubles cannot tell.
//
// Every polynomial is at most 0 during some intervals of time, whose ends are algebraic roots; a piece of the
// contact set holds where all of its polynomials' intervals meet, and the set is the union of its pieces.
// Ends are compared exactly and only the answer's are rounded, once. Cost: microseconds where 128 bits tell,
// some microseconds more for each tie.
#pragma once

#include <functional>
#include <optional>

#include "contact/contact.h"
#include "contact/exact/pair_polynomials.h"

namespace foresee {

/// The exact ends of the moments asked about, measured from now.
struct ExactLifetime {
  Dyadic begin, end;
  Dyadic now;
  PairLifetime rounded;
};
ExactLifetime exact_lifetime_of(const Setup& setup, const double* row_a, const double* row_b);

/// Does the pair touch at some moment asked about? Polynomials can be asked for one answer.
bool exact_touches(PiecePolynomials& polynomials, const ExactLifetime& lifetime);

/// Begin and end of the first contact, if there is one.
std::optional<ContactTimes> exact_times(PiecePolynomials& polynomials, const ExactLifetime& lifetime);

/// Some pieces of a set that hold, until a moment, whenever any of them all does.
struct NeededPieces {
  std::vector<std::uint32_t> pieces;  ///< by their numbers
  double until;  ///< measured from now; later than all that is asked about where they are enough for that
};

/// The fewest that are enough; no more than `limit` of them, but until then, where those begin one by one.
NeededPieces needed_pieces(PiecePolynomials& polynomials, const ExactLifetime& lifetime, std::size_t limit);

/// Whether two touch at a moment at which no piece holds.
using TouchesBetween = std::function<bool(const Dyadic& time)>;

/// The same where contact may go on after pieces and between them: as `between` says, which is asked at one
/// moment each.
std::optional<ContactTimes> exact_times_of_solids(PiecePolynomials& polynomials,
                                                  const ExactLifetime& lifetime,
                                                  const TouchesBetween& between);

}  // namespace foresee
