// A size that may grow with time, in any number type: what the conditions of pieces are about.
//
//   const MovingSize<Bounded> radius{r, growth};
//   expanded_at(radius, 600).value                  // 600 s later
//
// What cannot move costs one test. A plain number is a size that does not.
#pragma once

#include "numbers/coefficients.h"

namespace foresee {

/// value + rate tau. Requires: rate >= 0.
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

/// The size when it is largest.
inline Bounded largest(const MovingSize<Bounded>& size, double end) {
  return expanded_at(size, end).value;
}
inline Bounded largest(const Bounded& size, double /*end*/) {
  return size;
}

/// Whether it may be above 0.
inline bool is_of_size(const MovingSize<Bounded>& size) {
  return size.value.value > 0 || size.moves;
}
inline bool is_of_size(const Bounded& size) {
  return size.value > 0;
}

/// A factor that costs nothing.
struct Once {
  template <class T>
  friend const T& operator*(const T& size, Once) {
    return size;
  }
};

/// Subtracts from a polynomial the size times a factor.
template <int K, class T, class Factor>
[[gnu::always_inline]] inline void subtract_multiple(Coefficients<T, K>& p, const MovingSize<T>& size,
                                                     const Factor& factor) {
  p[0] = p[0] - size.value * factor;
  if constexpr (K > 0)
    if (size.moves) p[1] = p[1] - size.rate * factor;
}

/// Subtracts its square times a factor.
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
