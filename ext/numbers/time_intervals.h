// Time intervals on which a polynomial is at most 0 (a sublevel set), with algebraic roots as exact ends.
//
// Degree 1 and 2 use the formula; a discriminant whose sign is unknown in 128 bits is computed exactly.
// Degree 3 and 4 use the slope: the polynomial is monotone between the zeros of its slope. Its signs there
// say where it has roots, and that it has no others. No bound on the separation of roots is needed, because a
// sign in doubt is computed exactly.
#pragma once

#include <vector>

#include "numbers/algebraic_root.h"

namespace foresee {

/// A closed interval; a single time if both ends are the same root.
struct TimeInterval {
  AlgebraicRoot *first, *last;
};

/// Disjoint and in order of time.
using TimeIntervals = std::vector<TimeInterval>;

/// The time interval of a query. Requires: begin <= end.
struct QueriedInterval {
  AlgebraicRoot &begin, &end;
};

struct Roots {
  std::array<AlgebraicRoot*, LazyPolynomial::max_degree> list;
  int count = 0;
};

/// The zeros of a polynomial strictly within the queried interval, in order. Call it once per polynomial.
Roots zeros_within(LazyPolynomial& polynomial, const QueriedInterval& queried);

TimeIntervals sublevel_intervals(LazyPolynomial& polynomial, const QueriedInterval& queried);

/// The closure of the complement within the queried interval. It leaves out single times at which a
/// polynomial only touches 0 from below. A root at an end of the queried interval may be an interval of one
/// time.
TimeIntervals complement(const TimeIntervals& inside, const QueriedInterval& queried);

/// The intersection of both.
TimeIntervals common(const TimeIntervals& a, const TimeIntervals& b);

}  // namespace foresee
