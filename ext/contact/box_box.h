// Boxes (and points that need coincide exactly, and everything in one dimension): on every axis |x| <= H.
#pragma once

#include "contact/pair_source.h"

namespace foresee {

template <int D>
struct BoxBox {
  static constexpr int axes = D;

  template <class T>
  struct Sizes {
    T half[D];
  };

  template <class T>
  static Sizes<T> sizes(const RawSizes<T, D>& raw, const Setup& setup) {
    Sizes<T> s;
    for (int j = 0; j < D; ++j) s.half[j] = raw.half[j] + Exactly<T>::number(setup.within);
    if constexpr (D == 1) s.half[0] = s.half[0] + raw.radius;  // a ball in one dimension is an interval
    return s;
  }

  template <class T, class Visitor>
  static auto visit(const Sizes<T>& s, Visitor&& v) {
    auto met = v.slab(0, s.half[0]);
    for (int j = 1; j < D; ++j) met = v.all(met, v.slab(j, s.half[j]));
    return met;
  }
};

}  // namespace foresee
