// The instant of a crossing that a Track has bracketed, rounded once.
//
// Within the bracket a primitive is on one side all the time, or its polynomial is monotone there and has at
// most one root. That root is found by one Newton step from the bracket's begin, with the value of the
// polynomial in DoubleDouble; it comes with an error radius, and is accepted if all numbers within that
// radius round to the same double (Ziv's test). Roots of different primitives are rounded apart and then
// compared: rounding keeps order. What this cannot settle is NaN.
#pragma once

#include "contact/track.h"
#include "numbers/crossed_root.h"

namespace foresee {

inline Instant unknown_instant() {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  return {nan, nan};
}

inline Instant later(const Instant& a, const Instant& b) {
  if (!a.known() || !b.known()) return unknown_instant();
  return {std::max(a.dt, b.dt), std::max(a.t, b.t)};
}

inline Instant earlier(const Instant& a, const Instant& b) {
  if (!a.known() || !b.known()) return unknown_instant();
  return {std::min(a.dt, b.dt), std::min(a.t, b.t)};
}

template <Way way, int D, int Degree>
class CrossingVisitor {
 public:
  CrossingVisitor(const Relative<D>& relative, const Course<DoubleDouble, D>& course, const Bracket& bracket,
                  double now)
      : course_(course), base_(bracket.before), now_(now), underflow_(relative.underflow) {
    width_ = (bracket.after - bracket.before) * (1 + 4 * unit_roundoff);
    view_from<D, Degree>(relative, base_, view_);
  }

  Instant all(const Instant& a, const Instant& b) const {
    return way == Way::in ? later(a, b) : earlier(a, b);
  }
  Instant any(const Instant& a, const Instant& b) const {
    return way == Way::in ? earlier(a, b) : later(a, b);
  }

  Instant slab(int axis, DoubleDouble half) const {
    const AxisView& w = view_[axis];
    const double gap = std::abs(w.p) - half.high,
                 moved = width_ * (std::abs(w.q) + w.eq + width_ * (std::abs(w.a) + w.ea));
    const double certain = slab_error(w, half.high) + 2 * moved;
    if (gap < -certain) return always_inside();
    if (gap > certain) return always_outside();
    if (slab_within(w, half.high) > width_) return always_inside();
    if (slab_apart(w, half.high) > width_) return always_outside();
    // Only the side towards which the pair is can be crossed, unless the slab is thin: then let others
    // decide.
    const bool high_side = w.p >= 0;
    const double other = half.high + std::abs(w.p) - 2 * (w.ep + 8 * unit_roundoff * half.high);
    if (!(other > moved)) return unknown_instant();
    const DoubleDouble place = this->place(axis);
    const DoubleDouble value = high_side ? place - half : -place - half;
    const double slope = high_side ? w.q : -w.q;
    return root_of<way>({value, fine(w.ep, w.p, half.high), slope, w.eq, std::abs(w.a) + w.ea}, now_, base_,
                        width_);
  }

  Instant always() const { return always_inside(); }

  Instant face(int axis, Face which, DoubleDouble bound) const {
    const AxisView& w = view_[axis];
    const double size = std::abs(bound.high);
    const double gap = face_gap(w, which, bound.high),
                 moved = width_ * (std::abs(w.q) + w.eq + width_ * (std::abs(w.a) + w.ea));
    const double certain = slab_error(w, size) + 2 * moved;
    if (gap < -certain || face_within(w, which, bound.high) > width_) return always_inside();
    if (gap > certain || face_apart(w, which, bound.high) > width_) return always_outside();
    const DoubleDouble beyond = place(axis) - bound;
    const bool upper = which == Face::upper;
    return root_of<way>(
        {upper ? beyond : -beyond, fine(w.ep, w.p, size), upper ? w.q : -w.q, w.eq, std::abs(w.a) + w.ea},
        now_, base_, width_);
  }

  template <std::size_t N>
  Instant ball(const std::array<Centre<DoubleDouble>, N>& centre, DoubleDouble radius) const {
    std::array<Centre<double>, N> rough;
    DoubleDouble value = -(radius * radius);
    for (std::size_t i = 0; i < N; ++i) {
      rough[i] = {centre[i].axis, centre[i].at.high};
      const DoubleDouble away = place(centre[i].axis) - centre[i].at;
      value = value + away * away;
    }
    const BallView b = ball_view<Degree>(view_, rough, radius.high, underflow_);
    if (ball_within<Degree>(b, width_) > width_) return always_inside();
    if (ball_apart<Degree>(b, width_) > width_) return always_outside();
    const double span = std::max(width_, 2 * std::abs(value.high / b.f1));
    const double bend =
        std::abs(b.c2) + b.e2 + span * (3 * (std::abs(b.c3) + b.e3) + 6 * span * (b.c4 + b.e4));
    return root_of<way>({value, b.ef * 0x1p-44 + underflow_, b.f1, b.e1, 2 * bend}, now_, base_, width_);
  }

 private:
  static constexpr double inf = std::numeric_limits<double>::infinity();
  static constexpr Instant always_inside() {
    return way == Way::in ? Instant{-inf, -inf} : Instant{inf, inf};
  }
  static constexpr Instant always_outside() {
    return way == Way::in ? Instant{inf, inf} : Instant{-inf, -inf};
  }

  /// DoubleDouble loses at most 2^-97 of what the double bound counts in 2^-53.
  double fine(double rough_error, double p, double half) const {
    return (rough_error + 8 * unit_roundoff * (std::abs(p) + half)) * 0x1p-44 + underflow_;
  }

  /// Where the centre is at the bracket's begin.
  DoubleDouble place(int axis) const {
    const DoubleDouble tau{base_, 0};
    if constexpr (Degree < 2) return course_.x[axis] + tau * course_.v[axis];
    return course_.x[axis] + tau * (course_.v[axis] + tau * course_.a[axis]);
  }

  const Course<DoubleDouble, D>& course_;
  AxisView view_[D];
  double base_, width_, now_, underflow_;
};

}  // namespace foresee
