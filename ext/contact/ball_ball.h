// Discs and balls, and points that come within a distance: |x| <= R, all axes together.
#pragma once

#include "contact/certified.h"

namespace foresee {

template <int D>
struct BallBall {
  static constexpr int axes = D;

  template <class T>
  struct Sizes {
    T radius;
  };

  template <class T>
  static Sizes<T> sizes(const RawSizes<T, D>& raw, const Setup& setup) {
    return {raw.radius + Exactly<T>::number(setup.within)};
  }

  template <class T, class Visitor>
  static auto visit(const Sizes<T>& s, Visitor&& v) {
    std::array<Centre<T>, D> centre;
    for (int j = 0; j < D; ++j) centre[j] = {j, T{}};
    return v.ball(centre, s.radius);
  }
};

}  // namespace foresee
