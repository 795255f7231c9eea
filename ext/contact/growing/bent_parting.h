// Does an object move away from another that it touches when it changes its motion, where paths are bent, and
// stay away, whichever change of a range it makes?
//
//   judge_bent_parting<2>(met, ways, looks) == Judgement::clear       // a proof for every change of the
//   range
//
// Two proofs that meet at a moment soon after the middle of the range has left: until then the distance of
// the centres never shrinks, as its slope is a polynomial of degree 3 in time, each coefficient an interval
// over the range; from then on planes stand between the two (separation_case.h). Of boxes and cylinders each
// axis, and the round ones together, must be left once and for all: inside first, and then ever farther.
// Cost: some microseconds.
#pragma once

#include "contact/growing/separation.h"

namespace foresee::contact {

/// Requires: the two touch at the change; nothing grows, and there are no pieces.
template <int D>
Judgement judge_bent_parting(const Encounter<D>& met, const ChangedWays<D>& ways, std::uint64_t& looks);

}  // namespace foresee::contact
