// One manoeuvre that is queried: the legs that it makes of the object, and all objects that it can touch.
//
//   const ManoeuvreCase turn = manoeuvre_case(question, own, {Manoeuvre::turn, -180, 180}, interrupt);
//   changed_record(turn, 15)                                 // the numbers to store for a turn by 15 degrees
//
// All changed motions together are bounds of positions, velocities and accelerations, like an entry of the
// tree. So one query of the tree per table finds the near objects.
//
// Guarantee: every object that any change can touch during the horizon, once, and possibly others; of a plan, every leg
// that any change can touch. Objects whose kinds may not meet (shape/kinds.h) are left out. A scene and a tree give the
// same. Cost: the nodes that meet the moving box around all changes. A scene is read completely, and must not have
// outlines.
#pragma once

#include <memory>

#include "base/error.h"
#include "query/avoid/own_state.h"

namespace foresee {

/// The objects of one table near the object that changes: a row each, or a row for each leg near it.
struct NearObjects {
  std::shared_ptr<const Scene> scene;
  /// The rows that each leg of the changed object can touch; empty for one leg: all.
  std::vector<std::vector<std::uint32_t>> of_leg = {};
};

struct ManoeuvreCase {
  const AvoidQuestion& question;
  const OwnState& own;
  QueriedChanges queried;
  ChangedLegs changed;
  bool rotates_outline;                        ///< the own outline rotates with the course
  std::vector<NearObjects> near_objects = {};  ///< of each table

  const Changes& first_leg() const { return *changed.legs[0]; }
  /// The records of changed.motions_at_start().
  OwnState::Records records_at_start() const { return own.records_of(changed.motions_at_start()); }
};

/// `question` and `own` must outlive the case.
ManoeuvreCase manoeuvre_case(const AvoidQuestion& question, const OwnState& own,
                             const QueriedChanges& queried, Interrupt& interrupt);

// What is stored for one change (changed_plan.cpp):

/// The plan to store for k: of an object with a plan, where the manoeuvre gives several legs, or where no columns
/// store the changed motion. Otherwise nothing, and nothing for a k that does not change an object without a plan. A
/// plan of knots remains one if knots have just these legs.
std::optional<Plan> changed_plan(const ManoeuvreCase& manoeuvre, double k);

/// The numbers to store for k; of several legs the first, and the last `until`.
std::vector<double> changed_record(const ManoeuvreCase& manoeuvre, double k);

}  // namespace foresee
