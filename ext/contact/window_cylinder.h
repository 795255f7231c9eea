// A window and an upright cylinder: a rounded rectangle in x and y, an interval along z.
#pragma once

#include "contact/window_shape.h"

namespace foresee {

struct WindowCylinder {
  static constexpr int axes = 3;

  template <class T>
  struct Sizes {
    WindowShape<T, 3> window;
    T radius, height;
  };

  template <class T>
  static Sizes<T> sizes(const RawSizes<T, 3>& raw, const Setup& setup) {
    return {WindowShape<T, 3>(*setup.window), raw.radius, raw.height};
  }

  template <class T, class Visitor>
  static auto visit(const Sizes<T>& s, Visitor&& v) {
    return v.all(visit_between(s.window, 2, s.height, v), visit_rounded_window_2(s.window, s.radius, v));
  }
};

}  // namespace foresee
