// When could the two touch, at most? A cheap answer that lets most candidates go without any certified step.
//
// On one axis the relative course leaves its chord over [0, h] by at most |a| h^2 / 4, so x + v t + a t^2 <=
// H implies that the chord is within H plus that. Each bound of the contact set's hull cuts the time asked
// about with one product. An empty interval is a certain miss. All widths are raised by far more than
// rounding can lose; numbers too large for that give no answer, which is for ever.
#pragma once

#include <cmath>

#include "contact/certain/certified.h"
#include "contact/certain/relative.h"
#include "contact/set/contact_set.h"

namespace foresee {

template <int D>
class Chord {
 public:
  /// Requires: 0 <= end, which is h up to rounding.
  Chord(const Relative<D>& relative, double end) : end_(end) {
    constexpr double slack = 0x1p-40, least_slope = 0x1p-1000;
    for (int j = 0; j < D; ++j) {
      const double bend = end * end * std::abs(relative.a[j]), turn = end * std::abs(relative.v[j]);
      const double lost = relative.ex[j] + end * (relative.ev[j] + end * relative.ea[j]) + end * least_slope;
      const double slope = relative.v[j] + end * relative.a[j];
      at_[j] = relative.x[j];
      steep_[j] = 1 / (std::abs(slope) < least_slope ? least_slope : slope);
      room_[j] = 0.25 * bend + lost + slack * (std::abs(at_[j]) + turn + bend) + 0x1p-1000;
    }
  }

  /// For certain no moment from `begin` on is within the set's hull.
  bool misses(const ContactSet& set, const AllLengths<Bounded>& lengths, double begin) const {
    double end = end_;
    for (const Faces& faces : set.hull()) {
      // No branches: which way the two go past each other is anybody's guess.
      const double below = crossing(faces.axis, -1, faces.has_below, faces.below, lengths);
      const double above = crossing(faces.axis, 1, faces.has_above, faces.above, lengths);
      const double first = below < above ? below : above, last = below < above ? above : below;
      begin = begin < first ? first : begin;
      end = end > last ? last : end;
    }
    return begin > end;
  }

 private:
  /// When the chord crosses a face: infinite, towards the side that the face is on, if there is none.
  double crossing(int axis, double side, bool there, int number, const AllLengths<Bounded>& lengths) const {
    double size = 0;
    if (number != no_length) {
      const Bounded& length = lengths[number];
      size = length.value + length.error + std::abs(length.value) * 0x1p-40;
    }
    const double width = size + room_[axis], steep = steep_[axis];
    // A slope that is no number has no sign to go by, and the two faces must not end up on one side.
    if (!there || !(width < 0x1p1000)) return (side > 0) == (steep > 0) ? for_ever : -for_ever;
    return (side * width - at_[axis]) * steep;
  }

  double at_[D], steep_[D], room_[D];
  double end_;
};

}  // namespace foresee
