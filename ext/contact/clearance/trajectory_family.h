// All motions of a range of changes, the encounter with one other object, and approximate motions for
// guesses.
//
//   const Encounter<2> encounter = encounter_of<2>(base, {now, h}, others, row,
//                                                  extents_of_both<2>(rule, own_row, row, base.t));
//   if (encounter.begin > encounter.end) …                             // they never exist together
//   const auto changes = changes_by(Manoeuvre::turn, base);
//   const TrajectoryFamily<2> turns = trajectory_family<2>(*changes, 10, 20);      // degrees to starboard
//
// The reference frame of both is the time and position at which the manoeuvre starts. At tau seconds after that the
// other object is at x + v tau + a tau^2 / 2, each number within its error. Differences of positions are
// taken in double-double before they are rounded, so that neither old reports nor distant positions lose
// digits. Families hold exact bounds of all motions; estimates are motions in plain doubles, near the stored
// ones, and prove nothing.
// Cost: some tens of nanoseconds per encounter, some hundreds per family.
#pragma once

#include <array>
#include <optional>

#include "contact/clearance/pair_extents.h"
#include "motion/changes.h"
#include "shape/bodies.h"

namespace foresee {

/// How many times of a bent path are sampled for a guess.
inline constexpr int sampled_times = 32;
/// A smaller distance counts as touching, relative to the lengths of the pair. Proofs need less at any width.
inline constexpr double touching_share = 0x1p-44;

/// One other object, relative to an object that is about to change its motion.
template <int D>
struct Encounter {
  Vec<D> x, v, a;
  Vec<D> ex, ev;              ///< errors; a is exact
  GrowingExtents<D> extents;  ///< at the start
  double begin, end;          ///< both exist in the horizon, in seconds after the start, rounded outward
  double inflation = 0;       ///< upper bound of the change of the set's support by its rotation …
  double rotation_chord = 0;  ///< … whose chord this is, relative to the length that rotates
  /// The sum, if it rotates with the motions of the range: in the pose of the middle.
  PieceSum* turning = nullptr;
  /// Lower bound of squared distance - squared reach, of discs and balls that nearly touch.
  double square_gap = 0;
  bool nearly_touches = false;  ///< apart at the start by exact contact, but doubles may not decide it

  bool bends() const { return (a != 0).any(); }
};

/// The extents at `time`, as of the distance of the two tables.
template <int D>
GrowingExtents<D> extents_of_both(const PairRule& rule, const double* row_a, const double* row_b,
                                  double time);

/// `base`: the motion that is changed, as of the start of the manoeuvre. Numbers that overflow are not finite.
template <int D>
Encounter<D> encounter_of(const OwnMotion& base, const Horizon& horizon, const Bodies& others,
                          const double* row, const GrowingExtents<D>& extents);

/// The rotations of a range of turns.
struct RangeOfTurns {
  std::array<SineCosine<double>, 2> ends;
  SineCosine<double> middle;
  double chord;  ///< upper bound of the chord from the middle to an end, relative to the radius
};
RangeOfTurns range_of_turns(double p, double q);

/// The changed motions of a range, and estimates of three of them.
template <int D>
struct TrajectoryFamily {
  MotionSet<D> all;
  TrajectoryEstimate<D> middle, first, last;
  Vec<D> upper[3], lower[3];   ///< of positions, velocities and accelerations on each axis
  double turned[3]{};          ///< how far these are from the chord of the first and last; 0: a segment
  bool is_from_start = false;  ///< seen_from_start(): only the other object's position differs
  bool bends;                  ///< any of them is accelerated
  bool one_interval;           ///< if no path is bent, the changes that touch are one interval
  double from = 0, to = 0;     ///< the range
  /// Once known. `first` and `last` are within the pads of `all` then.
  mutable std::optional<RangeOfTurns> rotations = {};

  /// Requires: a range of turns; one thread. Only outlines that rotate need it.
  const RangeOfTurns& known_turns() const {
    if (!rotations) rotations = range_of_turns(from, to);
    return *rotations;
  }
};

template <int D>
TrajectoryFamily<D> trajectory_family(const Changes& changes, double p, double q);

/// Computes `upper` and `lower` from `all`.
template <int D>
void find_bounds(TrajectoryFamily<D>& family);

/// The other object relative to one estimate.
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
