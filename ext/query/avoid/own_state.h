// The object that changes: what is stored of it, its motion at the start of a manoeuvre, and the legs of its plan.
//
//   const OwnState own(question);
//   own.record_of(own.base)                                    // the record of its motion from now on
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
  OwnMotion base;    ///< the motion from the start of a manoeuvre on, at max(now, t)
  /// Of its plan: those that do not end before now, nor start after the horizon; `until` cuts them.
  std::vector<OwnMotion> legs = {};
  std::size_t current_leg = 0;  ///< the one of `base`
  std::size_t legs_before = 0;  ///< how many legs of the plan are not in `legs`
};

/// The numbers of a record that are the motion of the object.
OwnMotion motion_in(const Layout& layout, const std::vector<double>& record);
std::vector<double> with_motion(const Layout& layout, std::vector<double> record, const OwnMotion& motion);

/// What a manoeuvre makes of the object.
struct ChangedLegs {
  /// In order of time from the start of the manoeuvre on; then those that end at it.
  std::vector<std::unique_ptr<Changes>> legs;
  std::size_t ending = 0;  ///< how many of the last ones end at the start of the manoeuvre
  /// All that follows is later by k: an object in contact at the start is not exempt.
  bool are_later = false;

  /// The unchanged motions whose first time is the start of the manoeuvre, and those that end at it: what they touch
  /// then, they touch already. Of a delay those at its stored start: several, if a leg has no duration.
  std::vector<OwnMotion> motions_at_start() const;
};

/// Requires: `queried` is of `question`.
ChangedLegs changed_legs(const AvoidQuestion& question, const OwnState& own, const QueriedChanges& queried);

}  // namespace foresee
