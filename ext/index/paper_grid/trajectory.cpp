#include "index/paper_grid/trajectory.h"

#include <cmath>

namespace foresee {

template <int D>
Trajectory<D> trajectory_of(const Bodies& bodies, std::size_t i, const Horizon& horizon,
                            const Vec<D>& margin) {
  const Motion<D> motion = motion_of<D>(bodies, i);
  Trajectory<D> out;
  out.swept = swept_box<D>(bodies, i, horizon, margin);
  out.span = span_between(motion.t, motion.until, horizon);
  const double since = horizon.now - motion.t, reach = std::abs(since) + horizon.h;
  out.a = motion.a;
  out.v = motion.v + motion.a * since;
  out.x = motion.x + since * (motion.v + motion.a * (since * 0.5));
  const Vec<D> magnitude = motion.x.abs() + reach * (motion.v.abs() + motion.a.abs() * reach);
  const Vec<D> lost = magnitude * 0x1p-48 + (reach + 4) * 0x1p-1020;
  out.room = (reach_of(largest_extents<D>(bodies, i, horizon)) + margin + lost) * (1 + 0x1p-48);
  return out;
}

template Trajectory<1> trajectory_of<1>(const Bodies&, std::size_t, const Horizon&, const Vec<1>&);
template Trajectory<2> trajectory_of<2>(const Bodies&, std::size_t, const Horizon&, const Vec<2>&);
template Trajectory<3> trajectory_of<3>(const Bodies&, std::size_t, const Horizon&, const Vec<3>&);

namespace {

/// The chord of an object's arc.
template <int D>
struct Chord {
  explicit Chord(const Trajectory<D>& t) : of(t), first(place(t.span.begin)), last(place(t.span.end)) {}

  Vec<D> place(double tau) const { return of.x + tau * (of.v + of.a * (tau * 0.5)); }
  Vec<D> direction() const { return last - first; }

  const Trajectory<D>& of;
  Vec<D> first, last;
};

/// The interval that a region covers along a direction, and the magnitude of the numbers behind it.
struct Cover {
  double lower, upper, magnitude;
};

template <int D>
Cover cover(const Chord<D>& chord, const Vec<D>& n) {
  const Trajectory<D>& t = chord.of;
  const double first = (n * chord.first).sum(), last = (n * chord.last).sum();
  const double duration = t.span.end - t.span.begin;
  const double bend = (n * t.a).sum() * (duration * duration / 8);
  const double room = (n.abs() * t.room).sum();
  const double reach = t.span.end;
  const Vec<D> gone = t.x.abs() + reach * (t.v.abs() + reach * t.a.abs());
  return {std::min(first, last) - std::max(bend, 0.0) - room,
          std::max(first, last) - std::min(bend, 0.0) + room, (n.abs() * gone).sum() + room};
}

/// True if the regions are certainly disjoint along n. False if a number is NaN or too large for the error
/// bound.
template <int D>
bool separated_along(const Chord<D>& a, const Chord<D>& b, const Vec<D>& n) {
  constexpr double largest = 0x1p1000, absolute_pad = 0x1p-1000;
  const Cover one = cover(a, n), other = cover(b, n);
  const double magnitude = one.magnitude + other.magnitude;
  const double slack = magnitude * 0x1p-40 + absolute_pad;
  if (!(magnitude < largest)) return false;
  return one.lower - other.upper > slack || other.lower - one.upper > slack;
}

Vec<3> cross(const Vec<3>& a, const Vec<3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

bool are_separated(const Chord<1>&, const Chord<1>&) {
  return false;
}

bool are_separated(const Chord<2>& a, const Chord<2>& b) {
  const Vec<2> along_a = a.direction(), along_b = b.direction();
  return separated_along<2>(a, b, {-along_a[1], along_a[0]}) ||
         separated_along<2>(a, b, {-along_b[1], along_b[0]});
}

bool are_separated(const Chord<3>& a, const Chord<3>& b) {
  const Vec<3> along_a = a.direction(), along_b = b.direction();
  for (int axis = 0; axis < 3; ++axis) {
    Vec<3> unit = Vec<3>::Zero();
    unit[axis] = 1;
    if (separated_along<3>(a, b, cross(along_a, unit)) || separated_along<3>(a, b, cross(along_b, unit)))
      return true;
  }
  return separated_along<3>(a, b, cross(along_a, along_b));
}

}  // namespace

template <int D>
bool regions_may_meet(const Trajectory<D>& a, const Trajectory<D>& b) {
  return !are_separated(Chord<D>(a), Chord<D>(b));
}

template bool regions_may_meet<1>(const Trajectory<1>&, const Trajectory<1>&);
template bool regions_may_meet<2>(const Trajectory<2>&, const Trajectory<2>&);
template bool regions_may_meet<3>(const Trajectory<3>&, const Trajectory<3>&);

}  // namespace foresee
