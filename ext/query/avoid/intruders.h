// Stage one of avoidance: whom can the object touch, whichever change it makes? All changed motions together
// are what an entry of the tree is, ranges of places, velocities and accelerations, so the tree is asked with
// them as it is about one object.
//
// Guarantee: everybody whom any change can touch during the horizon, once, and others: from a scene the same
// as from a tree. Cost: the nodes that meet the moving box around all changes; a scene is looked at whole,
// and must not be of outlines.
#pragma once

#include <memory>

#include "base/error.h"
#include "contact/contact.h"
#include "motion/motion_set.h"
#include "query/avoid/question.h"

namespace foresee {

/// `itself`: of whom an object of this id is left out. `reach`: contact's.
std::shared_ptr<const Scene> intruders(const AvoidQuestion& question, const OwnMotion& base,
                                       const Change& change, const QueriedChanges& queried,
                                       const SearchTarget& others, std::optional<std::int64_t> itself,
                                       const Contact::Reach& reach, Interrupt& interrupt);

}  // namespace foresee
