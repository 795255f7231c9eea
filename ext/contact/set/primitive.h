// What contact sets are made of: half spaces, strips and balls, each a polynomial in time that is at most 0
// inside.
//
// A primitive is written once, in with_polynomial(), for every number type and for every degree of the
// motion: doubles with error bounds (Bounded), DoubleDouble, numbers of 128 bits (Midrad128) and exact ones
// (Dyadic) all run the same lines, and degree 0 is the value at one moment. To add a primitive is to add its
// kind and its polynomial there.
//
// A primitive holds no numbers of a pair. It names lengths of its contact set (contact_set.h), which each
// stage computes in its own number type. A size may change with time: value + rate tau, tau from `now`.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "numbers/coefficients.h"
#include "numbers/exact_conversion.h"

namespace foresee {

/// In place of a length's number: 0. All its bits are set.
constexpr int no_length = -1;

/// Numbers of lengths.
struct Size {
  int value = no_length, rate = no_length;

  bool moves() const { return rate != no_length; }
};

/// What a primitive says about one axis.
struct AxisPart {
  int axis = 0;
  int sign = 1;  ///< 1 or -1
  Size at = {};
  int normal = no_length;  ///< the number of a length
};

struct Primitive {
  enum class Kind : std::uint8_t {
    bound,       ///< sign x <= size on the one axis of parts[0]
    half_space,  ///< the sum of sign normal (x - at) over the parts is <= size: beside a line through `at`
    strip,       ///< the square of that sum is <= size^2 times the sum of normal^2: as near to the line
    ball         ///< the sum of (x - sign at)^2 over the parts is <= size^2; `at` is the centre
  };
  Kind kind;
  int count = 0;  ///< of parts
  AxisPart parts[3] = {};
  Size size = {};
};

/// A length, or 0. `lengths`: what has them by number, as an array does.
template <class T, class Lengths>
T length_at(const Lengths& lengths, int number) {
  if (number == no_length) return T{};
  return lengths[number];
}

/// A size by powers of the time after tau, a double or as many as T has. Requires: K is at least its degree,
/// or 0 for its value alone.
template <int K, class T, class Lengths, class TimePoint>
[[gnu::noinline]] Coefficients<T, K> moving_size(const Size& size, const Lengths& lengths,
                                                 const TimePoint& tau) {
  const T rate = length_at<T>(lengths, size.rate);
  Coefficients<T, K> p{};
  p[0] = length_at<T>(lengths, size.value) + T{tau} * rate;
  if constexpr (K >= 1) p[1] = rate;
  return p;
}

/// p minus sign times the size.
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

/// Adds the square of a polynomial to the powers above the value.
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

/// How far beyond the line through `at`, in lengths of the normal.
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

/// The square of the distance from the centre, over so many axes, minus that of the radius.
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

/// The same, over its axes.
template <int K, class T, class Lengths, class TimePoint, class Wanted>
Coefficients<T, 2 * K> ball_polynomial(const Primitive& ball, const Coefficients<T, K>* x,
                                       const Lengths& lengths, const TimePoint& tau, Wanted&& wanted) {
  if (ball.count == 1) return ball_over<1, K>(ball, x, lengths, tau, wanted);
  if (ball.count == 2) return ball_over<2, K>(ball, x, lengths, tau, wanted);
  return ball_over<3, K>(ball, x, lengths, tau, wanted);
}

/// Gives `take` the primitive by powers of the time after tau: at most 0 inside. `x`: the relative motion on
/// each axis, likewise as it is seen from tau. Strips and balls have powers up to 2 K, others up to K. Of a
/// ball `wanted` is asked with the value at tau whether more than that value matters; if not, the rest may be
/// anything.
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

/// All of it, filled up with zeros to powers up to 2 K.
template <int K, class T, class Lengths, class TimePoint>
Coefficients<T, 2 * K> polynomial_of(const Primitive& primitive, const Coefficients<T, K>* x,
                                     const Lengths& lengths, const TimePoint& tau) {
  const auto wanted = [](const T&) { return true; };
  return with_polynomial<K>(primitive, x, lengths, tau, wanted, [](const auto& some) {
    Coefficients<T, 2 * K> all{};
    std::copy(some.begin(), some.end(), all.begin());
    return all;
  });
}

}  // namespace foresee
