// All motions of a range of changes, for proofs, and some of them, for guesses.
//
//   // 10 to 20 degrees to starboard
//   const TrajectoryFamily<2> turns = trajectory_family<2>(base, change, 10, 20);
//
// What is rough is a motion in plain doubles, near the one that would be stored: where to look, never a
// proof. Cost: some hundred ns.
#pragma once

#include "contact/clearance/pair_extents.h"
#include "motion/manoeuvre.h"
#include "motion/motion_set.h"
#include "shape/bodies.h"

namespace foresee {

// One other object, as an object sees it that is about to change its motion: from the moment and the place of
// the change.
//
//   const Encounter<2> encounter = encounter_of<2>(base, {now, h}, others, row,
//                                           rule.pair<2>(own_row, row, base.t));
//   if (encounter.begin > encounter.end) …                             // never there together
//
// At tau seconds after the change the other is at x + v tau + a tau^2 / 2, each number within its error.
// Positions are differenced in double-double before anything is rounded, so that neither old reports nor
// places far from the origin cost digits. Cost: some tens of nanoseconds.

template <int D>
struct Encounter {
  Vec<D> x, v, a;
  Vec<D> ex, ev;              ///< errors; a is exact
  GrowingExtents<D> extents;  ///< as of the change
  double begin, end;          ///< both exist within the horizon, in seconds after the change, rounded outward
  double inflation = 0;       ///< of some changes the set reaches so much farther, or less far …
  double rotation_chord = 0;  ///< … as it is turned by this, in lengths of what turns

  bool bends() const { return (a != 0).any(); }
};

/// `base`: the motion that is changed, as of the change. Of what doubles do not hold, numbers are not finite.
template <int D>
Encounter<D> encounter_of(const OwnMotion& base, const Horizon& horizon, const Bodies& others,
                          const double* row, const GrowingExtents<D>& extents);

/// Of a bent path, in looking for a moment: none is proven by that.
inline constexpr int sampled_times = 32;
/// What is taken for touching: relative to the lengths at hand, more than a proof at any width asks for.
inline constexpr double touching_share = 0x1p-42;

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
  Vec<D> upper[3], lower[3];  ///< of places, velocities and accelerations along each axis
  double turned[3];   ///< how far an arc of these leaves its chord at most; 0: what does not turn is straight
  bool bends;         ///< any of them is accelerated
  bool one_interval;  ///< what is not bent touches for the changes of one interval
};

template <int D>
TrajectoryFamily<D> trajectory_family(const OwnMotion& base, const Change& change, double p, double q);

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
