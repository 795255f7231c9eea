#include "index/paper_grid/time_interval.h"

#include <array>
#include <cmath>

namespace foresee {
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
