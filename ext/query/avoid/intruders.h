// Stage one of avoidance: all objects that the object can touch with any change of the range.
//
// All changed motions together are bounds of positions, velocities and accelerations, like an entry of the
// tree. So one query of the tree finds the intruders.
//
// Guarantee: every object that any change can touch during the horizon, once, and possibly others. Of a plan every
// leg. All of them may meet the own object (shape/kinds.h). A scene and a tree give the same. Cost: the nodes that
// meet the moving box around all changes. A scene is read completely, and must not have outlines.
#pragma once

#include <memory>

#include "base/error.h"
#include "contact/contact.h"
#include "query/avoid/own_state.h"

namespace foresee {

/// The objects of one table near the object that changes: a row each, or a row for each leg near it.
struct NearObjects {
  std::shared_ptr<const Scene> scene;
  /// The rows that each leg of the changed object can touch; empty for one leg: all.
  std::vector<std::vector<std::uint32_t>> of_leg = {};
};

/// `itself`: the object of this id is left out. `reach`: that of the contact.
NearObjects intruders(const AvoidQuestion& question, const ChangedLegs& changed,
                      const QueriedChanges& queried, const SearchTarget& others,
                      std::optional<std::int64_t> itself, const Contact::Reach& reach, Interrupt& interrupt);

}  // namespace foresee
