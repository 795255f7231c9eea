// When could the two touch, at most? A cheap answer that lets most candidates go without any certified step.
//
// On one axis the relative course leaves its chord over [0, h] by at most |a| h^2 / 4, so |x + v t + a t^2|
// <= H implies that the chord is within H plus that. Each slab gives one interval of time with one division;
// sets are joined as intervals, "any" by their hull, and a ball lies within the slabs around its centre. An
// empty interval is a certain miss. All widths are raised by far more than rounding can lose; numbers too
// large for that give no answer, which is for ever.
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "contact/certified.h"

namespace foresee {

/// All moments from `begin` to `end`; none if begin > end.
struct Spell {
  double begin, end;
  bool none() const { return begin > end; }
};

template <int D>
class ChordVisitor {
 public:
  /// Requires: 0 <= begin, end <= h up to rounding.
  ChordVisitor(const Relative<D>& relative, double begin, double end) : asked_{begin, end} {
    constexpr double slack = 0x1p-40, least_slope = 0x1p-1000;
    const double h = end;
    for (int j = 0; j < D; ++j) {
      const double bend = h * h * std::abs(relative.a[j]), turn = h * std::abs(relative.v[j]);
      const double lost = relative.ex[j] + h * (relative.ev[j] + h * relative.ea[j]) + h * least_slope;
      const double slope = relative.v[j] + h * relative.a[j];
      at_[j] = relative.x[j];
      slope_[j] = std::abs(slope) < least_slope ? least_slope : slope;
      room_[j] = 0.25 * bend + lost + slack * (std::abs(at_[j]) + turn + bend) + 0x1p-1000;
    }
  }

  Spell all(const Spell& a, const Spell& b) const {
    return {a.begin < b.begin ? b.begin : a.begin, a.end > b.end ? b.end : a.end};
  }
  Spell any(const Spell& a, const Spell& b) const {
    if (a.none()) return b;
    if (b.none()) return a;
    return {a.begin < b.begin ? a.begin : b.begin, a.end > b.end ? a.end : b.end};
  }
  Spell always() const { return asked_; }
  Spell slab(int axis, double half) const { return around(axis, 0, half); }
  Spell face(int axis, Face which, double bound) const {
    const double width = std::abs(bound) * 0x1p-40 + room_[axis];
    if (!(width < 0x1p1000)) return asked_;
    const double steep = 1 / slope_[axis];
    const double crossing = (bound + (which == Face::upper ? width : -width) - at_[axis]) * steep;
    if ((which == Face::upper) == (steep > 0)) return all(asked_, {-for_ever, crossing});
    return all(asked_, {crossing, for_ever});
  }
  template <std::size_t N>
  Spell ball(const std::array<Centre<double>, N>& centre, double radius) const {
    Spell spell = asked_;
    for (const Centre<double>& c : centre) spell = all(spell, around(c.axis, c.at, radius));
    return spell;
  }

 private:
  Spell around(int axis, double centre, double half) const {
    const double width = (half + std::abs(centre)) * 0x1p-40 + half + room_[axis];
    if (!(width < 0x1p1000)) return asked_;
    const double steep = 1 / slope_[axis];
    const double one = (centre - width - at_[axis]) * steep, other = (centre + width - at_[axis]) * steep;
    return all(asked_, {one < other ? one : other, one < other ? other : one});
  }

  double at_[D], slope_[D], room_[D];
  Spell asked_;
};

}  // namespace foresee
