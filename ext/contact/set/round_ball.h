// Discs and balls around the origin of the relative motion.
#pragma once

#include "contact/set/contact_set.h"

namespace foresee {

/// |x| <= radius over the first `axes` axes, as the one piece of a set; also between `along_z`, if given.
void add_ball(ContactSet& set, int axes, const Size& radius, const Faces* along_z = nullptr);

}  // namespace foresee
