// The object that changes: what is stored of it, its motion at the change, and the legs of its plan.
//
//   const OwnState own(question);
//   own.record_of(own.base)                                    // what a change at once would store
//
// All changed motions start from these numbers; sets of them are Changes (motion/changes.h). Cost: a microsecond, and
// some ns per leg.
#pragma once

#include <cstddef>
#include <vector>

#include "motion/changes.h"
#include "query/avoid/question.h"

namespace foresee {

struct OwnState {
  using Records = std::vector<std::vector<double>>;

  /// Requires: a record.
  explicit OwnState(const AvoidQuestion& question);

  /// Whether it exists at some time of the horizon.
  bool is_there(const Horizon& horizon) const;
  /// The record with another motion.
  std::vector<double> record_of(const OwnMotion& motion) const;
  Records records_of(const std::vector<OwnMotion>& motions) const;

  /// Of `record`. Where the object has, or gets, several legs it has t and until, which the table need not have.
  Layout layout;
  std::vector<double> record;
  OwnMotion stored;  ///< the motion of the record; with a plan its first leg
  OwnMotion base;    ///< the motion from the change on, at max(now, t)
  /// Of its plan: those that do not end before now, nor start after the horizon; `until` cuts them.
  std::vector<OwnMotion> legs = {};
  std::size_t leg = 0;          ///< the one of `base`
  std::size_t legs_before = 0;  ///< how many legs of the plan are not in `legs`
};

/// The numbers of a record that are the motion of the object.
OwnMotion motion_in(const Layout& layout, const std::vector<double>& record);
std::vector<double> with_motion(const Layout& layout, std::vector<double> record, const OwnMotion& motion);

/// What a manoeuvre makes of the object.
struct ChangedLegs {
  /// In order of time from the change on; then those that end at the change.
  std::vector<std::unique_ptr<Changes>> legs;
  std::size_t ends = 0;  ///< how many of the last ones end at the change
  /// All that follows is later by k: an object in contact at the start is not exempt.
  bool are_later = false;

  /// The unchanged first leg; of a delay also legs that start at the same time, behind one of no duration.
  std::vector<OwnMotion> at_stored_start() const;
};

/// Requires: `queried` is of `question`.
ChangedLegs changed_legs(const AvoidQuestion& question, const OwnState& own, const QueriedChanges& queried);

}  // namespace foresee
