// Root bracketing with certified signs: for how long a polynomial certainly stays positive, and a bracket
// around the time at which it changes its sign. One Newton step gives that time as a correctly rounded double
// (numbers/crossed_root.h).
//
// Coefficients have bounds on their errors (Bounded). Only the value at one time and those bounds are used: a
// computed root is never trusted, the result stops short of it. Time advances in steps, each as long as a
// sign is certain. Then a time shortly after is searched at which the opposite is certain; both times bracket
// the crossing.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "numbers/coefficients.h"
#include "numbers/crossed_root.h"

namespace foresee {

/// The answer of arithmetic with error bounds.
enum class Verdict : std::uint8_t { no, yes, uncertain };

constexpr double not_certain = -1;
constexpr double unbounded = std::numeric_limits<double>::infinity();

/// The interval [begin, end]; empty if end < begin.
template <class Real>
struct Interval {
  Real begin, end;
};

/// s such that p0 + p1 t + p2 t^2 > 0 for all t in [0, s). Requires p0 > 0. NaN and overflow give 0.
inline double positive_for(double p0, double p1, double p2) {
  if (p1 >= 0 && p2 >= 0) return unbounded;
  const double square = p1 * p1, product = 4 * p2 * p0;
  // The discriminant is increased by more than its error, so that the result never passes a root.
  const double raised = square - product + 8 * unit_roundoff * (square + std::abs(product)) + 0x1p-1000;
  if (raised < 0) return unbounded;
  if (!(raised < unbounded)) return 0;
  constexpr double less = 1 - 32 * unit_roundoff;
  // With p1 > 0 (and p2 < 0) no cancellation occurs in either sum; the possible underflow is subtracted.
  if (p1 > 0) return less * ((p1 + std::sqrt(std::max(0.0, square - product - 0x1p-1070))) / (-2 * p2));
  return less * (p0 / (0.5 * (std::sqrt(raised) - p1)));
}

/// positive_for() of p0 + p1 t.
inline double linear_positive_for(double p0, double p1) {
  if (p1 >= 0) return unbounded;
  const double root = (1 - 32 * unit_roundoff) * (p0 / -p1);
  return root > 0 ? root : 0;
}

/// A certified lower bound of c2 + c3 s + c4 s^2 on [0, length].
inline double min_bend(double c2, double c3, double c4, double length) {
  const double slack = 16 * unit_roundoff * (std::abs(c2) + length * (std::abs(c3) + length * std::abs(c4)));
  const double at_end = c2 + length * (c3 + length * c4);
  double lower = std::min(c2, at_end);
  // The minimum, where c4 > 0. A square of c3 could underflow where this does not.
  if (c3 < 0 && -c3 < 2 * c4 * length) lower = std::min(lower, c2 - c3 * (0.25 * (c3 / c4)));
  return lower - slack;
}

/// s up to which f0 + f1 s + (bend on [0, length]) s^2 stays positive, searched with shorter and shorter
/// lengths.
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

/// For how long p(s) (or -p(s) with side -1) certainly stays positive; not_certain if it may not be positive
/// now. Only the next `room` is searched: a result above that is `unbounded`. `lost`: bound on the underflow
/// of a coefficient.
template <std::size_t N>
[[gnu::always_inline]] inline double positive_during(const std::array<Bounded, N>& p, double side,
                                                     double lost, double room) {
  const auto lower = [&](std::size_t k) { return side * p[k].value - p[k].error_bound(lost); };
  const double now = lower(0);
  if (!(now > 0)) return not_certain;
  if constexpr (N == 2) return linear_positive_for(now, lower(1));
  if constexpr (N == 3) return positive_for(now, lower(1), lower(2));
  if constexpr (N == 5) {
    const double c2 = lower(2), c3 = lower(3), c4 = lower(4);
    const double step = bent_positive_for(
        now, lower(1), room, [c2, c3, c4](double length) { return min_bend(c2, c3, c4, length); });
    return step < room ? step : unbounded;
  }
}

/// A certain crossing: apart (or within) up to `before`, the opposite at `after`. Both are the limit if there
/// is no crossing.
struct Bracket {
  double before = 0, after = 0;
};

constexpr int max_leaps = 48;

/// The end of a step from tau, rounded down so that the property is still certain there.
inline double after_leap(double tau, double step) {
  return (tau + step) * (1 - 4 * unit_roundoff) - 0x1p-1060;
}

/// The time up to which a property is certain; unbounded if it is certain on the whole of [tau, end].
/// predicate(tau) returns for how long it is certain from tau on, below 0 if it is not certain at tau.
template <class Predicate>
double leap(Predicate&& predicate, double tau, double end) {
  for (int leaps = 0; leaps < max_leaps; ++leaps) {
    const double step = predicate(tau);
    if (!(step >= 0)) return tau;
    const double next = after_leap(tau, step);
    if (next > end) return unbounded;
    if (!(next > tau)) return tau;
    tau = next;
    if (step < 0x1p-40 * tau) return tau;  // as near to the crossing as a bracket needs to be
  }
  return tau;
}

/// Searches for a time just after bracket.before, not before `earliest`, at which `predicate` holds. If one
/// is found, it becomes bracket.after, else bracket.after is `end`.
template <class Predicate>
bool witness(Predicate&& predicate, Bracket& bracket, double earliest, double end) {
  double step = bracket.before > 0 ? 0x1p-48 * bracket.before : 0x1p-60 * end;
  for (int attempt = 0; attempt < 9; ++attempt, step *= 64) {
    const double tau = std::max(bracket.before + (attempt == 0 ? 0 : step), earliest);
    if (tau > end) break;
    if (!predicate(tau)) continue;
    bracket.after = tau;
    return true;
  }
  bracket.after = end;
  return end >= earliest && predicate(end);
}

/// When a polynomial p, by powers of the time after `base`, changes its sign within `width` of it: its root,
/// rounded once, or unknown. `value` is p[0] in DoubleDouble.
template <CrossingDirection direction, std::size_t N>
Instant rounded_crossing(const std::array<Bounded, N>& p, const DoubleDouble& value, double underflow,
                         double now, double base, double width) {
  const double lost = underflow + 0x1p-1060, slope = p[1].value;
  // DoubleDouble loses at most 2^-97 of what the double bound counts in 2^-53.
  const double error = p[0].error_bound(lost) * 0x1p-44 + underflow;
  const double span = std::max(width, 2 * std::abs(value.high / slope));
  double bend = 0, weight = 1;  // bend: an upper bound on |p''| / 2 over the span
  for (std::size_t k = 2; k < N; ++k, weight *= span)
    bend += weight * static_cast<double>(k * (k - 1)) * (std::abs(p[k].value) + p[k].error_bound(lost));
  return root_of<direction>({value, error, slope, p[1].error_bound(lost), bend}, now, base, width);
}

}  // namespace foresee
