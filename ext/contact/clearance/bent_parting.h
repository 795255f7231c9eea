// Does an object move away from another that it touches when it changes its motion, where paths are bent, and
// stay away, whichever change of a range it makes?
//
//   // a proof for every change of the
//   judge_bent_parting<2>(encounter, family, evaluations) == ClearanceVerdict::clear
//   range
//
// Two proofs that meet at a moment soon after the middle of the range has left: until then the distance of
// the centres never shrinks, as its slope is a polynomial of degree 3 in time, each coefficient an interval
// over the range; from then on planes stand between the two (separation_case.h). Of boxes and cylinders each
// axis, and the round ones together, must be left once and for all: inside first, and then ever farther.
// Cost: some microseconds.
#pragma once

#include "contact/clearance/separation.h"

namespace foresee {

/// Requires: the two touch at the change; nothing grows, and there are no pieces.
template <int D>
ClearanceVerdict judge_bent_parting(const Encounter<D>& encounter, const TrajectoryFamily<D>& family,
                                    std::uint64_t& evaluations);

}  // namespace foresee
