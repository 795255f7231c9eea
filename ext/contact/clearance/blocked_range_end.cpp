#include "contact/clearance/blocked_range_end.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/clearance/straight_approach.h"
#include "contact/clearance/turned_lines.h"
#include "numbers/correct_rounding.h"

namespace foresee {
namespace {

SineCosine<double> sum_of(const SineCosine<double>& a, const SineCosine<double>& b) {
  return {a.sine * b.cosine + a.cosine * b.sine, a.cosine * b.cosine - a.sine * b.sine};
}

Corner mean_of(std::span<const Corner> corners) {
  Corner sum{0, 0};
  for (const Corner& corner : corners) sum.x += corner.x, sum.y += corner.y;
  const auto count = static_cast<double>(corners.size());
  return {sum.x / count, sum.y / count};
}

/// Increases with the angle, from -180 to 180 degrees.
double key_of(const SineCosine<double>& angle) {
  return angle.sine / (1 + angle.cosine);
}

/// The paths of the other object relative to all turns, and the sum of two outlines.
struct TurnedPaths {
  TurnedPaths(const Vec<2>& x, const Vec<2>& own_v, const Vec<2>& other_v)
      : x(x),
        own(own_v),
        other(other_v),
        square{dot(own, own) + dot(other, other), -2 * dot(other, own), -2 * cross(other, own)} {}

  Vec<2> at(const SineCosine<double>& k) const {
    return other - Vec<2>(own[0] * k.cosine + own[1] * k.sine, own[1] * k.cosine - own[0] * k.sine);
  }
  /// Above 0: the difference of these two corners is left of the path.
  Wave side_of(const Corner& own_corner, const Corner& other_corner) const {
    const Vec<2> p{own_corner.x, own_corner.y}, w = x + Vec<2>(other_corner.x, other_corner.y);
    return {cross(w, other) + cross(p, own), -cross(w, own) - cross(p, other), dot(w, own) - dot(p, other)};
  }
  /// When the path passes it, times the square of the speed.
  Wave time_of(const Corner& own_corner, const Corner& other_corner) const {
    const Vec<2> p{own_corner.x, own_corner.y}, w = x + Vec<2>(other_corner.x, other_corner.y);
    return {-dot(p, own) - dot(w, other), dot(other, p) + dot(w, own), cross(other, p) + cross(w, own)};
  }

  Vec<2> x, own, other;
  Wave square;  ///< of the speed
};

/// The turns that touch, about one turn: the path relative to the other object passes corners on both sides.
class TouchingAbout {
 public:
  TouchingAbout(const PieceSum& sum, double radius, const TurnedPaths& paths, double begin, double end)
      : sum_(sum), radius_(radius), paths_(paths), begin_(begin), end_(end) {}

  /// The turns at which the path passes the middle of all corners while both exist.
  std::vector<SineCosine<double>> middles() const {
    std::vector<SineCosine<double>> middles;
    const Corner own = mean_of(sum_.given_corners()), other = mean_of(sum_.other_corners());
    const Wave wave = side_of(own, other);
    for (const int direction : {1, -1})
      if (const auto found = wave.falls(direction))
        if (std::min(after_begin(own, other).at(*found), before_end(own, other).at(*found)) > 0)
          middles.push_back(*found);
    if (const SineCosine<double> nearest = wave.nearest(); !wave.falls(1) && touches(nearest))
      if (std::min(after_begin(own, other).at(nearest), before_end(own, other).at(nearest)) > 0)
        middles.push_back(nearest);
    return middles;
  }

  /// The angle from a middle to the end of touching in one direction, as far as it is known.
  SineCosine<double> end(const SineCosine<double>& middle, int direction) const {
    const SineCosine<double> left = end(middle, direction, 1), right = end(middle, direction, -1);
    return (key_of(left) - key_of(right)) * direction < 0 ? left : right;
  }

  /// Whether the path passes corners on both sides, or nearly so.
  bool touches(const SineCosine<double>& k) const {
    const Vec<2> v = paths_.at(k);
    const double slack = 0x1p-40 * (paths_.x.abs().sum() + sum_.size() + radius_) * v.abs().sum() +
                         radius_ * std::sqrt(dot(v, v));
    for (const int side : {1, -1}) {
      const PieceSum::CornerPair corners = sum_.farthest_pair(-side * v[1], side * v[0], k);
      if (!(side * side_of(corners.own, corners.other).at(k) >= -slack)) return false;
    }
    return true;
  }

 private:
  /// By the corners on one side alone; `side` 1: left of the path.
  SineCosine<double> end(const SineCosine<double>& middle, int direction, int side) const {
    SineCosine<double> now{0, 1};
    const SineCosine<double> farthest = farthest_angle(direction);
    PieceSum::CornerPair last{};
    for (int step = 0; step < 16; ++step) {
      const SineCosine<double> pose = sum_of(middle, now);
      const Vec<2> v = paths_.at(pose);
      const PieceSum::CornerPair corners = sum_.farthest_pair(-side * v[1], side * v[0], pose);
      const auto& [own, other] = corners;
      if (step > 0 && is_same(own, last.own) && is_same(other, last.other)) return now;
      last = corners;
      const auto next = [&](const Wave& wave) { return next_fall(wave.from(middle), now, direction); };
      SineCosine<double> until = farthest;
      const auto is_before = [&](const std::optional<SineCosine<double>>& one) {
        return one && (key_of(*one) - key_of(until)) * direction < 0;
      };
      const Wave lateral = side_of(own, other);
      const auto passes =
          passing((side > 0 ? lateral : -lateral).from(middle), paths_.square.from(middle), now, direction);
      if (is_before(passes)) until = *passes;
      bool is_known = passes.has_value();
      for (const Wave& time : {after_begin(own, other), before_end(own, other)})
        if (const auto limit = next(time); is_before(limit)) until = *limit, is_known = false;
      if (!is_known) return until;
      now = until;
    }
    return now;
  }

  static SineCosine<double> farthest_angle(int direction) { return {direction * 0.6, -0.8}; }
  /// Where a wave first falls through 0, from an angle on; nothing if it remains above.
  static std::optional<SineCosine<double>> next_fall(const Wave& wave, const SineCosine<double>& now,
                                                     int direction) {
    if (!(wave.at(now) > 0)) return now;
    const auto found = wave.falls(direction);
    const double ahead = found ? (key_of(*found) - key_of(now)) * direction : 0;
    if (found && ahead > 0) return found;
    if (found && ahead > -1e-6) return now;  // only rounding has put it behind
    return std::nullopt;
  }
  /// next_fall() of the sum of a wave and the radius times the speed: in steps, each by the lowest speed of it.
  std::optional<SineCosine<double>> passing(const Wave& lateral, const Wave& square, SineCosine<double> now,
                                            int direction) const {
    if (!(radius_ > 0)) return next_fall(lateral, now, direction);
    for (int step = 0; step < 64; ++step) {
      const auto fall = [&](double of_speed) {
        return next_fall(lateral.plus(radius_ * std::sqrt(std::max(0.0, of_speed))), now, direction);
      };
      const double here = square.at(now);
      const SineCosine<double> ahead = fall(here).value_or(farthest_angle(direction));
      const bool dips =
          direction > 0 ? (-square).peaks_between(now, ahead) : (-square).peaks_between(ahead, now);
      const auto sure = fall(dips ? -(-square).peak() : std::min(here, square.at(ahead)));
      if (!sure || std::abs(key_of(*sure) - key_of(now)) <= 0x1p-52 * (1 + std::abs(key_of(now))))
        return sure;
      now = *sure;
    }
    return now;
  }

  static bool is_same(const Corner& a, const Corner& b) { return a.x == b.x && a.y == b.y; }
  Wave side_of(const Corner& own, const Corner& other) const { return paths_.side_of(own, other); }
  Wave after_begin(const Corner& own, const Corner& other) const {
    return paths_.time_of(own, other).minus(paths_.square, begin_);
  }
  Wave before_end(const Corner& own, const Corner& other) const {
    return -paths_.time_of(own, other).minus(paths_.square, end_);
  }

  const PieceSum& sum_;
  double radius_;
  TurnedPaths paths_;
  double begin_, end_;
};

}  // namespace

template <int D>
SignedDistance gap_of(const Encounter<D>& encounter, const Changes& changes, double k) {
  const TrajectoryEstimate<D> path = relative(encounter, changes.estimate<D>(k));
  if ((path.a != 0).any() || !(path.begin <= path.end)) return std::nullopt;
  return straight_approach<D>(encounter.extents, path.x, path.v, path.begin, path.end).gap;
}

template <int D>
SignedDistance opening_rate_of(const Encounter<D>& encounter, const Changes& changes, double k) {
  const TrajectoryEstimate<D> path = relative(encounter, changes.estimate<D>(k));
  if ((path.a != 0).any() || encounter.extents.grows || encounter.extents.sum) return std::nullopt;
  return (encounter.x * path.v).sum();
}

std::optional<double> end_between(const std::function<SignedDistance(double)>& distance_at, double p,
                                  double q, double width) {
  double low = p, high = q;
  const SignedDistance at_p = distance_at(p), at_q = at_p ? distance_at(q) : std::nullopt;
  if (!at_q || (*at_p > 0) == (*at_q > 0)) return std::nullopt;
  double low_gap = *at_p, high_gap = *at_q;
  // Regula falsi with the retained end halved (Illinois); steps of half the width close the bracket.
  for (int evaluation = 0, side = 0; high - low > width; ++evaluation) {
    if (evaluation == 60) return std::nullopt;
    double k = low + (high - low) * (low_gap / (low_gap - high_gap));
    if (evaluation % 8 == 7) k = low + 0.5 * (high - low);
    k = std::clamp(k, low + 0.5 * width, high - 0.5 * width);
    if (!(k > low && k < high)) return std::nullopt;
    const SignedDistance gap = distance_at(k);
    if (!gap) return std::nullopt;
    const int now = (*gap > 0) == (low_gap > 0) ? -1 : 1;
    (now < 0 ? low : high) = k;
    (now < 0 ? low_gap : high_gap) = *gap;
    if (now == side) (now < 0 ? high_gap : low_gap) *= 0.5;
    side = now;
  }
  return low + 0.5 * (high - low);
}

template <int D>
bool disc_may_touch(const Encounter<D>& encounter, const TrajectoryEstimate<D>& own,
                    const TurnsBetween& turns) {
  if constexpr (D == 2) {
    const TurnedPaths paths(encounter.x, own.v, encounter.v);
    const Wave side = paths.side_of({0, 0}, {0, 0});
    const double fastest = std::sqrt(dot(own.v, own.v)) + std::sqrt(dot(encounter.v, encounter.v)),
                 near = encounter.extents.radius * fastest;
    const double first = side.at(turns.first), last = side.at(turns.last);
    if (std::min(first, last) < near && std::max(first, last) > -near) return true;
    const Wave farther = first > 0 ? -side : side;
    return farther.peaks_between(turns.first, turns.last) && farther.peak() > -near;
  } else {
    return false;
  }
}

template <int D>
std::vector<TouchingTurns> touching_turns(const Encounter<D>& encounter, const TrajectoryEstimate<D>& own) {
  std::vector<TouchingTurns> found;
  if constexpr (D == 2) {
    const TrajectoryEstimate<2> path = relative(encounter, own);
    if (!encounter.turning || encounter.extents.grows) return found;
    if ((path.a != 0).any() || (own.x != 0).any() || !(path.begin < path.end)) return found;
    const TouchingAbout about(*encounter.turning, encounter.extents.radius, {encounter.x, own.v, encounter.v},
                              path.begin, path.end);
    for (const SineCosine<double>& middle : about.middles()) {
      const SineCosine<double> first = sum_of(middle, about.end(middle, -1)),
                               last = sum_of(middle, about.end(middle, 1));
      if (!about.touches(first) || !about.touches(last)) continue;
      const double from = quick_degrees(first), to = quick_degrees(last);
      found.push_back({from, from > to ? to + 360 : to});
    }
  }
  return found;
}

template SignedDistance gap_of<1>(const Encounter<1>&, const Changes&, double);
template SignedDistance gap_of<2>(const Encounter<2>&, const Changes&, double);
template SignedDistance gap_of<3>(const Encounter<3>&, const Changes&, double);
template SignedDistance opening_rate_of<1>(const Encounter<1>&, const Changes&, double);
template SignedDistance opening_rate_of<2>(const Encounter<2>&, const Changes&, double);
template SignedDistance opening_rate_of<3>(const Encounter<3>&, const Changes&, double);
template bool disc_may_touch<1>(const Encounter<1>&, const TrajectoryEstimate<1>&, const TurnsBetween&);
template bool disc_may_touch<2>(const Encounter<2>&, const TrajectoryEstimate<2>&, const TurnsBetween&);
template bool disc_may_touch<3>(const Encounter<3>&, const TrajectoryEstimate<3>&, const TurnsBetween&);
template std::vector<TouchingTurns> touching_turns<1>(const Encounter<1>&, const TrajectoryEstimate<1>&);
template std::vector<TouchingTurns> touching_turns<2>(const Encounter<2>&, const TrajectoryEstimate<2>&);
template std::vector<TouchingTurns> touching_turns<3>(const Encounter<3>&, const TrajectoryEstimate<3>&);

}  // namespace foresee
