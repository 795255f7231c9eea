#include "contact/certified/uncertain_interval.h"

#include <algorithm>

namespace foresee {
namespace {

/// At most one short interval around the turning point, for a convex polynomial whose discriminant has no
/// certain sign.
SublevelIntervals near_turn(const Bounded& p1, const Bounded& p2, const Bounded& discriminant) {
  const double half = std::sqrt(std::abs(discriminant.value) + discriminant.error);
  const Enclosure time = enclosure_of(Bounded{-p1.value, p1.error + half * (1 + 0x1p-40)} / twice(p2));
  return SublevelIntervals::one({{time.low, unbounded}, {-unbounded, time.high}});
}

}  // namespace

SublevelIntervals sublevel_intervals(const Coefficients<Bounded, 2>& p, double lost, double length) {
  if (p[2].value == 0 && p[2].error == 0)
    return sublevel_intervals(Coefficients<Bounded, 1>{p[0], p[1]}, lost, length);
  const Bounded p0 = with_lost(p[0], lost), p1 = with_lost(p[1], lost), p2 = with_lost(p[2], lost);
  const int lead = certain_sign(p2);
  if (lead == 0) {  // the quadratic term counts as an error of the linear polynomial
    // The square of a time may underflow where this product does not.
    const double bent = length * (length * (std::abs(p2.value) + p2.error)) * (1 + 0x1p-40);
    return sublevel_of_line({p0.value, p0.error + bent}, p1, length);
  }
  const Bounded discriminant = with_lost(square(p1) - twice(twice(p0 * p2)), lost);
  if (discriminant.value < -discriminant.error)
    return lead > 0 ? SublevelIntervals::never() : SublevelIntervals::one(UncertainInterval::always());
  // Below, the discriminant is far enough from 0 for its root to be a divisor.
  if (!(discriminant.value > 4 * discriminant.error))
    return lead > 0 ? near_turn(p1, p2, discriminant) : SublevelIntervals::one(UncertainInterval::in_doubt());
  const Bounded root = sqrt(discriminant), sum = p1.value < 0 ? root - p1 : -(p1 + root);
  Enclosure one = enclosure_of(sum / twice(p2)), other = enclosure_of(twice(p0) / sum);
  if (other.low < one.low) std::swap(one, other);
  if (one.meets(other)) return SublevelIntervals::one(UncertainInterval::in_doubt());
  if (lead > 0) return SublevelIntervals::one({one, other});
  return {
      {UncertainInterval{{-unbounded, -unbounded}, one}, UncertainInterval{other, {unbounded, unbounded}}},
      2};
}

void IntervalUnion::keep_each(const SublevelIntervals& other) {
  kept_.clear();
  for (const UncertainInterval& interval : list_)
    for (int i = 0; i < other.count; ++i) {
      const UncertainInterval both = overlap(interval, other.list[static_cast<std::size_t>(i)]);
      if (both.is_possible()) kept_.push_back(both);
    }
  list_.swap(kept_);
}

}  // namespace foresee
