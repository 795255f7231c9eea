#include "contact/mesh/plainly_apart.h"

#include <algorithm>

namespace foresee::contact {
namespace {

using Triple = std::array<double, 3>;

Triple difference_of(const Triple& a, const Triple& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Triple cross(const Triple& a, const Triple& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Triple& a, const Triple& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
double sum_of_sizes(const Triple& a) {
  return std::abs(a[0]) + std::abs(a[1]) + std::abs(a[2]);
}

struct Corners {
  std::array<Triple, 3> at;

  explicit Corners(const SpacePiece& triangle) {
    for (int i = 0; i < 3; ++i) {
      const SpaceCorner& corner = triangle.corner(i);
      at[static_cast<std::size_t>(i)] = {corner.x, corner.y, corner.z};
    }
  }
  Triple edge(std::size_t i) const { return difference_of(at[(i + 1) % 3], at[i]); }
  double size() const { return sum_of_sizes(at[0]) + sum_of_sizes(at[1]) + sum_of_sizes(at[2]); }
};

class Passing {
 public:
  Passing(const Corners& a, const Corners& b, const std::array<Powers<Bounded, 2>, 3>& x,
          const Bounded& radius, const Stay& asked)
      : a_(a), b_(b), radius_(radius.value + radius.error), begin_(asked.begin.low), end_(asked.end.high) {
    double size = a.size() + b.size(), lost = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      place_[j] = x[j][0].value, speed_[j] = x[j][1].value + end_ * x[j][2].value;
      swing_[j] = end_ * (end_ * x[j][2].value) / 4;
      size += std::abs(place_[j]) + end_ * (std::abs(x[j][1].value) + end_ * std::abs(x[j][2].value));
      lost += x[j][0].error + end_ * (x[j][1].error + end_ * x[j][2].error);
    }
    // Sums of three products are off by 2^-51 of their sizes.
    slack_ = 0x1p-44 * (size + radius_) + 2 * lost;
  }

  /// Cuts the time that is left by when they may touch along n; whether none is left.
  bool are_apart_along(const Triple& n) {
    const Triple a{dot(n, a_.at[0]), dot(n, a_.at[1]), dot(n, a_.at[2])};
    const Triple b{dot(n, b_.at[0]), dot(n, b_.at[1]), dot(n, b_.at[2])};
    const auto [least_a, greatest_a] = std::minmax({a[0], a[1], a[2]});
    const auto [least_b, greatest_b] = std::minmax({b[0], b[1], b[2]});
    // What underflows in n is no harm either, and in the sums it is less than this.
    const double slack = slack_ * sum_of_sizes(n) + 0x1p-1000;
    const double square = dot(n, n);
    const double more = radius_ * (square > 0x1p-900 ? std::sqrt(square) : sum_of_sizes(n)) + slack;
    const double swing = dot(n, swing_), at = dot(n, place_), speed = dot(n, speed_);
    const double low = least_a - greatest_b - more + std::min(swing, 0.0);
    const double high = greatest_a - least_b + more + std::max(swing, 0.0);
    if (!(std::abs(speed) * end_ > slack)) return at < low - 4 * slack || at > high + 4 * slack;
    const double one = (low - at) / speed, other = (high - at) / speed;
    begin_ = std::max(begin_, std::min(one, other)), end_ = std::min(end_, std::max(one, other));
    return begin_ > end_ + 0x1p-40 * std::abs(end_);
  }

 private:
  const Corners &a_, &b_;
  const double radius_;
  Triple place_, speed_, swing_;  ///< the chord of d, and how far d is before it in between
  double begin_, end_, slack_;
};

}  // namespace

bool are_plainly_apart(const SpacePiece& a, const SpacePiece& b, const std::array<Powers<Bounded, 2>, 3>& x,
                       const Bounded& radius, const Stay& asked) {
  const Corners corners_a(a), corners_b(b);
  Passing passing(corners_a, corners_b, x, radius, asked);
  for (const Corners* corners : {&corners_a, &corners_b})
    if (passing.are_apart_along(cross(corners->edge(0), corners->edge(1)))) return true;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      if (passing.are_apart_along(cross(corners_a.edge(i), corners_b.edge(k)))) return true;
  return false;
}

}  // namespace foresee::contact
