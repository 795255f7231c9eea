// The sign of the slope of the distance between two centres, and isolated minima of the distance, certified
// in double arithmetic.
//
// The slope is that of half the squared distance, x . x' for the relative motion x: at most a cubic in time.
// Value and derivative at both ends of an interval give its Bernstein coefficients there. Without a change of
// sign among them the slope has no root in the interval; with one change it has exactly one. A coefficient
// whose sign is uncertain counts as either sign.
//
// Source: Farouki, "The Bernstein polynomial basis: a centennial retrospective" (2012), section 5.
#pragma once

#include "contact/certified/certain_motion.h"
#include "contact/certified/root_bracketing.h"

namespace foresee {

/// The slope at a time and its derivative, each with a bound on its error.
struct Slope {
  double value = 0, value_error = 0;
  double growth = 0, growth_error = 0;

  /// -1, 1, or 0 if the error bound does not decide the sign.
  int sign() const { return value > value_error ? 1 : value < -value_error ? -1 : 0; }
};

template <int D>
Slope slope_of(const CertainMotion<D>& motion) {
  constexpr double u = unit_roundoff;
  Slope s;
  for (const CertainAxisMotion<double>& w : motion.axis) {
    const double x = std::abs(w.x), v = std::abs(w.v), a = std::abs(w.a);
    s.value += w.x * w.v;
    s.value_error += x * w.ev + v * w.ex + w.ex * w.ev + 8 * u * (x * v);
    s.growth += w.v * w.v + 2 * (w.a * w.x);
    s.growth_error +=
        w.ev * (2 * v + w.ev) + 2 * (a * w.ex + x * w.ea + w.ea * w.ex) + 8 * u * (v * v + 2 * (a * x));
  }
  // Increased by more than the rounding errors of these sums and their underflow.
  constexpr double more = 1 + 0x1p-40, underflow = 0x1p-1060;
  s.value_error = more * s.value_error + underflow;
  s.growth_error = more * s.growth_error + underflow;
  return s;
}

/// Whether an interval of the given length has a minimum: the slope has exactly one root, and changes there from
/// negative to positive. `a` and `b`: the slope at its ends.
inline Verdict has_valley(const Slope& a, const Slope& b, double length) {
  const int first = a.sign(), last = b.sign();
  if (first == 0 || last == 0) return Verdict::uncertain;
  auto inner = [length](const Slope& s, double side) {
    const double third = length / 3;
    const double rise = third * std::abs(s.growth);
    return Slope{
        s.value + side * third * s.growth,
        s.value_error + third * s.growth_error + 8 * unit_roundoff * (std::abs(s.value) + rise) + 0x1p-1060}
        .sign();
  };
  const int second = inner(a, 1), third = inner(b, -1);
  if (first == last) return second == first && third == first ? Verdict::no : Verdict::uncertain;
  if (second != first && third != last) return Verdict::uncertain;
  return first < 0 ? Verdict::yes : Verdict::no;
}

}  // namespace foresee
