// All motions of a range of changes, for proofs, and some of them, for guesses.
//
//   // 10 to 20 degrees to starboard
//   const TrajectoryFamily<2> turns = trajectory_family<2>(base, change, 10, 20);
//
// What is rough is a motion in plain doubles, near the one that would be stored: where to look, never a
// proof. Cost: some hundred ns.
#pragma once

#include "contact/clearance/encounter.h"
#include "motion/motion_set.h"

namespace foresee {

/// Of a bent path, in looking for a moment: none is proven by that.
inline constexpr int sampled_times = 32;
/// What is taken for touching: relative to the lengths at hand, more than a proof at any width asks for.
inline constexpr double touching_share = 0x1p-44;

/// One motion, roughly: as of the change, the place as seen from the base's own, and when it exists.
template <int D>
struct TrajectoryEstimate {
  Vec<D> x, v, a;
  double begin = 0, end = 0;
};

/// The changed motions of a range, and some of them.
template <int D>
struct TrajectoryFamily {
  MotionSet<D> all;
  TrajectoryEstimate<D> middle, first, last;
  Vec<D> upper[3], lower[3];            ///< of places, velocities and accelerations along each axis
  double turned[3]{};                   ///< how far an arc of these leaves its chord; 0: a segment
  bool delayed = false;                 ///< each has a start of its own, at one place …
  double delay_from = 0, delay_to = 0;  ///< … so long after the base's t …
  VectorSet<D> at_start;                ///< … and with one velocity
  bool is_from_start = false;           ///< seen_from_start(): what differs is where the other is
  bool bends;                           ///< any of them is accelerated
  bool one_interval;                    ///< what is not bent touches for the changes of one interval
};

template <int D>
TrajectoryFamily<D> trajectory_family(const OwnMotion& base, const Change& change, double p, double q);

/// The ends on each axis, of what `all` is by now.
template <int D>
void find_ends(TrajectoryFamily<D>& family);

template <int D>
TrajectoryEstimate<D> trajectory_estimate(const OwnMotion& base, const Change& change, double k);

/// The two seen from each other, roughly.
template <int D>
TrajectoryEstimate<D> relative(const Encounter<D>& encounter, const TrajectoryEstimate<D>& own) {
  return {encounter.x - own.x, encounter.v - own.v, encounter.a - own.a, std::max(encounter.begin, own.begin),
          std::min(encounter.end, own.end)};
}

template <int D>
Vec<D> place_at(const TrajectoryEstimate<D>& path, double tau) {
  return path.x + tau * (path.v + (0.5 * tau) * path.a);
}

}  // namespace foresee
