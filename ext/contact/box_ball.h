// A box and a disc, ball, or point that comes within a distance: Euclidean from the box to the surface.
#pragma once

#include "contact/rounded_box.h"

namespace foresee {

template <int D>
struct BoxBall {
  static constexpr int axes = D;

  template <class T>
  struct Sizes {
    T half[D];  ///< of the box alone
    T radius;
  };

  template <class T>
  static Sizes<T> sizes(const RawSizes<T, D>& raw, const Setup& setup) {
    Sizes<T> s;
    std::copy_n(raw.half, D, s.half);
    s.radius = raw.radius + Exactly<T>::number(setup.within);
    return s;
  }

  template <class T, class Visitor>
  static auto visit(const Sizes<T>& s, Visitor&& v) {
    if constexpr (D == 2)
      return visit_rounded_rectangle(s.half, s.radius, v);
    else
      return visit_rounded_cuboid(s.half, s.radius, v);
  }
};

}  // namespace foresee
