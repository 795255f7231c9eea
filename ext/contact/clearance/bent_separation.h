// Certificate that an object separates from another one that it touches, on bent paths, for every change of a
// range.
//
//   // a proof for every change of the range
//   certify_bent_separation<2>(encounter, family, evaluations) == ClearanceVerdict::clear
//
// Two proofs join at an instant soon after the middle change of the range has left the other object. Until
// then the distance of the centres never decreases: its slope is a polynomial of degree 3 in time, and each
// coefficient is an interval over the range. From then on planes separate the two (separation_case.h). Boxes
// and cylinders are left per axis, and on the round axes together. On each of these the object is inside
// first, and then at an increasing distance. Cost: some microseconds.
#pragma once

#include "contact/clearance/separation.h"

namespace foresee {

/// Requires: the two touch at the change; no extents grow, and none is a sum of pieces.
template <int D>
ClearanceVerdict certify_bent_separation(const Encounter<D>& encounter, const TrajectoryFamily<D>& family,
                                         std::uint64_t& evaluations);

}  // namespace foresee
