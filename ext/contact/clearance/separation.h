// Separating-plane certificate that an object keeps clear of another for every change of a range.
//
//   const TrajectoryFamily<2> turns = trajectory_family<2>(base, change, 10, 20);
//   // for every double of [10, 20]: a proof
//   certify_clearance(encounter, turns, evaluations) == ClearanceVerdict::clear
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
  clear,    ///< proven
  blocked,  ///< every change seems to touch
  open      ///< neither
};

/// Requires: encounter.begin <= encounter.end. `evaluations` grows by one, and by one per interval of a bent
/// path.
template <int D>
ClearanceVerdict certify_clearance(const Encounter<D>& encounter, const TrajectoryFamily<D>& family,
                                   std::uint64_t& evaluations);

}  // namespace foresee
