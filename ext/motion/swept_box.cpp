// Error analysis of the bounds
// ----------------------------
// On one axis the centre is f(s) = x + s (v + a s / 2) for the time s since the object's own t, and s runs
// over [s0, s1] with 0 <= s0, s1 <= S = |now - t| + h. The extremes of f are at s0, at s1, or at the turning
// point -v/a if it lies between. The turning point is clamped into [s0, s1], so that all three can always be
// evaluated.
//
// Let u = 2^-53 (doubled, so that it holds in every rounding mode) and M = |x| + |v| S + |a| S^2. The losses
// of plain double arithmetic are:
//  - s0 and s1 come from at most two roundings: each is off by at most 2u S, which moves f by at most
//    (|v| + |a| S) 2u S <= 2u M. This covers a minimum taken with until, and a turning point clamped to an
//    end that is itself off.
//  - Evaluating f: x goes through one rounding, v s through three, a s^2 / 2 through four: at most 3u M.
//  - The turning point is off by u|v/a|; since f is flat there, this moves f by u^2 |a| S^2 only.
//  - Underflow: each of a s, a s / 2 and the product with s loses at most 2^-1074: together (S + 4) 2^-1073.
// 16u M + (S + 4) 2^-1020 is more than twice the sum, which covers the roundings of the pad itself. The power
// of two is a normal number on purpose: an operation on subnormal ones costs a hundred cycles.
#include "motion/swept_box.h"

#include <algorithm>

namespace foresee {

Ends swept_axis(double x, double v, double a, const LifeInterval& life, double below, double above) {
  constexpr double u = 0x1p-53;
  if (v == 0 && a == 0) return grown(x, x, below, above);
  auto place = [=](double s) { return x + s * (v + a * s * 0.5); };
  const double first = place(life.begin), last = place(life.end);
  double lower = std::min(first, last), upper = std::max(first, last);
  if (a != 0) {
    const double turn = place(std::clamp(-v / a, life.begin, std::max(life.begin, life.end)));
    lower = std::min(lower, turn);
    upper = std::max(upper, turn);
  }
  const double reach = life.reach;
  const double magnitude = std::abs(x) + reach * (std::abs(v) + std::abs(a) * reach);
  const double pad = 16 * u * magnitude + (reach + 4) * 0x1p-1020;
  // Not finite if the path overflows anywhere, and then neither bound is finite.
  const double nothing = (first - first) + (last - last);
  return grown(lower, upper, pad + below + nothing, pad + above + nothing);
}

}  // namespace foresee
