// When is a polynomial at most 0? All its intervals of the time asked about, with algebraic roots as ends.
//
// Degree 1 and 2 by the formula; a discriminant whose sign 128 bits cannot tell is taken exactly.
// Degree 3 and 4 by their slope: between its zeros the polynomial runs one way, so its signs there say where
// it has roots and that there are no others. No bound on how near roots may lie to each other is needed, as a
// sign in doubt is asked exactly.
#pragma once

#include <vector>

#include "numbers/algebraic_root.h"

namespace foresee {

/// Closed; a single moment where both ends are the same root.
struct TimeInterval {
  AlgebraicRoot *first, *last;
};

/// In order of time and apart from each other.
using TimeIntervals = std::vector<TimeInterval>;

/// The moments asked about. Requires: begin <= end.
struct QueriedInterval {
  AlgebraicRoot &begin, &end;
};

struct Roots {
  std::array<AlgebraicRoot*, LazyPolynomial::max_degree> list;
  int count = 0;
};

/// Where a polynomial is 0, in order and strictly within the moments asked about. To be asked once.
Roots zeros_within(LazyPolynomial& polynomial, const QueriedInterval& queried);

TimeIntervals sublevel_intervals(LazyPolynomial& polynomial, const QueriedInterval& queried);

/// What lies between intervals, with the ends that they share. Single times at which a polynomial only
/// touches 0 from below are left out; a root at an end of what is asked about may be an interval of one time.
TimeIntervals complement(const TimeIntervals& inside, const QueriedInterval& queried);

/// The moments that are in both.
TimeIntervals common(const TimeIntervals& a, const TimeIntervals& b);

}  // namespace foresee
