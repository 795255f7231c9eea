// One range of changes and one encounter: the search for separating planes, and the test whether all changes
// touch.
#pragma once

#include <array>

#include "contact/clearance/separating_plane.h"
#include "contact/clearance/straight_approach.h"

namespace foresee {

/// The result of the search for a plane from one guess.
enum class ProbeResult : std::uint8_t { separated, overlapping, inconclusive };

template <int D>
class SeparationCase {
 public:
  SeparationCase(const Encounter<D>& encounter, const TrajectoryFamily<D>& family)
      : encounter_(encounter),
        family_(family),
        begin_(std::max(encounter.begin, family.all.begin)),
        end_(std::min(encounter.end, family.all.end)),
        bends_(family.bends || encounter.bends()),
        slack_(encounter.extents.sum ? 4 * touching_share : touching_share) {}

  bool never_together() const { return begin_ > end_; }
  /// No intermediate result overflows.
  bool is_finite() const {
    const Vec<D> far = encounter_.x.abs() + end_ * (encounter_.v.abs() + end_ * encounter_.a.abs());
    return std::isfinite(far.sum()) && std::isfinite(scale_at(end_)) && std::isfinite(width_at(end_));
  }
  bool bends() const { return bends_; }
  /// How many intervals of time have been tested, on bent paths.
  std::uint64_t parts() const { return parts_; }
  double begin() const { return begin_; }
  double end() const { return end_; }

  /// Whether there is a plane from begin() on, with the normal guessed from one motion, or on bent paths one per
  /// interval of time. `tau`: when that motion touches, or is nearest.
  ProbeResult probe(const TrajectoryEstimate<D>& own, double& tau) const {
    return probe_from(own, begin_, tau);
  }
  ProbeResult probe_from(const TrajectoryEstimate<D>& own, double begin, double& tau) const {
    const TrajectoryEstimate<D> path = relative(encounter_, own);
    if (bends_) return probe_bent(path, begin, tau);
    const auto approach = straight_approach<D>(encounter_.extents, path.x, path.v, begin, end_);
    tau = approach.tau;
    if (!(approach.gap > 0)) return ProbeResult::overlapping;
    return any_plane_proves(path, approach, begin) ? ProbeResult::separated : ProbeResult::inconclusive;
  }

  /// Whether any of three motions gives such planes.
  bool is_proven_after(double begin) const {
    if (begin > end_) return true;
    double ignored = 0;
    for (const TrajectoryEstimate<D>* own : {&family_.middle, &family_.first, &family_.last})
      if (probe_from(*own, begin, ignored) == ProbeResult::separated) return true;
    return false;
  }

  void start_at(double begin) { begin_ = begin; }
  /// From now on a motion that nearly touches does not count as touching.
  void require_certain_touches() { slack_ = -slack_; }

  bool touches(const TrajectoryEstimate<D>& own) const {
    const TrajectoryEstimate<D> path = relative(encounter_, own);
    return path.begin <= path.end && touches(approach_of(path));
  }
  bool touches(const StraightApproach<D>& approach) const { return approach.gap <= slack_at(approach.tau); }
  StraightApproach<D> approach_of(const TrajectoryEstimate<D>& path) const {
    return straight_approach<D>(encounter_.extents, path.x, path.v, path.begin, path.end);
  }
  /// Whether there is a plane from `begin` on, or two, at the nearest approach of one path that is not bent.
  bool any_plane_proves(const TrajectoryEstimate<D>& path, const StraightApproach<D>& approach,
                        double begin) const {
    if (plane_proves<D>(encounter_, family_, approach.normal, begin, end_)) return true;
    if (encounter_.turning) {
      const bool passes = begin < approach.tau && approach.tau < end_;
      if (passes
              ? two_planes_prove<D>(encounter_, family_, approach.normal, path.v, approach.tau, begin, end_)
              : turning_plane_proves<D>(encounter_, family_, approach.normal, begin, end_))
        return true;
    }
    return approach.gap <= 0x1p-30 * scale_at(approach.tau) &&
           tilted_plane_proves<D>(encounter_, family_, approach.normal, path.v, begin, end_);
  }

  /// A smaller distance counts as touching.
  double slack_at(double tau) const { return slack_ * scale_at(tau); }

  /// Whether all motions of the range touch at tau, or at the time nearest to it at which all exist. On one
  /// axis also whether all pass the other object. Approximate.
  bool all_touch_about(double tau) const {
    const double first = last_begin(), last = first_end();
    if (first > last) return false;
    tau = std::clamp(tau, first, last);
    if constexpr (D == 1)
      if (all_pass(first, last, tau)) return true;
    return all_touch_at(tau);
  }

  /// Whether all touch, if all positions of the range at one time are on a segment, or on an arc near one. A convex
  /// set contains a segment whose ends it contains.
  bool ends_touch_about(double tau) const {
    const double first = last_begin(), last = first_end();
    if (first > last) return false;
    tau = std::clamp(tau, first, last);
    const double slack = slack_at(tau), depth = family_.turned[0] - slack;
    const double turned = tau * (family_.turned[1] + 0.5 * tau * family_.turned[2]) + encounter_.inflation;
    for (const TrajectoryEstimate<D>* end : {&family_.first, &family_.last})
      if (!touches_at(place_at<D>(relative(encounter_, *end), tau), tau, depth + turned, depth)) return false;
    return true;
  }

  /// Whether all touch, each at its own time between those of the first and the last change. Their positions
  /// then are near a chord, and a convex set contains a chord whose ends it contains. Approximate.
  bool all_touch_between(double tau_first, double tau_last) const {
    const double earlier = std::min(tau_first, tau_last), later = std::max(tau_first, tau_last);
    if (encounter_.extents.sum || !(earlier >= last_begin() && later <= first_end())) return false;
    const double half = 0.5 * (later - earlier);
    const Vec<D> bend = (encounter_.a - family_.upper[2]).abs().max((encounter_.a - family_.lower[2]).abs());
    const Vec<D> wide = (family_.upper[1] - family_.lower[1]) + later * (family_.upper[2] - family_.lower[2]);
    const double turned = family_.turned[0] + later * (family_.turned[1] + 0.5 * later * family_.turned[2]);
    Vec<D> off_chord = 0.5 * half * (half * bend + wide) + turned, ignored;
    for (int axis = 0; axis < D; ++axis)
      if (encounter_.extents.is_thin(axis)) off_chord[axis] = 0;  // each passes there at a time of its own
    const auto touches_at_end = [&](const TrajectoryEstimate<D>& own, double tau) {
      const Vec<D> far = place_at<D>(relative(encounter_, own), tau).abs() + off_chord;
      return signed_distance<D>(encounter_.extents.after(earlier), far, ignored) <= slack_at(tau);
    };
    return touches_at_end(family_.first, tau_first) && touches_at_end(family_.last, tau_last);
  }

  /// Whether both exist when any change starts, and for some time after.
  bool all_start_together() const { return last_begin() <= 0 && first_end() > 0; }

  /// Whether none touches at tau, by the middle change and the distance of all others from it. Approximate.
  bool none_touches_about(double tau) const {
    Vec<D> ignored;
    const Vec<D> place = place_at<D>(relative(encounter_, family_.middle), tau);
    return signed_distance<D>(encounter_.extents.after(tau), place, ignored) > width_at(tau);
  }

  /// When one of the motions is nearest, if its path is not bent.
  double nearest_time(const TrajectoryEstimate<D>& own) const {
    const TrajectoryEstimate<D> path = relative(encounter_, own);
    return path.begin <= path.end ? approach_of(path).tau : begin_;
  }

 private:
  /// Whether a position is inside by `round` on the round axes, and by `upright` on the others.
  bool touches_at(const Vec<D>& place, double tau, double round, double upright) const {
    const PairExtents<D> extents = encounter_.extents.after(tau);
    const Vec<D> over = place.abs() - extents.half;
    for (int axis = extents.round_axes; axis < D; ++axis)
      if (!(over[axis] <= -upright)) return false;
    Vec<D> ignored;
    return signed_distance_in_round_axes<D>(extents, over, place, ignored) <= -round;
  }

  /// Whether all are on one side of the other object at one time and on the opposite side at another time.
  bool all_pass(double first, double last, double tau) const {
    bool below = false, above = false;
    const auto evaluate_at = [&](double at) {
      const int side = side_at(std::clamp(at, first, last));
      below = below || side < 0, above = above || side > 0;
    };
    for (const double at : {first, tau, last}) evaluate_at(at);
    for (const TrajectoryEstimate<D>* own : {&family_.first, &family_.middle, &family_.last}) {
      const TrajectoryEstimate<D> path = relative(encounter_, *own);
      if (path.a[0] != 0) evaluate_at(-path.v[0] / path.a[0]);  // where it reverses
    }
    return below && above;
  }

  /// The side of the other object on which all are: 1 or -1; 0: they are on both.
  int side_at(double tau) const {
    const double highest = place_of(family_.lower, 0, tau), lowest = place_of(family_.upper, 0, tau);
    return lowest > 0 ? 1 : highest < 0 ? -1 : 0;
  }

  bool all_touch_at(double tau) const {
    const double slack = slack_at(tau);
    const PairExtents<D> extents = encounter_.extents.after(tau);
    double square = 0;
    int first = 0;
    if constexpr (D > 1)
      if (extents.sum) {
        const double half = half_diagonal(tau);
        Vec<D> middle = Vec<D>::zero(), ignored;
        for (int axis = 0; axis < 2; ++axis)
          middle[axis] = 0.5 * (place_of(family_.upper, axis, tau) + place_of(family_.lower, axis, tau));
        if (!(signed_distance_in_round_axes<D>(extents, middle, middle, ignored) + half +
                  encounter_.inflation <=
              slack))
          return false;
        first = 2;
      }
    for (int axis = first; axis < D; ++axis) {
      const double far = farthest(axis, tau) - extents.half[axis];
      if (axis >= extents.round_axes) {
        if (!(far <= slack)) return false;
      } else if (far > 0) {
        square += far * far;
      }
    }
    return first > 0 || std::sqrt(square) <= extents.radius + slack;
  }

  /// Half the diagonal in x and y of the box around all positions of the range at tau.
  double half_diagonal(double tau) const {
    double square = 0;
    for (int axis = 0; axis < 2; ++axis) {
      const double half = 0.5 * (place_of(family_.upper, axis, tau) - place_of(family_.lower, axis, tau));
      square += half * half;
    }
    return std::sqrt(square);
  }

  /// The other object on one axis, relative to an end of the range's positions, velocities and accelerations.
  double place_of(const Vec<D> (&end)[3], int axis, double tau) const {
    const auto at = [&](double x, double v, double a) { return x + tau * (v + 0.5 * tau * a); };
    return at(encounter_.x[axis], encounter_.v[axis], encounter_.a[axis]) -
           at(end[0][axis], end[1][axis], end[2][axis]);
  }
  /// The largest distance from the origin on one axis at tau.
  double farthest(int axis, double tau) const {
    return std::max(std::abs(place_of(family_.upper, axis, tau)),
                    std::abs(place_of(family_.lower, axis, tau)));
  }

  /// All motions exist from the first of these times until the second.
  double last_begin() const { return std::max({begin_, family_.first.begin, family_.last.begin}); }
  double first_end() const { return std::min({end_, family_.first.end, family_.last.end}); }

  double scale_at(double tau) const {
    const Vec<D> v = family_.upper[1].abs().max(family_.lower[1].abs()) + encounter_.v.abs();
    const PairExtents<D> extents = encounter_.extents.after(tau);
    const double sum = extents.sum ? extents.sum->size() : 0;
    return (encounter_.x.abs() + extents.half.abs() + tau * v).largest() + std::abs(extents.radius) + sum;
  }

  /// Splits the time into intervals, in each of which the path is approximated by a straight one.
  ProbeResult probe_bent(const TrajectoryEstimate<D>& path, double begin, double& tau) const {
    struct Part {
      double begin, end;
    };
    std::array<Part, 64> parts;
    std::size_t count = 0;
    parts[count++] = {begin, end_};
    for (int evaluations = 0; count > 0; ++evaluations, ++parts_) {
      const Part part = parts[--count];
      const double middle = 0.5 * (part.begin + part.end), length = part.end - part.begin;
      const Vec<D> v = path.v + middle * path.a, x = place_at<D>(path, middle) - middle * v;
      const auto approach = straight_approach<D>(encounter_.extents, x, v, part.begin, part.end);
      tau = approach.tau;
      if (approach.gap > 0 && plane_proves<D>(encounter_, family_, approach.normal, part.begin, part.end))
        continue;
      // The nearest place of the bent path, not of its tangent: along its normal the path may bend away.
      Vec<D> normal;
      if (!(signed_distance<D>(encounter_.extents.after(tau), place_at<D>(path, tau), normal) >
            slack_at(tau))) {
        parts_ += sampled_times;
        tau = deepest_time<D>(encounter_.extents, path, begin_, end_, tau);
        return ProbeResult::overlapping;
      }
      if (plane_proves<D>(encounter_, family_, normal, part.begin, part.end)) continue;
      // Compares what a shorter time gains with what only a narrower range gains.
      const Vec<D> along = family_.is_from_start ? approach.normal : Vec<D>::constant(1);
      const double bend = 0.125 * length * length * (along * path.a).abs().sum();
      if (evaluations > 200 || !(bend > 0.5 * width_along(along, part.end))) return ProbeResult::inconclusive;
      parts[count++] = {middle, part.end};
      parts[count++] = {part.begin, middle};
      if (count + 2 > parts.size()) return ProbeResult::inconclusive;
    }
    return ProbeResult::separated;
  }

  /// Upper bound of the distance of two motions of the range at tau.
  double width_at(double tau) const { return width_along(Vec<D>::constant(1), tau); }
  double width_along(const Vec<D>& n, double tau) const {
    const Vec<D> v = family_.upper[1] - family_.lower[1], a = family_.upper[2] - family_.lower[2];
    return (n.abs() * (family_.upper[0] - family_.lower[0] + tau * (v + 0.5 * tau * a))).sum();
  }

  const Encounter<D>& encounter_;
  const TrajectoryFamily<D>& family_;
  double begin_, end_;
  bool bends_;
  double slack_;
  mutable std::uint64_t parts_ = 0;
};

}  // namespace foresee
