// Separating-plane certificate that an object keeps clear of another for every change of a range.
//
//   const TrajectoryFamily<2> turns = trajectory_family<2>(*changes, 10, 20);
//   // for every double of [10, 20]: a proof
//   certify_clearance(encounter, turns).verdict == ClearanceVerdict::clear
//
// Along the normal n of the plane the other object is at n (x + v tau + a tau^2 / 2). The changed motions
// reach at most the support of the range's positions, velocities and accelerations (motion_set.h). The
// difference of the two, less the support of the extents, is a polynomial of degree 2 in time. The
// certificate is that its minimum while both exist is above 0, all rounding errors included. It is the same
// for all shapes and laws of motion.
//
// The normal is only a guess: that of the nearest approach of the middle, the first or the last change. On
// bent paths the time is split until each interval has a plane. As a range shrinks, its certificate becomes
// that of a single motion, so what is apart is proven in the end.
//
// If no path is bent, the changes of speed, climb or start that touch are one interval. Then a range whose
// ends touch is blocked. If no plane is found, the verdict says whether every change seems to touch.
// Cost: some 50 ns; on bent paths as much per interval of time that needs a plane of its own, at most 200.
#pragma once

#include "contact/clearance/trajectory_family.h"

namespace foresee {

enum class ClearanceVerdict : std::uint8_t {
  clear,     ///< proven
  blocked,   ///< every change seems to touch
  undecided  ///< neither
};

/// A verdict, and its cost: one evaluation, and one per interval of a bent path.
struct CountedVerdict {
  ClearanceVerdict verdict;
  std::uint64_t evaluations = 0;
};

/// Requires: encounter.begin <= encounter.end.
template <int D>
CountedVerdict certify_clearance(const Encounter<D>& encounter, const TrajectoryFamily<D>& family);

/// certify_clearance() with `undecided` for `blocked`: cheaper, as it does not look for contact.
template <int D>
CountedVerdict certify_only_clearance(const Encounter<D>& encounter, const TrajectoryFamily<D>& family);

// Certificate that an object separates from another one that it touches, on bent paths, for every change of a
// range (bent_separation.cpp).
//
//   // a proof for every change of the range
//   certify_bent_separation<2>(encounter, family).verdict == ClearanceVerdict::clear
//
// Two proofs join at an instant soon after the middle change of the range has left the other object. Until
// then the distance of the centres never decreases: its slope is a polynomial of degree 3 in time, and each
// coefficient is an interval over the range. From then on planes separate the two (separation_case.h). Boxes
// and cylinders are left per axis, and on the round axes together. On each of these the object is inside
// first, and then at an increasing distance. Cost: some microseconds.

/// Requires: the two touch at the start; no extents grow, and none is a sum of pieces.
template <int D>
CountedVerdict certify_bent_separation(const Encounter<D>& encounter, const TrajectoryFamily<D>& family);

// Certificate that an object separates from one that it touches when it changes its motion, for every change
// of a range (separation_increase.cpp). If no path is bent, the slope of the distance increases with time, so
// its sign at the start decides. On bent paths intervals bound the slope (certify_bent_separation() above,
// spread_of_changes.h).

/// Certifies a range of changes for two objects that touch at the start. A change is clear if the distance of
/// the centres never decreases while they touch, and they do not touch again. Convex sets
/// never touch again if no path is bent. If extents grow, the gap must not decrease. Bent paths of growing
/// extents or of pieces are blocked. Only intervals of bent paths are counted.
template <int D>
CountedVerdict certify_separation_increases(const Encounter<D>& encounter, const TrajectoryFamily<D>& family);

/// certify_separation_increases() for one of several pieces, or for a piece that rotates: whether it touches at the
/// start is not known. A change that never touches it is clear too. If doubles cannot decide whether it touches at
/// first, the two must move apart along every line that may separate them.
template <int D>
CountedVerdict certify_piece_separation_increases(const Encounter<D>& encounter,
                                                  const TrajectoryFamily<D>& family);

}  // namespace foresee
