#include "contact/outline/outline_filter.h"

#include <algorithm>
#include <cmath>

namespace foresee {
namespace {

/// Squares of smaller numbers underflow, or nearly; those of larger numbers overflow.
constexpr double min_size = 0x1p-490, max_size = 0x1p500;

double l1_norm(const Corner& c) {
  return std::abs(c.x) + std::abs(c.y);
}

/// The corner farthest along n.
Corner extreme(std::span<const Corner> corners, const Corner& n) {
  Corner best = corners[0];
  double support = dot(best, n);
  for (const Corner& corner : corners.subspan(1)) {
    const double here = dot(corner, n);
    if (here > support) support = here, best = corner;
  }
  return best;
}

/// The Minkowski sum A + (-B) minus the points of a segment of d's path: contact is at the origin.
class SumAlongPath {
 public:
  SumAlongPath(const ConvexPiece& a, const ConvexPiece& b, const Corner& from, const Corner& to)
      : a_(a.corners), b_(b.corners), path_{from, to} {
    for (const auto& corners : {a_, b_, std::span<const Corner>(path_)}) {
      double largest = 0;
      for (const Corner& corner : corners) largest = std::max(largest, l1_norm(corner));
      size_ += largest;
    }
  }

  /// Far larger than the rounding errors of all that is computed from the set.
  double slack() const { return 0x1p-45 * size_ + min_size; }

  Verdict is_near(const Bounded& radius, double slack) {
    if (!(size_ < max_size)) return Verdict::uncertain;
    const double surely = radius.value - radius.error - slack, possibly = radius.value + radius.error + slack;
    corners_[0] = a_[0] - b_[0] - path_[0], count_ = 1;
    Corner nearest = corners_[0];
    for (double last = HUGE_VAL;;) {
      const double square = dot(nearest, nearest), distance = std::sqrt(square);
      if (distance <= surely) return Verdict::yes;
      if (!(distance > min_size && square < last)) return Verdict::uncertain;
      const Corner against{-nearest.x, -nearest.y};
      const Corner next = extreme(a_, against) - extreme(b_, nearest) - extreme(path_, nearest);
      if (dot(next, nearest) / distance > possibly) return Verdict::no;
      if (count_ == 2 && is_around(next)) return depth(next) > slack ? Verdict::yes : Verdict::uncertain;
      last = square * (1 - 0x1p-20);
      nearest = nearest_with(next);
    }
  }

 private:
  /// Whether the triangle of the two corners and this one contains the origin, by signs in plain doubles.
  bool is_around(const Corner& next) const {
    const double one = cross(corners_[0], corners_[1]), other = cross(corners_[1], next),
                 third = cross(next, corners_[0]);
    return (one > 0 && other > 0 && third > 0) || (one < 0 && other < 0 && third < 0);
  }
  /// A lower bound on the origin's distance from the sides of that triangle; below 0 where a sign is
  /// uncertain.
  double depth(const Corner& next) const {
    const auto from = [](const Corner& a, const Corner& b) {
      const double rounding = 0x1p-50 * (l1_norm(a) * l1_norm(b)) + min_size * min_size;
      return (std::abs(cross(a, b)) - rounding) / std::max(l1_norm(b - a), min_size);
    };
    return std::min({from(corners_[0], corners_[1]), from(corners_[1], next), from(next, corners_[0])});
  }

  /// The point of the triangle or segment that is nearest to the origin. Keeps the two corners on both
  /// sides of it.
  Corner nearest_with(const Corner& next) {
    std::size_t kept = 0;
    Corner best = nearest_between(corners_[0], next);
    if (count_ == 2) {
      const Corner other = nearest_between(corners_[1], next);
      if (dot(other, other) < dot(best, best)) best = other, kept = 1;
    }
    corners_ = {corners_[kept], next}, count_ = 2;
    return best;
  }
  static Corner nearest_between(const Corner& a, const Corner& b) {
    const Corner run = b - a;
    const double length = dot(run, run), part = length > 0 ? std::clamp(-dot(a, run) / length, 0.0, 1.0) : 0;
    return {a.x + part * run.x, a.y + part * run.y};
  }

  const std::span<const Corner> a_, b_;
  const std::array<Corner, 2> path_;
  double size_ = 0;
  std::array<Corner, 2> corners_;  ///< of the set; the nearest point is between them
  int count_ = 0;
};

Verdict is_near(const ConvexPiece& a, const ConvexPiece& b, const Corner& from, const Corner& to,
                const Bounded& radius, double slack) {
  SumAlongPath seen(a, b, from, to);
  return seen.is_near(radius, slack + seen.slack());
}

}  // namespace

FilterAnswer filter_outlines(const LinearPath& path, const ObjectPieces& a, const ObjectPieces& b,
                             std::span<const BoxedPair> pairs, const Bounded& radius, bool times_wanted) {
  FilterAnswer all{.touches = Verdict::no};
  for (const BoxedPair& pair : pairs) {
    const ConvexPiece one = a.piece(pair.a), other = b.piece(pair.b);
    const Verdict near = is_near(one, other, path.begin, path.end, radius, path.slack + path.bend);
    if (near == Verdict::no) continue;
    if (all.touches != Verdict::yes) all.touches = near;
    if (!times_wanted && near == Verdict::yes) return all;
    if (!times_wanted || !pair.may_touch_at_start ||
        is_near(one, other, path.begin, path.begin, radius, path.slack) != Verdict::yes)
      continue;
    all.touches = Verdict::yes, all.at_start = true;
    // A convex set contains a segment if it contains both ends.
    const auto holds_at = [&](const Corner& d) {
      return is_near(one, other, d, d, radius, path.slack + path.bend) == Verdict::yes;
    };
    if (holds_at(path.end) && (path.bend == 0 || holds_at(path.begin))) all.all_along = true;
    if (all.all_along) return all;
  }
  return all;
}

}  // namespace foresee
