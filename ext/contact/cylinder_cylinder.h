// Upright cylinders, and points as cylinders of no size: a disc in x and y, and an interval along z.
#pragma once

#include "contact/certified.h"

namespace foresee {

struct CylinderCylinder {
  static constexpr int axes = 3;

  template <class T>
  struct Sizes {
    T radius, height;
  };

  template <class T>
  static Sizes<T> sizes(const RawSizes<T, 3>& raw, const Setup& setup) {
    return {raw.radius + Exactly<T>::number(setup.within), raw.height + Exactly<T>::number(setup.within_z)};
  }

  template <class T, class Visitor>
  static auto visit(const Sizes<T>& s, Visitor&& v) {
    const std::array<Centre<T>, 2> centre{Centre<T>{0, T{}}, Centre<T>{1, T{}}};
    return v.all(v.slab(2, s.height), v.ball(centre, s.radius));
  }
};

}  // namespace foresee
