// Primitives of contact sets: half spaces, strips and balls, each a polynomial in time that is at most 0
// inside.
//
// A primitive is written once, in with_polynomial(), for every number type and every degree of the motion.
// Doubles with error bounds (Bounded), DoubleDouble, numbers of 128 bits (Midrad128) and exact numbers
// (Dyadic) run the same lines; degree 0 is the value at one time. A new primitive is a new Kind and its
// polynomial there.
//
// A primitive contains no number of any pair. It names lengths of its contact set (contact_set.h), which each
// stage computes in its own number type. A size may change with time: value + rate tau, where tau is the time
// from `now`.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

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
  int normal = no_length;  ///< the number of a length
};

struct Primitive {
  enum class Kind : std::uint8_t {
    bound,       ///< sign x <= size on the one axis of parts[0]
    half_space,  ///< the sum of sign normal (x - at) over the parts is <= size: one side of a line at `at`
    strip,       ///< the square of that sum is <= size^2 times the sum of normal^2: within size of the line
    ball         ///< the sum of (x - sign at)^2 over the parts is <= size^2; `at` is the centre
  };
  Kind kind;
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

/// Adds the square of q to the coefficients of p, except for p[0].
template <int K, class T>
[[gnu::always_inline]] inline void add_square_above(Coefficients<T, 2 * K>& p, const Coefficients<T, K>& q) {
  if constexpr (K == 1) {
    p[1] = p[1] + twice(q[0] * q[1]);
    p[2] = p[2] + square(q[1]);
  }
  if constexpr (K == 2) {
    p[1] = p[1] + twice(q[0] * q[1]);
    p[2] = p[2] + (square(q[1]) + twice(q[0] * q[2]));
    p[3] = p[3] + twice(q[1] * q[2]);
    p[4] = p[4] + square(q[2]);
  }
}

/// The signed distance from the line through `at`, times the length of the normal.
template <int K, class T, class Lengths, class TimePoint>
Coefficients<T, K> line_polynomial(const Primitive& line, const Coefficients<T, K>* x, const Lengths& lengths,
                                   const TimePoint& tau) {
  Coefficients<T, K> p{};
  for (int i = 0; i < line.count; ++i) {
    const AxisPart& part = line.parts[i];
    const T length = length_at<T>(lengths, part.normal), normal = part.sign > 0 ? length : -length;
    Coefficients<T, K> gap = x[part.axis];
    subtract_size<K>(gap, part.at, 1, lengths, tau);
    for (int k = 0; k <= K; ++k) p[k] = p[k] + normal * gap[k];
  }
  return p;
}

template <int K, class T, class Lengths, class TimePoint>
Coefficients<T, K> half_space_polynomial(const Primitive& space, const Coefficients<T, K>* x,
                                         const Lengths& lengths, const TimePoint& tau) {
  Coefficients<T, K> p = line_polynomial<K>(space, x, lengths, tau);
  subtract_size<K>(p, space.size, 1, lengths, tau);
  return p;
}

template <int K, class T, class Lengths, class TimePoint>
Coefficients<T, 2 * K> strip_polynomial(const Primitive& strip, const Coefficients<T, K>* x,
                                        const Lengths& lengths, const TimePoint& tau) {
  const Coefficients<T, K> line = line_polynomial<K>(strip, x, lengths, tau);
  T width{};
  for (int i = 0; i < strip.count; ++i) width = width + square(length_at<T>(lengths, strip.parts[i].normal));
  Coefficients<T, 2 * K> p{};
  if (!strip.size.moves()) {
    p[0] = square(line[0]) - square(length_at<T>(lengths, strip.size.value)) * width;
    add_square_above<K>(p, line);
    return p;
  }
  const Coefficients<T, K> half = moving_size<K, T>(strip.size, lengths, tau);
  Coefficients<T, 2 * K> more{};
  more[0] = square(half[0]);
  add_square_above<K>(more, half);
  p[0] = square(line[0]);
  add_square_above<K>(p, line);
  for (int k = 0; k <= 2 * K; ++k) p[k] = p[k] - more[k] * width;
  return p;
}

/// The squared distance from the centre over Count axes, minus the squared radius.
template <int Count, int K, class T, class Lengths, class TimePoint, class Wanted>
[[gnu::always_inline]] inline Coefficients<T, 2 * K> ball_over(const Primitive& ball,
                                                               const Coefficients<T, K>* x,
                                                               const Lengths& lengths, const TimePoint& tau,
                                                               Wanted&& wanted) {
  Coefficients<T, K> gaps[Count], radius{};
  if (ball.size.moves())
    radius = moving_size<K, T>(ball.size, lengths, tau);
  else
    radius[0] = length_at<T>(lengths, ball.size.value);
  Coefficients<T, 2 * K> p{};
  p[0] = -square(radius[0]);
  for (int i = 0; i < Count; ++i) {
    const AxisPart& part = ball.parts[i];
    gaps[i] = x[part.axis];
    subtract_size<K>(gaps[i], part.at, part.sign, lengths, tau);
    p[0] = p[0] + square(gaps[i][0]);
  }
  if (K == 0 || !wanted(p[0])) return p;
  if (ball.size.moves()) {
    add_square_above<K>(p, radius);
    for (int k = 1; k <= 2 * K; ++k) p[k] = -p[k];
  }
  for (int i = 0; i < Count; ++i) add_square_above<K>(p, gaps[i]);
  return p;
}

/// The same, over the axes of the ball.
template <int K, class T, class Lengths, class TimePoint, class Wanted>
Coefficients<T, 2 * K> ball_polynomial(const Primitive& ball, const Coefficients<T, K>* x,
                                       const Lengths& lengths, const TimePoint& tau, Wanted&& wanted) {
  if (ball.count == 1) return ball_over<1, K>(ball, x, lengths, tau, wanted);
  if (ball.count == 2) return ball_over<2, K>(ball, x, lengths, tau, wanted);
  return ball_over<3, K>(ball, x, lengths, tau, wanted);
}

/// Calls `take` with the polynomial of the primitive, expanded at tau: at most 0 inside. `x`: the relative
/// motion on each axis, also expanded at tau. The degree of strips and balls is 2 K, that of others K.
/// `wanted` is called with the value of a ball at tau. If it returns false, then the other coefficients are
/// unspecified.
template <int K, class T, class Lengths, class TimePoint, class Wanted, class Take>
[[gnu::always_inline]] inline auto with_polynomial(const Primitive& primitive, const Coefficients<T, K>* x,
                                                   const Lengths& lengths, const TimePoint& tau,
                                                   Wanted&& wanted, Take&& take) {
  switch (primitive.kind) {
    case Primitive::Kind::bound:
      return take(bound_polynomial<K>(primitive, x, lengths, tau));
    case Primitive::Kind::half_space:
      return take(half_space_polynomial<K>(primitive, x, lengths, tau));
    case Primitive::Kind::strip:
      return take(strip_polynomial<K>(primitive, x, lengths, tau));
    default:
      return take(ball_polynomial<K>(primitive, x, lengths, tau, wanted));
  }
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
