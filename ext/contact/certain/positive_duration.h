// For how long does a polynomial certainly stay positive, from double arithmetic?
//
// Coefficients come with bounds on their errors. Only the value at one moment and those bounds are used:
// roots are never trusted, only stayed short of.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "numbers/coefficients.h"

namespace foresee {

constexpr double not_certain = -1;
constexpr double for_ever = std::numeric_limits<double>::infinity();

/// From `begin` to `end`; never if end < begin.
template <class Real>
struct Interval {
  Real begin, end;
};

/// s such that p0 + p1 t + p2 t^2 > 0 for all t in [0, s). Requires p0 > 0. NaN and overflow give 0.
inline double positive_for(double p0, double p1, double p2) {
  if (p1 >= 0 && p2 >= 0) return for_ever;
  const double square = p1 * p1, product = 4 * p2 * p0;
  // The discriminant is raised by more than it can be off, so that a root is never missed and never overshot.
  const double raised = square - product + 8 * unit_roundoff * (square + std::abs(product)) + 0x1p-1000;
  if (raised < 0) return for_ever;
  if (!(raised < for_ever)) return 0;
  constexpr double less = 1 - 32 * unit_roundoff;
  // With p1 > 0 (and p2 < 0) nothing cancels in either sum; what underflow may have added is taken off.
  if (p1 > 0) return less * ((p1 + std::sqrt(std::max(0.0, square - product - 0x1p-1070))) / (-2 * p2));
  return less * (p0 / (0.5 * (std::sqrt(raised) - p1)));
}

/// The same for p0 + p1 t.
inline double linear_positive_for(double p0, double p1) {
  if (p1 >= 0) return for_ever;
  const double root = (1 - 32 * unit_roundoff) * (p0 / -p1);
  return root > 0 ? root : 0;
}

/// Least value that c2 + c3 s + c4 s^2 certainly keeps on [0, length].
inline double min_bend(double c2, double c3, double c4, double length) {
  const double slack = 16 * unit_roundoff * (std::abs(c2) + length * (std::abs(c3) + length * std::abs(c4)));
  const double at_end = c2 + length * (c3 + length * c4);
  double least = std::min(c2, at_end);
  // Its lowest point, where c4 > 0. A square of c3 could vanish where this does not.
  if (c3 < 0 && -c3 < 2 * c4 * length) least = std::min(least, c2 - c3 * (0.25 * (c3 / c4)));
  return least - slack;
}

/// s up to which f0 + f1 s + (bend on [0, length]) s^2 stays positive, looked for with ever shorter lengths.
template <class Bend>
double bent_positive_for(double f0, double f1, double room, Bend bend) {
  double best = 0;
  double length = room;
  for (int attempt = 0; attempt < 6; ++attempt) {
    const double step = std::min(positive_for(f0, f1, bend(length)), length);
    best = std::max(best, step);
    if (!(step < 0.125 * length) || step <= 0) break;
    length = 4 * step;
  }
  return best;
}

/// How long p(s) (or -p(s) with side -1) certainly stays positive; not_certain if it may not be now. Looked
/// for during the next `room`; the answer may exceed that only by being for ever. `lost`: what underflow
/// takes from a coefficient.
template <std::size_t N>
[[gnu::always_inline]] inline double positive_during(const std::array<Bounded, N>& p, double side,
                                                     double lost, double room) {
  const auto least = [&](std::size_t k) { return side * p[k].value - p[k].error_bound(lost); };
  const double now = least(0);
  if (!(now > 0)) return not_certain;
  if constexpr (N == 2) return linear_positive_for(now, least(1));
  if constexpr (N == 3) return positive_for(now, least(1), least(2));
  if constexpr (N == 5) {
    const double c2 = least(2), c3 = least(3), c4 = least(4);
    const double step = bent_positive_for(
        now, least(1), room, [c2, c3, c4](double length) { return min_bend(c2, c3, c4, length); });
    return step < room ? step : for_ever;
  }
}

}  // namespace foresee
