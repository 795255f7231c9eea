// A cheap filter for contact: a bound on the times at which two objects can touch, from the chord of their
// relative motion. It proves most misses without a certified step.
//
// On one axis the relative motion deviates from its chord over [0, h] by at most |a| h^2 / 4. So x + v t + a
// t^2 <= H implies that the chord is at most H plus that. Each bound of the hull of the contact set shortens
// the interval with one product. An empty interval is a proven miss. All widths are increased by far more
// than the rounding errors. If numbers are too large for that, the interval is not shortened.
//
// Real: double, or several pairs at once (base/doubles.h). The code has no branches, because the direction in
// which two objects pass each other is not predictable.
#pragma once

#include <cmath>

#include "contact/certified/certain_axis_motion.h"
#include "contact/certified/root_bracketing.h"
#include "contact/minkowski/contact_set.h"

namespace foresee {

template <int D, class Real = double>
class Chord {
 public:
  /// The chord over [0, end] on each axis, and the deviation of the motion from it. Requires: 0 <= end, which
  /// is h up to rounding.
  Chord(const CertainMotion<D, Real>& relative, const Real& end) : end_(end) {
    using std::abs;
    // min_slope: the smallest divisor. min_time: the smallest error of a crossing whose product is subnormal.
    constexpr double slack = 0x1p-40, min_slope = 0x1p-1000, min_time = 0x1p-1000;
    for (int j = 0; j < D; ++j) {
      const CertainAxisMotion<Real>& r = relative.axis[j];
      // No square of a time: it may underflow where the distance does not. If the slope overflows, so does
      // the swing, which gives no answer.
      const Real bent = end * abs(r.a), swing = abs(r.v) + bent;
      const Real lost = r.ex + end * (r.ev + end * r.ea) + 2 * end * min_slope;
      const Real slope = r.v + end * r.a;
      at_[j] = r.x;
      steep_[j] = 1 / select(abs(slope) < min_slope, min_slope, slope);
      room_[j] = 0.25 * (end * bent) + lost + slack * (abs(at_[j]) + (end + min_time) * swing) + 0x1p-1000;
    }
  }

  /// The part of `span` in which the pair may be between all `faces`, for example those of a hull. At no
  /// other time of `span` is it between them.
  template <class Lengths>
  Interval<Real> between(const Faces* faces, int count, const Lengths& lengths, Interval<Real> span) const {
    for (int i = 0; i < count; ++i) {
      const Real below = crossing(faces[i].axis, -1, faces[i].has_below, faces[i].below, lengths);
      const Real above = crossing(faces[i].axis, 1, faces[i].has_above, faces[i].above, lengths);
      span.begin = greater(lesser(below, above), span.begin);
      span.end = lesser(greater(above, below), span.end);
    }
    return span;
  }

  /// The chord on one axis.
  struct Along {
    Real at;     ///< where the chord starts
    Real steep;  ///< 1 over its slope
    Real room;   ///< bound on the deviation of the motion from the chord
  };
  Along along(int axis) const { return {at_[axis], steep_[axis], room_[axis]}; }

 private:
  /// An upper bound of a length.
  template <class Lengths>
  static Real upper_bound(int number, const Lengths& lengths) {
    using std::abs;
    if (number == no_length) return 0.0;
    const BoundedOf<Real> length = lengths[number];
    return length.value + length.error + abs(length.value) * 0x1p-40;
  }

  /// An upper bound of the distance of a face from the origin at any time.
  template <class Lengths>
  Real upper_bound(const Size& size, const Lengths& lengths) const {
    const Real first = upper_bound(size.value, lengths);
    return size.moves() ? first + moved(size, lengths) : first;
  }
  template <class Lengths>
  [[gnu::noinline]] Real moved(const Size& size, const Lengths& lengths) const {
    return end_ * greater(upper_bound(size.rate, lengths), Real(0.0)) * (1 + 0x1p-40) + 0x1p-1000;
  }

  /// When the chord crosses a face; infinite, with the sign of the face's side, if the face does not exist.
  template <class Lengths>
  Real crossing(int axis, double side, bool there, const Size& face, const Lengths& lengths) const {
    const Real size = upper_bound(face, lengths);
    const Real width = size + room_[axis], steep = steep_[axis];
    // A slope that is NaN has no sign, but the two faces must get infinities of different signs.
    const Real none = select(steep > 0, Real(side * unbounded), Real(-side * unbounded));
    if (!there) return none;
    return select(width < 0x1p1000, (side * width - at_[axis]) * steep, none);
  }

  Real end_, at_[D], steep_[D], room_[D];
};

}  // namespace foresee
