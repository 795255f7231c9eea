#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "contact/clearance/separation.h"
#include "contact/clearance/separation_case.h"
#include "contact/clearance/spread_of_changes.h"

namespace foresee {
namespace {

/// Half the slope of a squared distance, and its changes of sign during [0, end].
class SlopeOfDistance {
 public:
  template <int D>
  SlopeOfDistance(const TrajectoryEstimate<D>& path, const AxisRange& axes, double end) {
    for (int axis = axes.begin; axis < axes.end; ++axis) {
      const double x = path.x[axis], v = path.v[axis], a = path.a[axis];
      c_[0] += x * v, c_[1] += v * v + x * a, c_[2] += 1.5 * v * a, c_[3] += 0.5 * a * a;
    }
    // Between two of its extrema it has at most one root.
    const double half = c_[2] / 3, square = half * half - c_[3] * c_[1] / 3;
    std::array<double, 4> between{0, end, end, end};
    std::size_t count = 1;
    const auto turns_at = [&](double tau) {
      if (tau > 0 && tau < end) between[count++] = tau;
    };
    if (square > 0) {
      const double far = half + std::copysign(std::sqrt(square), half);
      if (c_[3] != 0) turns_at(-far / c_[3]);
      if (far != 0) turns_at(-c_[1] / 3 / far);
    }
    if (count == 3 && between[1] > between[2]) std::swap(between[1], between[2]);
    between[count] = end;
    instants_[count_++] = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const double first = between[i], last = between[i + 1];
      if ((at(first) < 0) == (at(last) < 0)) continue;
      const bool falls = at(last) < 0;
      instants_[count_++] = first_between(first, last, [&](double tau) { return (at(tau) < 0) == falls; });
    }
    instants_[count_++] = end;
  }

  double at(double tau) const { return c_[0] + tau * (c_[1] + tau * (c_[2] + tau * c_[3])); }
  /// Sorted, from 0 to the end: between two of them the distance is monotone.
  std::span<const double> instants() const { return {instants_.data(), count_}; }
  bool shrinks_after(std::size_t time) const { return at(0.5 * (instants_[time] + instants_[time + 1])) < 0; }

  /// Approximately the first time at which the predicate holds. Requires: it holds at `last`.
  template <class Predicate>
  static double first_between(double first, double last, const Predicate& holds) {
    for (int cut = 0; cut < 48; ++cut) {
      const double middle = 0.5 * (first + last);
      if (middle <= first || middle >= last) break;
      (holds(middle) ? last : first) = middle;
    }
    return last;
  }

 private:
  std::array<double, 4> c_{};
  std::array<double, 6> instants_{};
  std::size_t count_ = 0;
};

/// Axes on which the two overlap at first; it is enough to leave them once.
struct LeftTogether {
  AxisRange axes;
  double half;                   ///< where the overlap ends, from the middle
  double grows_from;             ///< the distance increases from here …
  double exits;                  ///< … until the axes are left, or until the end
  std::array<double, 2> enters;  ///< when they are entered again, or the end
};

/// The approximate course of one change, in plain doubles: where a proof is attempted.
template <int D>
class Course {
 public:
  Course(const PairExtents<D>& extents, const TrajectoryEstimate<D>& path, double end)
      : extents_(extents), path_(path), end_(end), slope_(path, {0, D}, end) {
    leaves_ = approaches_ = end;
    for (int axis = 0; axis < D; axis = groups_[count_ - 1].axes.end) {
      const bool round = axis == 0 && is_disc();
      const AxisRange axes{axis, round ? extents.round_axes : axis + 1};
      groups_[count_++] = left_together(axes, round ? extents.radius : extents.half[axis]);
    }
    find_end();
    find_shrinking();
  }

  double leaves() const { return leaves_; }          ///< or the end
  double approaches() const { return approaches_; }  ///< again, on any axes that it has left; or the end
  double fastest_approach() const { return fastest_approach_; }  ///< while others touch too; below 0: never
  double first_approach() const { return first_approach_; }      ///< the first; below 0: never
  double touches_again() const { return again_; }                ///< at its deepest; below 0: never
  double farthest_before() const { return farthest_; }           ///< between leaving and touching again
  std::span<const LeftTogether> groups() const { return {groups_.data(), count_}; }
  /// A disc or a ball: half extents are 0 on the round axes.
  bool is_disc() const {
    for (int axis = 0; axis < extents_.round_axes; ++axis)
      if (extents_.half[axis] != 0) return false;
    return D > 1;
  }
  bool is_ball() const { return is_disc() && extents_.round_axes == D; }

 private:
  double depth(double tau) const {
    Vec<D> ignored;
    return signed_distance<D>(extents_, place_at<D>(path_, tau), ignored);
  }

  LeftTogether left_together(const AxisRange& axes, double half) {
    const SlopeOfDistance slope(path_, axes, end_);
    const auto is_outside = [&](double tau) {
      const Vec<D> place = place_at<D>(path_, tau);
      double sum = 0;
      for (int axis = axes.begin; axis < axes.end; ++axis) sum += place[axis] * place[axis];
      return sum > half * half;
    };
    const std::span<const double> instants = slope.instants();
    LeftTogether group{axes, half, end_, end_, {end_, end_}};
    const auto is_inside = [&](double tau) { return !is_outside(tau); };
    bool left = false;
    std::size_t entered = 0;
    for (std::size_t i = 0; i + 1 < instants.size(); ++i) {
      const bool shrinks = slope.shrinks_after(i);
      if (left && shrinks) {
        approaches_ = std::min(approaches_, instants[i]);
        if (entered < 2 && is_inside(instants[i + 1]))
          group.enters[entered++] = SlopeOfDistance::first_between(instants[i], instants[i + 1], is_inside);
      }
      if (left || shrinks) continue;
      if (group.grows_from == end_ || i == 0 || slope.shrinks_after(i - 1)) group.grows_from = instants[i];
      if (!is_outside(instants[i + 1])) continue;
      left = true, group.exits = SlopeOfDistance::first_between(instants[i], instants[i + 1], is_outside);
    }
    return group;
  }

  void find_end() {
    const auto is_apart = [&](double tau) { return depth(tau) > 0; };
    double before = 0, greatest = 0, deepest = 0;
    bool left = false;
    const auto sample_at = [&](double tau) {
      const double here = depth(tau);
      if (!left && here > 0 && tau > 0)
        left = true, farthest_ = tau, leaves_ = SlopeOfDistance::first_between(before, tau, is_apart);
      before = tau;
      if (left && again_ < 0 && here > greatest) greatest = here, farthest_ = tau;
      if (left && here <= deepest) deepest = here, again_ = tau;
    };
    // All extrema and the times between them.
    std::array<double, sampled_times + 40> instants{};
    std::size_t count = 0;
    for (int i = 0; i <= sampled_times; ++i) instants[count++] = end_ * i / sampled_times;
    for (int i = 1; i <= 12; ++i) instants[count++] = end_ / sampled_times * std::exp2(-2 * i);
    for (const double tau : slope_.instants()) instants[count++] = tau;
    for (const LeftTogether& group : groups()) {
      for (const double tau : {group.exits, group.enters[0], group.enters[1]}) instants[count++] = tau;
      if (extents_.round_axes < D || !is_disc()) instants[count++] = turn_of(group.axes.begin);
    }
    std::sort(instants.begin(), instants.begin() + static_cast<std::ptrdiff_t>(count));
    for (std::size_t i = 0; i < count; ++i) {
      if (i > 0) sample_at(0.5 * (instants[i - 1] + instants[i]));
      sample_at(instants[i]);
    }
    double step = end_ / sampled_times;
    for (int evaluation = 0; again_ >= 0 && evaluation < 24; ++evaluation, step *= 0.5)
      for (const double tau : {again_ - step, again_ + step})
        if (tau > farthest_ && tau <= end_ && depth(tau) < deepest) deepest = depth(tau), again_ = tau;
  }
  double turn_of(int axis) const {
    return path_.a[axis] == 0 ? 0 : std::clamp(-path_.v[axis] / path_.a[axis], 0.0, end_);
  }

  void find_shrinking() {
    const std::span<const double> instants = slope_.instants();
    for (std::size_t i = 0; i + 1 < instants.size(); ++i) {
      if (!slope_.shrinks_after(i)) continue;
      approaches_ = std::min(approaches_, instants[i]);
      if (first_approach_ < 0) first_approach_ = 0.5 * (instants[i] + instants[i + 1]);
      const double last = std::min(instants[i + 1], leaves_);
      for (int part = 0; part <= 8 && instants[i] < leaves_; ++part) {
        const double tau = instants[i] + (last - instants[i]) * part / 8;
        const double approach = slope_.at(tau) * (leaves_ < end_ ? leaves_ - tau : 1);
        if (approach < fastest_) fastest_ = approach, fastest_approach_ = tau;
      }
    }
  }

  const PairExtents<D>& extents_;
  TrajectoryEstimate<D> path_;
  double end_, leaves_ = 0, approaches_ = 0;
  double fastest_approach_ = -1, first_approach_ = -1, again_ = -1, farthest_ = 0, fastest_ = 0;
  SlopeOfDistance slope_;
  std::array<LeftTogether, D> groups_{};
  std::size_t count_ = 0;
};

/// The certificate of one range of changes.
template <int D>
class BentSeparation {
 public:
  BentSeparation(const Encounter<D>& encounter, const TrajectoryFamily<D>& family)
      : encounter_(encounter),
        family_(family),
        separation_(encounter, family),
        spread_(encounter, family),
        course_(encounter.extents, relative(encounter, family.middle), separation_.end()) {}

  CountedVerdict certify() {
    const ClearanceVerdict one = verdict();
    return {one, evaluations_};
  }

 private:
  static constexpr AxisRange all_axes{0, D};

  ClearanceVerdict verdict() {
    const double end = separation_.end(), leaves = course_.leaves();
    if (course_.fastest_approach() < 0 && course_.touches_again() < 0) {
      if (leaves < end && is_proven_at(0.5)) return ClearanceVerdict::clear;
      if (course_.approaches() == end && (leaves == end || course_.is_ball()) && separates_until(end))
        return ClearanceVerdict::clear;
      return all_shrink_at(course_.first_approach()) ? ClearanceVerdict::blocked
                                                     : ClearanceVerdict::undecided;
    }
    return all_shrink_at(course_.fastest_approach()) || all_touch_again() ? ClearanceVerdict::blocked
                                                                          : ClearanceVerdict::undecided;
  }

  /// Both proofs join at this share of the time between leaving and the next approach of the middle change,
  /// or near an end of that time.
  bool is_proven_at(double share) {
    const double time = course_.leaves() + share * (course_.approaches() - course_.leaves());
    const bool separates = separates_until(time);
    if (separates && separation_.is_proven_after(time)) return true;
    return share == 0.5 && is_proven_at(separates ? 0.9 : 0.1);
  }

  /// Until `end` the distance does not decrease, and what has left does not return.
  bool separates_until(double end) {
    if (!spread_.never_shrinks(all_axes, 0, end, evaluations_)) return false;
    if (course_.is_ball()) return true;
    for (const LeftTogether& group : course_.groups())
      if (!leaves_once(group, end)) return false;
    return true;
  }
  /// Inside at first, and then at an increasing distance.
  bool leaves_once(const LeftTogether& group, double end) {
    if (spread_.never_shrinks(group.axes, 0, end, evaluations_)) return true;
    if (group.exits >= end && remains_within(group, end)) return true;
    const double exits = std::min(group.exits, end), from = std::min(group.grows_from, exits),
                 time = from + 0.5 * (exits - from);
    return remains_within(group, time) && spread_.never_shrinks(group.axes, time, end, evaluations_);
  }
  bool remains_within(const LeftTogether& group, double end) {
    return group.axes.end - group.axes.begin > 1 ? spread_.remains_within_disc(group.half, end, evaluations_)
                                                 : spread_.remains_within(group.axes.begin, group.half, end);
  }

  /// At tau all changes touch, or nearly, while the distance decreases.
  bool all_shrink_at(double tau) const {
    return tau >= 0 && spread_.slope(all_axes, tau).high <= 0 && separation_.all_touch_about(tau);
  }
  /// All changes touch again, at one time or each at its own, after a time at which all are apart.
  bool all_touch_again() const {
    const double again = course_.touches_again();
    if (again < 0 || !separation_.none_touches_about(course_.farthest_before())) return false;
    if (separation_.all_touch_about(again)) return true;
    const auto again_of = [&](const TrajectoryEstimate<D>& own) {
      return Course<D>(encounter_.extents, relative(encounter_, own), separation_.end()).touches_again();
    };
    const double first = again_of(family_.first), last = first < 0 ? -1 : again_of(family_.last);
    return last >= 0 && std::min(first, last) > course_.farthest_before() &&
           separation_.all_touch_between(first, last);
  }

  const Encounter<D>& encounter_;
  const TrajectoryFamily<D>& family_;
  std::uint64_t evaluations_ = sampled_times;
  SeparationCase<D> separation_;
  SpreadOfChanges<D> spread_;
  Course<D> course_;
};

}  // namespace

template <int D>
CountedVerdict certify_bent_separation(const Encounter<D>& encounter, const TrajectoryFamily<D>& family) {
  return BentSeparation<D>(encounter, family).certify();
}

template CountedVerdict certify_bent_separation<1>(const Encounter<1>&, const TrajectoryFamily<1>&);
template CountedVerdict certify_bent_separation<2>(const Encounter<2>&, const TrajectoryFamily<2>&);
template CountedVerdict certify_bent_separation<3>(const Encounter<3>&, const TrajectoryFamily<3>&);

}  // namespace foresee
