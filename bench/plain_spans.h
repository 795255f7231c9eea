// Time intervals in which a pair is within half extents along one axis: quadratic formulas in plain double,
// without error bounds.
//
//   const PlainPair<2, 2> pair{row_a, row_b, at};
//   Spans<2> kept = keep_within(Spans<2>::all(3), pair, 0, 1.0);      // |x| <= 1 during [0, 3]
//
// One square root per axis where one is enough.
#pragma once

#include <cmath>

#include "shape/bodies.h"

namespace foresee::bench {

/// Two rows as the motion x + v t + turn t^2 of b relative to a. Both rows have their x, v and a at the same
/// offsets.
template <int D, int Degree>
struct PlainPair {
  const double *a, *b;
  const Offsets& at;

  double x(int j) const { return b[at.x + j] - a[at.x + j]; }
  double v(int j) const { return b[at.v + j] - a[at.v + j]; }
  double turn(int j) const { return Degree < 2 ? 0 : 0.5 * (b[at.a + j] - a[at.a + j]); }
};

/// Disjoint intervals of time: one axis leaves at most two spans of each.
template <int D>
struct Spans {
  double begin[1 << D], end[1 << D];
  int count = 0;

  static Spans all(double h) {
    Spans spans;
    spans.begin[0] = 0, spans.end[0] = h, spans.count = 1;
    return spans;
  }
  /// Requires: not empty.
  double first() const {
    double first = begin[0];
    for (int i = 1; i < count; ++i) first = begin[i] < first ? begin[i] : first;
    return first;
  }
};

/// Adds what lies in [begin, end] to `kept`.
template <int D>
void keep(const Spans<D>& from, double begin, double end, Spans<D>& kept) {
  for (int i = 0; i < from.count; ++i) {
    const double low = begin > from.begin[i] ? begin : from.begin[i];
    const double high = end < from.end[i] ? end : from.end[i];
    if (low <= high) kept.begin[kept.count] = low, kept.end[kept.count++] = high;
  }
}

/// Adds to `kept`, which is empty, where |x + v t + a t^2| <= half.
template <int D>
void keep_within(const Spans<D>& from, double x, double v, double a, double half, Spans<D>& kept) {
  if (a < 0) x = -x, v = -v, a = -a;
  if (a == 0) {
    if (v == 0) {
      if (std::abs(x) <= half) kept = from;
      return;
    }
    const double one = (-half - x) / v, other = (half - x) / v;
    return keep(from, one < other ? one : other, one < other ? other : one, kept);
  }
  const double outer = v * v - 4 * a * (x - half);
  if (outer < 0) return;
  const double scale = 0.5 / a, wide = std::sqrt(outer), inner = v * v - 4 * a * (x + half);
  if (inner <= 0) return keep(from, (-v - wide) * scale, (-v + wide) * scale, kept);
  const double narrow = std::sqrt(inner);
  keep(from, (-v - wide) * scale, (-v - narrow) * scale, kept);
  keep(from, (-v + narrow) * scale, (-v + wide) * scale, kept);
}

/// The times of `from` at which axis j of the pair is within `half`.
template <int D, int Degree>
Spans<D> keep_within(const Spans<D>& from, const PlainPair<D, Degree>& pair, int j, double half) {
  Spans<D> kept;
  keep_within(from, pair.x(j), pair.v(j), pair.turn(j), half, kept);
  return kept;
}

}  // namespace foresee::bench
