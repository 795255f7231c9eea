// How large are the two of a pair together? Sizes of a contact set: what the rows say, and what has grown
// since.
//
//   const Size radius = radius_of_both(set, setup, setup.within);  // r_a + r_b + within, and both growths
//
// A shape of size r at its t has r + growth (s - t) at s, exactly: a linear function of time for a pair too,
// whose two reference times may differ. Where no table declares a growth, sizes do not move and cost nothing
// more.
#pragma once

#include "contact/set/contact_set.h"
#include "contact/set/relative_motion.h"

namespace foresee {

/// What has grown along an axis until `now`, of what is round or upright: both places may be absent.
Length growth_of_both(const Setup& setup, int axis);
/// The radii of what is round; `limit` is how near counts as touching.
Size radius_of_both(ContactSet& set, const Setup& setup, double limit);
/// The half heights of what is upright.
Size height_of_both(ContactSet& set, const Setup& setup, double limit);
/// The half extents of boxes along an axis.
Size half_of_both(ContactSet& set, const Setup& setup, int axis);

}  // namespace foresee
