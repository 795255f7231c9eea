#include "index/paper_grid/trajectory.h"

#include <array>
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
    Vec<3> unit = Vec<3>::zero();
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

namespace {

constexpr double u = 0x1p-53;
constexpr double absolute_pad = 0x1p-1000;  // larger than the error of an underflow
constexpr double inf = std::numeric_limits<double>::infinity();

/// Disjoint intervals in order of time.
template <std::size_t MaxCount>
struct Times {
  std::array<SharedInterval, MaxCount> spans;
  std::size_t count = 0;

  void add(double begin, double end) {
    if (begin <= end) spans[count++] = {begin, end};
  }
};

using Solution = Times<2>;

Solution between(double first, double last) {
  Solution solution;
  solution.add(first, last);
  return solution;
}

Solution always() {
  return between(-inf, inf);
}

Solution outside(double first, double last) {
  if (!(first < last)) return always();
  Solution solution;
  solution.add(-inf, first);
  solution.add(last, inf);
  return solution;
}

/// The times at which v t + c <= 0.
Solution solve_linear(double v, double c) {
  if (v == 0) return c > 0 ? Solution{} : always();
  const double root = -c / v, error = 8 * u * std::abs(root) + absolute_pad;
  if (!std::isfinite(error)) return always();
  return v > 0 ? between(-inf, root + error) : between(root - error, inf);
}

/// A superset of the times at which a t^2 / 2 + v t + c <= 0. The discriminant v^2 - 2 a c has an error of at
/// most 8 units of its terms; if its sign is uncertain, the result is all times. Otherwise neither -(v +
/// sign(v) sqrt(d)) / a nor the other root, 2 c over the same sum, suffers cancellation.
Solution solve(double a, double v, double c) {
  if (!(std::isfinite(a) && std::isfinite(v) && std::isfinite(c))) return always();
  if (a == 0) return solve_linear(v, c);
  const double d = v * v - 2 * (a * c);  // 2 a alone may overflow
  const double uncertainty = 8 * u * (v * v + 2 * std::abs(a * c)) + absolute_pad;
  if (d < -2 * uncertainty) return a > 0 ? Solution{} : always();
  if (!(d > 2 * uncertainty && d < inf)) return always();
  const double root = std::sqrt(d), sum = -(v + std::copysign(root, v));
  const double relative = 2 * ((uncertainty / root + 4 * u * root) / std::abs(sum) + 12 * u);
  double first = sum / a, last = 2 * c / sum;
  if (first > last) std::swap(first, last);
  const double first_error = relative * std::abs(first) + absolute_pad;
  const double last_error = relative * std::abs(last) + absolute_pad;
  if (!(std::isfinite(first_error) && std::isfinite(last_error))) return always();
  return a > 0 ? between(first - first_error, last + last_error)
               : outside(first + first_error, last - last_error);
}

/// The common lifetime of a pair, intersected with one inequality after another. Each adds at most one
/// interval.
template <int D>
class CommonTimes {
 public:
  explicit CommonTimes(const SharedInterval& span) { left_.add(span.begin, span.end); }

  bool none() const { return left_.count == 0; }

  /// Keeps the times at which `mover` is inside the swept box of `other` on this axis.
  void keep_inside(const Trajectory<D>& mover, const Trajectory<D>& other, int axis) {
    const double x = mover.x[axis], v = mover.v[axis], a = mover.a[axis], room = mover.room[axis];
    const double lower = other.swept.lower[axis], upper = other.swept.upper[axis];
    // An inequality that holds throughout the mover's swept box needs no solution.
    if (!(mover.swept.upper[axis] <= upper)) keep(solve(a, v, lowered(x, -upper, room)));
    if (!(mover.swept.lower[axis] >= lower)) keep(solve(-a, -v, lowered(-x, lower, room)));
  }

 private:
  /// A lower bound of x + y - room, despite rounding.
  static double lowered(double x, double y, double room) {
    return (x + y - room) - 0x1p-50 * (std::abs(x) + std::abs(y) + room) - absolute_pad;
  }

  void keep(const Solution& solution) {
    Times<4 * D + 1> kept;
    for (std::size_t i = 0; i < left_.count; ++i)
      for (std::size_t j = 0; j < solution.count; ++j)
        kept.add(std::max(left_.spans[i].begin, solution.spans[j].begin),
                 std::min(left_.spans[i].end, solution.spans[j].end));
    left_ = kept;
  }

  Times<4 * D + 1> left_;
};

}  // namespace

template <int D>
bool times_may_overlap(const Trajectory<D>& a, const Trajectory<D>& b) {
  CommonTimes<D> times({std::max(a.span.begin, b.span.begin), std::min(a.span.end, b.span.end)});
  for (int axis = 0; axis < D && !times.none(); ++axis) {
    times.keep_inside(a, b, axis);
    times.keep_inside(b, a, axis);
  }
  return !times.none();
}

template bool times_may_overlap<1>(const Trajectory<1>&, const Trajectory<1>&);
template bool times_may_overlap<2>(const Trajectory<2>&, const Trajectory<2>&);
template bool times_may_overlap<3>(const Trajectory<3>&, const Trajectory<3>&);

}  // namespace foresee
