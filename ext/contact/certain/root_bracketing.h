// Time in leaps, each as long as something is certain; then a moment shortly after at which the opposite is.
// What lies between encloses the change.
#pragma once

#include <algorithm>

#include "contact/certain/positive_duration.h"

namespace foresee {

/// A crossing that is certain: apart (or within) up to `before`, the opposite at `after`. Both equal the
/// limit where there is none.
struct Bracket {
  double before = 0, after = 0;
};

constexpr int max_leaps = 48;

/// Where a leap from tau surely ends in what is certain.
inline double after_leap(double tau, double step) {
  return (tau + step) * (1 - 4 * unit_roundoff) - 0x1p-1060;
}

/// The moment up to which what `predicate` tells stays certain; for_ever if it does for the whole of [tau, end].
/// ask(tau) says for how long from tau on, below 0 if not even then.
template <class Predicate>
double leap(Predicate&& predicate, double tau, double end) {
  for (int leaps = 0; leaps < max_leaps; ++leaps) {
    const double step = predicate(tau);
    if (!(step >= 0)) return tau;
    const double next = after_leap(tau, step);
    if (next > end) return for_ever;
    if (!(next > tau)) return tau;
    tau = next;
    if (step < 0x1p-40 * tau) return tau;  // as near to the crossing as a bracket needs to be
  }
  return tau;
}

/// Looks just behind bracket.before, from `earliest` on, for a moment at which `predicate` is certain: if there is
/// one, it is bracket.after, else that is `end`.
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

}  // namespace foresee
