// The root of a polynomial that is crossed near a moment, rounded once: a Newton step with an error radius,
// and Ziv's test of what it rounds to. What this cannot tell is NaN.
//
// No branches, and inlined wherever it is used, as DoubleDouble is: loops over lanes become vector code, and
// no copy made for one CPU ends up in the place of another's.
#pragma once

#include <cstdint>

#include "numbers/double_double.h"

namespace foresee {

/// A moment from `now` and absolute, each rounded once.
struct Instant {
  double dt, t;
  bool known() const { return dt == dt && t == t; }
};

/// base + s for every s within `radius` of `step`, rounded; unknown if they round differently. Requires: the
/// radius has 2^-52 |step| more than is needed, for the rounding of step +- radius.
[[gnu::always_inline]] inline Instant rounded_instant(double now, double base, double step, double radius) {
  const double low = base + (step - radius), high = base + (step + radius);
  const DoubleDouble time = sum(now, base);
  const double wider = radius + 4 * unit_roundoff * (__builtin_fabs(time.low) + __builtin_fabs(step));
  const double t_low = time.high + ((time.low + step) - wider);
  const double t_high = time.high + ((time.low + step) + wider);
  const double nan = __builtin_nan("");
  return {low == high ? low : nan, t_low == t_high ? t_low : nan};
}

/// Which way a primitive is crossed: from outside in (the begin of contact) or from inside out (its end).
enum class CrossingDirection : std::uint8_t { entering, leaving };

/// A primitive's polynomial at a moment: value in DoubleDouble, slope and bend in double. Inside: p <= 0.
struct Crossed {
  DoubleDouble value;
  double value_error;  ///< also of what underflow loses: at least 2^-988
  double slope, slope_error;
  double bend;  ///< bound on |p''| / 2 near the moment
};

/// The root of a polynomial known to be crossed in the given way within `width` of `base`, or unknown.
template <CrossingDirection direction>
[[gnu::always_inline]] inline Instant root_of(const Crossed& p, double now, double base, double width) {
  const double steep = direction == CrossingDirection::entering ? -p.slope : p.slope, inverse = 1 / steep;
  const double step = (direction == CrossingDirection::entering ? p.value.high : -p.value.high) * inverse;
  const double far = __builtin_fabs(step), reach = width > 2 * far ? width : 2 * far;
  const double lost = p.value_error + __builtin_fabs(p.value.low) + p.bend * step * step;
  const double radius =
      2 * (lost * inverse) + 2 * far * (p.slope_error * inverse + 8 * unit_roundoff) + 0x1p-1060;
  // Monotone, and at least half as steep as at the base, wherever the root can be. Of what is steeper than
  // 2^1000 the inverse may have lost its digits.
  const bool alone = (steep - p.slope_error - 2 * p.bend * reach > 0.5 * steep) & (steep < 0x1p1000);
  return rounded_instant(now, base, step, alone ? radius : __builtin_nan(""));
}

}  // namespace foresee
