#include "contact/mesh/triangle_filter.h"

#include <algorithm>

namespace foresee {
namespace {

using Triple = Components<double>;

double l1_norm(const Triple& a) {
  return std::abs(a[0]) + std::abs(a[1]) + std::abs(a[2]);
}

struct Corners {
  std::array<Triple, 3> at;

  explicit Corners(const SpacePiece& triangle) {
    for (int i = 0; i < 3; ++i) at[static_cast<std::size_t>(i)] = components_of<double>(triangle.corner(i));
  }
  Triple edge(std::size_t i) const { return difference_of(at[(i + 1) % 3], at[i]); }
  double size() const { return l1_norm(at[0]) + l1_norm(at[1]) + l1_norm(at[2]); }
};

/// The time in which two triangles may touch, cut by one axis after another.
class TimeCut {
 public:
  TimeCut(const Corners& a, const Corners& b, const std::array<Coefficients<Bounded, 2>, 3>& x,
          const Bounded& radius, const UncertainInterval& queried)
      : a_(a),
        b_(b),
        radius_(radius.value + radius.error),
        begin_(queried.begin.low),
        end_(queried.end.high) {
    double size = a.size() + b.size(), lost = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      place_[j] = x[j][0].value, speed_[j] = x[j][1].value + end_ * x[j][2].value;
      swing_[j] = end_ * (end_ * x[j][2].value) / 4;
      size += std::abs(place_[j]) + end_ * (std::abs(x[j][1].value) + end_ * std::abs(x[j][2].value));
      lost += x[j][0].error + end_ * (x[j][1].error + end_ * x[j][2].error);
    }
    // The relative error of a sum of three products is 2^-51 of their magnitudes.
    slack_ = 0x1p-44 * (size + radius_) + 2 * lost;
  }

  /// Cuts the time by the axis u x v. Whether none is left.
  bool are_apart_across(const Triple& u, const Triple& v) {
    const Triple n = cross_product(u, v);
    const Triple a{dot(n, a_.at[0]), dot(n, a_.at[1]), dot(n, a_.at[2])};
    const Triple b{dot(n, b_.at[0]), dot(n, b_.at[1]), dot(n, b_.at[2])};
    const auto [min_a, max_a] = std::minmax({a[0], a[1], a[2]});
    const auto [min_b, max_b] = std::minmax({b[0], b[1], b[2]});
    // Underflow in n is harmless too; in the sums it is less than this constant.
    const double slack = slack_ * l1_norm(n) + 0x1p-1000;
    const double swing = dot(n, swing_), at = dot(n, place_), speed = dot(n, speed_);
    const double low = min_a - max_b, high = max_a - min_b;
    // n is off by less than 2^-49 of |u| |v|.
    const double wide = 2 * slack_ * (l1_norm(u) * l1_norm(v)) + 2 * slack;
    within_[count_++] = {low + wide + std::max(swing, 0.0), high - wide + std::min(swing, 0.0), at, speed};
    const double more = radius_ > 0 ? radius_ * length(n) + slack : slack;
    return cut(low - more + std::min(swing, 0.0), high + more + std::max(swing, 0.0), at, speed, slack);
  }

  /// The axes along which d may reach a bound of the sum in the time that is left. Requires: radius 0.
  unsigned axes_that_matter() const {
    unsigned axes = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      const Within& within = within_[i];
      const double first = within.at + within.speed * begin_, last = within.at + within.speed * end_;
      const bool is_inside = std::min(first, last) >= within.low && std::max(first, last) <= within.high;
      if (!is_inside) axes |= 1U << i;
    }
    return axes;
  }
  Interval<double> left() const { return {begin_, end_}; }

 private:
  /// The bounds within which n d surely does not matter, and n d along the chord.
  struct Within {
    double low, high, at, speed;
  };

  static double length(const Triple& n) {
    const double square = dot(n, n);
    return square > 0x1p-900 ? std::sqrt(square) : l1_norm(n);
  }

  bool cut(double low, double high, double at, double speed, double slack) {
    if (!(std::abs(speed) * end_ > slack)) return at < low - 4 * slack || at > high + 4 * slack;
    const double one = (low - at) / speed, other = (high - at) / speed;
    begin_ = std::max(begin_, std::min(one, other)), end_ = std::min(end_, std::max(one, other));
    return begin_ > end_ + 0x1p-40 * std::abs(end_);
  }

  const Corners &a_, &b_;
  const double radius_;
  Triple place_, speed_, swing_;  ///< the chord of d, and the largest difference between chord and d
  double begin_, end_, slack_;
  std::array<Within, 11> within_;
  std::size_t count_ = 0;
};

constexpr TriangleFilter apart{{1, 0}, 0};
constexpr unsigned all_axes = ~0U;

}  // namespace

TriangleFilter filter_triangles(const SpacePiece& a, const SpacePiece& b,
                                const std::array<Coefficients<Bounded, 2>, 3>& x, const Bounded& radius,
                                const UncertainInterval& queried) {
  const Corners corners_a(a), corners_b(b);
  TimeCut time(corners_a, corners_b, x, radius, queried);
  for (const Corners* corners : {&corners_a, &corners_b})
    if (time.are_apart_across(corners->edge(0), corners->edge(1))) return apart;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      if (time.are_apart_across(corners_a.edge(i), corners_b.edge(k))) return apart;
  Interval<double> left = time.left();
  left.end = std::max(left.begin, left.end);  // rounding may swap them
  return {left, radius.value > 0 ? all_axes : time.axes_that_matter()};
}

}  // namespace foresee
