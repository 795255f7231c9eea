// An upright cylinder (or a point as one of no size) and a box: a rounded rectangle in x and y, an interval
// along z.
#pragma once

#include "contact/rounded_box.h"

namespace foresee {

struct CylinderBox {
  static constexpr int axes = 3;

  template <class T>
  struct Sizes {
    T half[2];  ///< of the box alone
    T radius, height;
  };

  template <class T>
  static Sizes<T> sizes(const RawSizes<T, 3>& raw, const Setup& setup) {
    return {{raw.half[0], raw.half[1]},
            raw.radius + Exactly<T>::number(setup.within),
            raw.half[2] + raw.height + Exactly<T>::number(setup.within_z)};
  }

  template <class T, class Visitor>
  static auto visit(const Sizes<T>& s, Visitor&& v) {
    return v.all(v.slab(2, s.height), visit_rounded_rectangle(s.half, s.radius, v));
  }
};

}  // namespace foresee
