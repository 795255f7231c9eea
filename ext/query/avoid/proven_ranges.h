// The changes of one manoeuvre that are proven clear of all near objects.
//
//   const std::vector<KRange> clear = proven_ranges(manoeuvre, exact, interrupt);
//
// Every near object, and every leg of its plan, beside every leg of the changed object is one encounter with a
// certificate. ClearRanges bisects the changes for all of them together. Exact contact says which of them touch before
// the change. Cost: that of ClearRanges, and some hundred ns per encounter.
#pragma once

#include <vector>

#include "query/avoid/clear_ranges.h"
#include "query/avoid/exact_avoidance.h"
#include "query/avoid/intruders.h"

namespace foresee {

/// One manoeuvre that is queried, and the objects that it may touch.
struct ManoeuvreCase {
  const AvoidQuestion& question;
  const OwnState& own;
  QueriedChanges queried;
  ChangedLegs changed;
  bool turns;                          ///< the own outline rotates with the course
  std::vector<NearObjects> near = {};  ///< of each table

  const Changes& first_leg() const { return *changed.legs[0]; }
  /// What this touches at first touches already: the object at the change; for a delay, at its stored start.
  OwnState::Records records_at_first() const {
    OwnState::Records records;
    for (const OwnMotion& motion : changed.at_stored_start()) records.push_back(own.record_of(motion));
    for (std::size_t i = changed.legs.size() - changed.ends; i < changed.legs.size(); ++i)
      records.push_back(own.record_of(changed.legs[i]->unchanged()));
    return records;
  }
};

/// Requires: lo < hi, and the motion at the change is finite.
std::vector<KRange> proven_ranges(const ManoeuvreCase& manoeuvre, ExactAvoidance& exact,
                                  Interrupt& interrupt);

}  // namespace foresee
