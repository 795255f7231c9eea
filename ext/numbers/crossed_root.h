// One Newton step to a polynomial's root near a given time, correctly rounded or NaN.
//
// The step has an error radius; Ziv's test checks whether all of it rounds to one double. If not, the result
// is NaN. The functions have no branches and are always inlined, like DoubleDouble. Loops over lanes then
// become vector code, and no copy made for one CPU replaces that of another.
#pragma once

#include <cstdint>

#include "numbers/double_double.h"

namespace foresee {

/// A time relative to `now` and as an absolute one, each rounded once.
struct Instant {
  double dt, t;
  bool known() const { return !__builtin_isnan(dt) && !__builtin_isnan(t); }
};

[[gnu::always_inline]] inline Instant unknown_instant() {
  return {__builtin_nan(""), __builtin_nan("")};
}
/// The later of two instants, and the earlier; unknown if one of them is.
[[gnu::always_inline]] inline Instant later(const Instant& a, const Instant& b) {
  if (!a.known() || !b.known()) return unknown_instant();
  return {a.dt < b.dt ? b.dt : a.dt, a.t < b.t ? b.t : a.t};
}
[[gnu::always_inline]] inline Instant earlier(const Instant& a, const Instant& b) {
  if (!a.known() || !b.known()) return unknown_instant();
  return {b.dt < a.dt ? b.dt : a.dt, b.t < a.t ? b.t : a.t};
}

/// base + s, rounded, for every s within `radius` of `step`; unknown if not all round alike. Requires: the
/// radius includes a surplus of 2^-52 |step|, for the rounding of step +- radius.
[[gnu::always_inline]] inline Instant rounded_instant(double now, double base, double step, double radius) {
  const double low = base + (step - radius), high = base + (step + radius);
  const DoubleDouble time = sum(now, base);
  const double wider = radius + 4 * unit_roundoff * (__builtin_fabs(time.low) + __builtin_fabs(step));
  const double t_low = time.high + ((time.low + step) - wider);
  const double t_high = time.high + ((time.low + step) + wider);
  const double nan = __builtin_nan("");
  return {low == high ? low : nan, t_low == t_high ? t_low : nan};
}

/// Direction in which a primitive is crossed: from outside in (contact starts) or from inside out (it ends).
enum class CrossingDirection : std::uint8_t { entering, leaving };

/// A primitive's polynomial p at a time: value in DoubleDouble, slope and bend in double. Inside: p <= 0.
struct Crossed {
  DoubleDouble value;
  double value_error;  ///< includes underflow: at least 2^-988
  double slope, slope_error;
  double bend;  ///< bound on |p''| / 2 near that time
};

/// The root of a polynomial known to be crossed in this direction within `width` of `base`, or unknown.
template <CrossingDirection direction>
[[gnu::always_inline]] inline Instant root_of(const Crossed& p, double now, double base, double width) {
  const double steep = direction == CrossingDirection::entering ? -p.slope : p.slope, inverse = 1 / steep;
  const double step = (direction == CrossingDirection::entering ? p.value.high : -p.value.high) * inverse;
  const double far = __builtin_fabs(step), reach = width > 2 * far ? width : 2 * far;
  const double lost = p.value_error + __builtin_fabs(p.value.low) + p.bend * step * step;
  const double radius =
      2 * (lost * inverse) + 2 * far * (p.slope_error * inverse + 8 * unit_roundoff) + 0x1p-1060;
  // Monotone, and at least half as steep as at the base, wherever the root can be. Beyond a slope of 2^1000
  // its inverse may have lost its digits.
  const bool alone = (steep - p.slope_error - 2 * p.bend * reach > 0.5 * steep) & (steep < 0x1p1000);
  return rounded_instant(now, base, step, alone ? radius : __builtin_nan(""));
}

}  // namespace foresee
