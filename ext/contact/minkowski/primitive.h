// Primitives of contact sets: the constraints (constraint/constraint.h) whose numbers are lengths in the rows
// of a pair. These are half spaces along one axis, and balls.
//
// A primitive is written once, in with_polynomial(), for every number type and every degree of the motion.
// Doubles with error bounds (Bounded), DoubleDouble, numbers of 128 bits (Midrad128) and exact numbers
// (Dyadic) run the same lines; degree 0 is the value at one time.
//
// A primitive contains no number of any pair. It names lengths of its contact set (contact_set.h), which each
// stage computes in its own number type. A size may change with time: value + rate tau, where tau is the time
// from `now`.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "contact/constraint/constraint.h"
#include "numbers/coefficients.h"
#include "numbers/exact_conversion.h"

namespace foresee {

/// The number of a length that is always 0. All its bits are set.
constexpr int no_length = -1;

/// A size value + rate tau, as numbers of lengths.
struct Size {
  int value = no_length, rate = no_length;

  bool moves() const { return rate != no_length; }
};

/// The terms of a primitive on one axis.
struct AxisPart {
  int axis = 0;
  int sign = 1;  ///< 1 or -1
  Size at = {};
};

struct Primitive {
  /// half_space: sign x <= size on the one axis of parts[0]. ball: the sum of (x - sign at)^2 over the parts
  /// is <= size^2; `at` is the centre.
  ConstraintKind kind;
  int count = 0;  ///< of parts
  AxisPart parts[3] = {};
  Size size = {};
};

/// A length, or 0. `lengths` gives them by number, for example an array.
template <class T, class Lengths>
T length_at(const Lengths& lengths, int number) {
  if (number == no_length) return T{};
  return lengths[number];
}

/// The coefficients of a size, expanded at tau, which is a double or a register of them. Requires: K is at
/// least the degree of the size, or 0 for its value alone.
template <int K, class T, class Lengths, class TimePoint>
[[gnu::noinline]] Coefficients<T, K> moving_size(const Size& size, const Lengths& lengths,
                                                 const TimePoint& tau) {
  const T rate = length_at<T>(lengths, size.rate);
  Coefficients<T, K> p{};
  p[0] = length_at<T>(lengths, size.value) + T{tau} * rate;
  if constexpr (K >= 1) p[1] = rate;
  return p;
}

/// Subtracts sign times the size from p.
template <int K, class T, class Lengths, class TimePoint>
[[gnu::always_inline]] inline void subtract_size(Coefficients<T, K>& p, const Size& size, int sign,
                                                 const Lengths& lengths, const TimePoint& tau) {
  if (!size.moves()) {
    if (size.value == no_length) return;
    p[0] = sign > 0 ? p[0] - lengths[size.value] : p[0] + lengths[size.value];
    return;
  }
  const Coefficients<T, K> s = moving_size<K, T>(size, lengths, tau);
  for (int k = 0; k <= K; ++k) p[k] = sign > 0 ? p[k] - s[k] : p[k] + s[k];
}

template <int K, class T, class Lengths, class TimePoint>
[[gnu::always_inline]] inline Coefficients<T, K> bound_polynomial(const Primitive& bound,
                                                                  const Coefficients<T, K>* x,
                                                                  const Lengths& lengths,
                                                                  const TimePoint& tau) {
  Coefficients<T, K> p = x[bound.parts[0].axis];
  if (bound.parts[0].sign < 0)
    for (T& c : p) c = -c;
  subtract_size<K>(p, bound.size, 1, lengths, tau);
  return p;
}

/// The squared distance from the centre over Count axes, minus the squared radius.
template <int Count, int K, class T, class Lengths, class TimePoint, class Wanted>
[[gnu::always_inline]] inline Coefficients<T, 2 * K> ball_over(const Primitive& ball,
                                                               const Coefficients<T, K>* x,
                                                               const Lengths& lengths, const TimePoint& tau,
                                                               Wanted&& wanted) {
  MovingSize<T> radius;
  if (ball.size.moves()) {
    const Coefficients<T, K> moving = moving_size<K, T>(ball.size, lengths, tau);
    radius.value = moving[0];
    if constexpr (K > 0) radius.rate = moving[1], radius.moves = true;
  } else {
    radius.value = length_at<T>(lengths, ball.size.value);
  }
  std::array<Coefficients<T, K>, Count> gaps;
  for (std::size_t i = 0; i < Count; ++i) {
    const AxisPart& part = ball.parts[i];
    gaps[i] = x[part.axis];
    subtract_size<K>(gaps[i], part.at, part.sign, lengths, tau);
  }
  return foresee::ball_polynomial<K>(gaps, radius, wanted);
}

/// ball_over() the axes of the ball.
template <int K, class T, class Lengths, class TimePoint, class Wanted>
Coefficients<T, 2 * K> ball_polynomial_of(const Primitive& ball, const Coefficients<T, K>* x,
                                          const Lengths& lengths, const TimePoint& tau, Wanted&& wanted) {
  if (ball.count == 1) return ball_over<1, K>(ball, x, lengths, tau, wanted);
  if (ball.count == 2) return ball_over<2, K>(ball, x, lengths, tau, wanted);
  return ball_over<3, K>(ball, x, lengths, tau, wanted);
}

/// Calls `take` with the polynomial of the primitive, expanded at tau: at most 0 inside. `x`: the relative
/// motion on each axis, also expanded at tau. The degree of balls is 2 K, that of half spaces K.
/// `wanted` is called with the value of a ball at tau. If it returns false, then the other coefficients are
/// unspecified.
template <int K, class T, class Lengths, class TimePoint, class Wanted, class Take>
[[gnu::always_inline]] inline auto with_polynomial(const Primitive& primitive, const Coefficients<T, K>* x,
                                                   const Lengths& lengths, const TimePoint& tau,
                                                   Wanted&& wanted, Take&& take) {
  if (primitive.kind == ConstraintKind::half_space)
    return take(bound_polynomial<K>(primitive, x, lengths, tau));
  return take(ball_polynomial_of<K>(primitive, x, lengths, tau, wanted));
}

/// The polynomial of the primitive, padded with zeros to degree 2 K.
template <int K, class T, class Lengths, class TimePoint>
Coefficients<T, 2 * K> polynomial_of(const Primitive& primitive, const Coefficients<T, K>* x,
                                     const Lengths& lengths, const TimePoint& tau) {
  const auto wanted = [](const T&) { return true; };
  return with_polynomial<K>(primitive, x, lengths, tau, wanted, [](const auto& found) {
    Coefficients<T, 2 * K> all{};
    std::copy(found.begin(), found.end(), all.begin());
    return all;
  });
}

}  // namespace foresee
