// Does an object keep clear of another whichever change of a range it makes? Proven, or not; and if not,
// whether every change of the range touches, as far as doubles tell.
//
//   const TrajectoryFamily<2> turns = trajectory_family<2>(base, change, 10, 20);
//   // for every double of [10, 20]: a proof
//   certify_clearance(encounter, turns, evaluations) == ClearanceVerdict::clear
//
// The proof is a plane. Along its normal n the other is at n (x + v tau + a tau^2 / 2), and no changed motion
// reaches farther than the most of the range's places, velocities and accelerations (motion_set.h): the
// difference, less what extents take, is a polynomial of degree 2 whose least value during the moments both
// exist is above 0, with every rounding counted. That is the certificate for all shapes and laws. Which n is
// only a guess: that of the nearest approach of the middle, the first or the last change. Where paths are
// bent, the time is cut until each part has a plane. As a range shrinks its certificate becomes that of a
// single motion, so what is apart is proven in the end.
//
// Between motions that are not bent, whoever changes speed, height or start touches for the changes of one
// interval; so a range whose ends touch does. Cost: some 50 ns; bent paths as much for each part of the time
// that needs a plane of its own, 200 at most.
#pragma once

#include "contact/clearance/trajectory_family.h"

namespace foresee {

enum class ClearanceVerdict : std::uint8_t {
  clear,    ///< proven
  blocked,  ///< every change seems to touch
  open      ///< neither
};

/// Requires: met.begin <= met.end. `evaluations` grows by what it has cost: one, and one for each part of a bent
/// path.
template <int D>
ClearanceVerdict certify_clearance(const Encounter<D>& encounter, const TrajectoryFamily<D>& family,
                                   std::uint64_t& evaluations);

}  // namespace foresee
