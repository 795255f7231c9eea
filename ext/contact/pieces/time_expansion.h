// Sizes and relative motions as polynomials in the time after an instant tau.
//
//   const MovingSize<Bounded> radius{r, growth};
//   expanded_at(radius, 600).value                  // 600 s later
//
// A size is what conditions of pieces compare with: a radius or a height that may grow linearly. It may be
// of any number type. A constant size costs one test; a plain number is a constant size.
#pragma once

#include <array>

#include "contact/certain/certain_axis_motion.h"
#include "numbers/coefficients.h"

namespace foresee {

/// The relative motion, by powers of the time after tau.
template <int Degree, int D>
std::array<Coefficients<Bounded, Degree>, D> expanded_at(const CertainMotion<D>& relative, double tau) {
  std::array<Coefficients<Bounded, Degree>, D> x;
  for (std::size_t j = 0; j < D; ++j) {
    const AxisView<> view = view_from<Degree>(relative.axis[j], tau, relative.underflow);
    x[j][0] = {view.p, view.ep}, x[j][1] = {view.q, view.eq};
    if constexpr (Degree > 1) x[j][2] = {view.a, view.ea};
  }
  return x;
}

/// value + rate tau, with rate >= 0.
template <class T>
struct MovingSize {
  T value = {}, rate = {};
  bool moves = false;
};

template <class T>
MovingSize<T> expanded_at(const MovingSize<T>& size, double tau) {
  if (!size.moves) return size;
  return {size.value + T{tau} * size.rate, size.rate, true};
}

/// The size at `end`, when it is largest.
inline Bounded largest(const MovingSize<Bounded>& size, double end) {
  return expanded_at(size, end).value;
}
inline Bounded largest(const Bounded& size, double /*end*/) {
  return size;
}

/// Whether the size may be above 0.
inline bool is_of_size(const MovingSize<Bounded>& size) {
  return size.value.value > 0 || size.moves;
}
inline bool is_of_size(const Bounded& size) {
  return size.value > 0;
}

/// The factor 1, without a multiplication.
struct Once {
  template <class T>
  friend const T& operator*(const T& size, Once) {
    return size;
  }
};

/// Subtracts size * factor from a polynomial.
template <int K, class T, class Factor>
[[gnu::always_inline]] inline void subtract_multiple(Coefficients<T, K>& p, const MovingSize<T>& size,
                                                     const Factor& factor) {
  p[0] = p[0] - size.value * factor;
  if constexpr (K > 0)
    if (size.moves) p[1] = p[1] - size.rate * factor;
}

/// Subtracts size^2 * factor from a polynomial.
template <int K, class T, class Factor>
[[gnu::always_inline]] inline void subtract_square_multiple(Coefficients<T, K>& p, const MovingSize<T>& size,
                                                            const Factor& factor) {
  p[0] = p[0] - square(size.value) * factor;
  if constexpr (K > 1)
    if (size.moves) {
      p[1] = p[1] - twice(size.value * size.rate) * factor;
      p[2] = p[2] - square(size.rate) * factor;
    }
}

}  // namespace foresee
