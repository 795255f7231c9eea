// What one change does that touches at first and moves away on a bent path, roughly: where to look for a
// proof.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "contact/clearance/spread_of_changes.h"
#include "contact/clearance/straight_approach.h"

namespace foresee {

/// Half the slope of a squared distance, and where it changes its sign during [0, end].
class SlopeOfDistance {
 public:
  template <int D>
  SlopeOfDistance(const TrajectoryEstimate<D>& path, const AxisRange& axes, double end) {
    for (int axis = axes.begin; axis < axes.end; ++axis) {
      const double x = path.x[axis], v = path.v[axis], a = path.a[axis];
      c_[0] += x * v, c_[1] += v * v + x * a, c_[2] += 1.5 * v * a, c_[3] += 0.5 * a * a;
    }
    // Between its own turning points it has one root at most.
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
  /// From 0 to the end: between two of them the distance grows, or shrinks.
  std::span<const double> instants() const { return {instants_.data(), count_}; }
  bool shrinks_after(std::size_t time) const { return at(0.5 * (instants_[time] + instants_[time + 1])) < 0; }

  /// The first moment at which `is` is so, nearly. Requires: so it is at `last`.
  template <class Is>
  static double first_between(double first, double last, const Is& is) {
    for (int cut = 0; cut < 48; ++cut) {
      const double middle = 0.5 * (first + last);
      if (middle <= first || middle >= last) break;
      (is(middle) ? last : first) = middle;
    }
    return last;
  }

 private:
  std::array<double, 4> c_{};
  std::array<double, 6> instants_{};
  std::size_t count_ = 0;
};

/// Some axes on which the two are inside of each other at first: leaving them once is enough.
struct LeftTogether {
  AxisRange axes;
  double half;                   ///< how far from the middle that ends
  double grows_from;             ///< the distance grows from here on …
  double exits;                  ///< … until it is left, here, or at the end
  std::array<double, 2> enters;  ///< and entered again, or at the end
};

/// One change.
template <int D>
class PartingCourse {
 public:
  PartingCourse(const PairExtents<D>& extents, const TrajectoryEstimate<D>& path, double end)
      : extents_(extents), way_(path), end_(end), slope_(path, {0, D}, end) {
    leaves_ = stays_until_ = end;
    for (int axis = 0; axis < D;) {
      const bool round = axis == 0 && is_disc();
      const AxisRange axes{axis, round ? extents.round_axes : axis + 1};
      groups_[count_++] = left_together(axes, round ? extents.radius : extents.half[axis]);
      axis = axes.end;
    }
    find_end();
    find_shrinking();
  }

  double leaves() const { return leaves_; }              ///< or the end
  double stays_until() const { return stays_until_; }    ///< nothing that is left comes nearer before
  double shrinks_most() const { return shrinks_most_; }  ///< before it has left; below 0: never
  double shrinks_next() const { return shrinks_next_; }  ///< for the first time; below 0: never
  double touches_again() const { return again_; }        ///< where it is deepest; below 0: never
  double farthest_before() const { return farthest_; }   ///< after it has left, before it touches again
  std::span<const LeftTogether> groups() const { return {groups_.data(), count_}; }
  /// A disc or ball: no box is within.
  bool is_disc() const {
    for (int axis = 0; axis < extents_.round_axes; ++axis)
      if (extents_.half[axis] != 0) return false;
    return D > 1;
  }
  bool is_ball() const { return is_disc() && extents_.round_axes == D; }

 private:
  double depth(double tau) const {
    Vec<D> ignored;
    return signed_distance<D>(extents_, place_at<D>(way_, tau), ignored);
  }

  LeftTogether left_together(const AxisRange& axes, double half) {
    const SlopeOfDistance slope(way_, axes, end_);
    const auto is_outside = [&](double tau) {
      const Vec<D> place = place_at<D>(way_, tau);
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
        stays_until_ = std::min(stays_until_, instants[i]);
        if (entered < 2 && is_inside(instants[i + 1]))
          group.enters[entered++] = SlopeOfDistance::first_between(instants[i], instants[i + 1], is_inside);
      }
      if (left || shrinks) continue;
      if (group.grows_from == end_ || i == 0 || slope.shrinks_after(i - 1)) group.grows_from = instants[i];
      if (!is_outside(instants[i + 1])) continue;
      left = true;
      group.exits = SlopeOfDistance::first_between(instants[i], instants[i + 1], is_outside);
    }
    return group;
  }

  void find_end() {
    const auto is_apart = [&](double tau) { return depth(tau) > 0; };
    double before = 0, greatest = 0, deepest = 0;
    bool left = false;
    const auto look_at = [&](double tau) {
      const double here = depth(tau);
      if (!left && here > 0 && tau > 0) {
        left = true, leaves_ = SlopeOfDistance::first_between(before, tau, is_apart);
        farthest_ = tau;
      }
      before = tau;
      if (left && again_ < 0 && here > greatest) greatest = here, farthest_ = tau;
      if (left && here <= deepest) deepest = here, again_ = tau;
    };
    // Whenever anything turns, and in between.
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
      if (i > 0) look_at(0.5 * (instants[i - 1] + instants[i]));
      look_at(instants[i]);
    }
    double step = end_ / sampled_times;
    for (int evaluation = 0; again_ >= 0 && evaluation < 24; ++evaluation, step *= 0.5)
      for (const double tau : {again_ - step, again_ + step})
        if (tau > farthest_ && tau <= end_ && depth(tau) < deepest) deepest = depth(tau), again_ = tau;
  }
  double turn_of(int axis) const {
    return way_.a[axis] == 0 ? 0 : std::clamp(-way_.v[axis] / way_.a[axis], 0.0, end_);
  }

  void find_shrinking() {
    const std::span<const double> instants = slope_.instants();
    for (std::size_t i = 0; i + 1 < instants.size(); ++i) {
      if (!slope_.shrinks_after(i)) continue;
      stays_until_ = std::min(stays_until_, instants[i]);
      if (shrinks_next_ < 0) shrinks_next_ = 0.5 * (instants[i] + instants[i + 1]);
      const double last = std::min(instants[i + 1], leaves_);
      for (int part = 0; part <= 8 && instants[i] < leaves_; ++part) {
        const double tau = instants[i] + (last - instants[i]) * part / 8;
        if (slope_.at(tau) < least_) least_ = slope_.at(tau), shrinks_most_ = tau;
      }
    }
  }

  const PairExtents<D>& extents_;
  TrajectoryEstimate<D> way_;
  double end_, leaves_ = 0, stays_until_ = 0;
  double shrinks_most_ = -1, shrinks_next_ = -1, again_ = -1, farthest_ = 0, least_ = 0;
  SlopeOfDistance slope_;
  std::array<LeftTogether, D> groups_{};
  std::size_t count_ = 0;
};

}  // namespace foresee
