// The object that changes: what is stored of it, and its motion at the change.
//
//   const OwnState own(question);
//   own.record_of(own.base)                                    // what a change at once would store
//
// Everything that avoidance asks about the own motion starts from these numbers; sets of changed motions are Changes
// (motion/changes.h). Cost: a microsecond.
#pragma once

#include <vector>

#include "motion/manoeuvre.h"
#include "query/avoid/question.h"

namespace foresee {

struct OwnState {
  /// Requires: a record.
  explicit OwnState(const AvoidQuestion& question);

  /// The record with another motion.
  std::vector<double> record_of(const OwnMotion& motion) const;

  Layout layout;
  std::vector<double> record;
  OwnMotion stored;  ///< the motion of the record
  OwnMotion base;    ///< the same from the change on, at max(now, t)
};

}  // namespace foresee
