// When could the two touch, at most? A cheap answer that lets most candidates go without any certified step.
//
// On one axis the relative motion leaves its chord over [0, h] by at most |a| h^2 / 4, so x + v t + a t^2 <=
// H implies that the chord is within H plus that. Each bound of the contact set's hull cuts the time asked
// about with one product. An empty interval is a certain miss. All widths are raised by far more than
// rounding can lose; numbers too large for that give no answer, which is for ever.
//
// Real: double, or several pairs at once (base/doubles.h): there are no branches, as which way the two go
// past each other is anybody's guess.
#pragma once

#include <cmath>

#include "contact/certain/certain_axis_motion.h"
#include "contact/certain/positive_duration.h"
#include "contact/set/contact_set.h"

namespace foresee {

template <int D, class Real = double>
class Chord {
 public:
  /// The chord over [0, end] on each axis, and how far beside it the motion can be. Requires: 0 <= end, which
  /// is h up to rounding.
  Chord(const CertainMotion<D, Real>& relative, const Real& end) : end_(end) {
    using std::abs;
    // The least slope that is divided by, and the least time that a crossing is off by where its product is
    // subnormal.
    constexpr double slack = 0x1p-40, min_slope = 0x1p-1000, min_time = 0x1p-1000;
    for (int j = 0; j < D; ++j) {
      const CertainAxisMotion<Real>& r = relative.axis[j];
      // No square of a time: it may vanish where the distance does not. What overflows in the slope does so
      // in the swing, and gives no answer.
      const Real bent = end * abs(r.a), swing = abs(r.v) + bent;
      const Real lost = r.ex + end * (r.ev + end * r.ea) + 2 * end * min_slope;
      const Real slope = r.v + end * r.a;
      at_[j] = r.x;
      steep_[j] = 1 / select(abs(slope) < min_slope, min_slope, slope);
      room_[j] = 0.25 * (end * bent) + lost + slack * (abs(at_[j]) + (end + min_time) * swing) + 0x1p-1000;
    }
  }

  /// Of `queried`, the moments at which the pair may be between all `faces`, as those of a set's hull: at no
  /// other is it.
  template <class Lengths>
  Interval<Real> between(const Faces* faces, int count, const Lengths& lengths,
                         Interval<Real> queried) const {
    for (int i = 0; i < count; ++i) {
      const Real below = crossing(faces[i].axis, -1, faces[i].has_below, faces[i].below, lengths);
      const Real above = crossing(faces[i].axis, 1, faces[i].has_above, faces[i].above, lengths);
      queried.begin = greater(lesser(below, above), queried.begin);
      queried.end = lesser(greater(above, below), queried.end);
    }
    return queried;
  }

  /// What a crossing is made of.
  struct Along {
    Real at;     ///< where the chord begins
    Real steep;  ///< 1 over its slope
    Real room;   ///< how far beside it the motion can be
  };
  Along along(int axis) const { return {at_[axis], steep_[axis], room_[axis]}; }

 private:
  /// A length, at most.
  template <class Lengths>
  static Real upper_bound(int number, const Lengths& lengths) {
    using std::abs;
    if (number == no_length) return 0.0;
    const BoundedOf<Real> length = lengths[number];
    return length.value + length.error + abs(length.value) * 0x1p-40;
  }

  /// How far out a face is at some moment, at most.
  template <class Lengths>
  Real upper_bound(const Size& size, const Lengths& lengths) const {
    const Real first = upper_bound(size.value, lengths);
    return size.moves() ? first + moved(size, lengths) : first;
  }
  template <class Lengths>
  [[gnu::noinline]] Real moved(const Size& size, const Lengths& lengths) const {
    return end_ * greater(upper_bound(size.rate, lengths), Real(0.0)) * (1 + 0x1p-40) + 0x1p-1000;
  }

  /// When the chord crosses a face: infinite, towards the side that the face is on, if there is none.
  template <class Lengths>
  Real crossing(int axis, double side, bool there, const Size& face, const Lengths& lengths) const {
    const Real size = upper_bound(face, lengths);
    const Real width = size + room_[axis], steep = steep_[axis];
    // A slope that is no number has no sign to go by, and the two faces must not end up on one side.
    const Real none = select(steep > 0, Real(side * for_ever), Real(-side * for_ever));
    if (!there) return none;
    return select(width < 0x1p1000, (side * width - at_[axis]) * steep, none);
  }

  Real end_, at_[D], steep_[D], room_[D];
};

}  // namespace foresee
