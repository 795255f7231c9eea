// A window and a box or a point (and anything in one dimension): on every axis between the faces, half
// extents added.
#pragma once

#include "contact/window_shape.h"

namespace foresee {

template <int D>
struct WindowBox {
  static constexpr int axes = D;

  template <class T>
  struct Sizes {
    WindowShape<T, D> window;
    T half[D];
  };

  template <class T>
  static Sizes<T> sizes(const RawSizes<T, D>& raw, const Setup& setup) {
    Sizes<T> s{WindowShape<T, D>(*setup.window), {}};
    for (int j = 0; j < D; ++j) s.half[j] = raw.half[j];
    if constexpr (D == 1) s.half[0] = s.half[0] + raw.radius;  // a ball in one dimension is an interval
    return s;
  }

  template <class T, class Visitor>
  static auto visit(const Sizes<T>& s, Visitor&& v) {
    auto met = visit_between(s.window, 0, s.half[0], v);
    for (int j = 1; j < D; ++j) met = v.all(met, visit_between(s.window, j, s.half[j], v));
    return met;
  }
};

}  // namespace foresee
