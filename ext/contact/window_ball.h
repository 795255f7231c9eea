// A window and a disc or ball: Euclidean from the window to the surface.
#pragma once

#include "contact/window_shape.h"

namespace foresee {

template <int D>
struct WindowBall {
  static constexpr int axes = D;

  template <class T>
  struct Sizes {
    WindowShape<T, D> window;
    T radius;
  };

  template <class T>
  static Sizes<T> sizes(const RawSizes<T, D>& raw, const Setup& setup) {
    return {WindowShape<T, D>(*setup.window), raw.radius};
  }

  template <class T, class Visitor>
  static auto visit(const Sizes<T>& s, Visitor&& v) {
    if constexpr (D == 2)
      return visit_rounded_window_2(s.window, s.radius, v);
    else
      return visit_rounded_window_3(s.window, s.radius, v);
  }
};

}  // namespace foresee
