#include "query/watch/watched_pair.h"

#include <algorithm>
#include <cmath>

namespace foresee {
namespace {

/// The `due` of a pair that stays reported. A stored one that is not too late is kept: the row need not be written;
/// at the clock it was too early, and the pair has just been tested.
double due_of_reported(const WatchedPair& before, const WatchedPair& after, const WatchClock& clock) {
  const bool keeps = before.due > clock.clock && before.due <= after.due;
  return keeps ? before.due : after.due;
}

/// Requires: both are reported. The stored row stays if it states the same.
PairChange compare_reported(const WatchedPair& before, const WatchedPair& after, const WatchClock& clock) {
  PairChange change{.row = after};
  const double shown_before = clock.shown(before.reported_t), shown_after = clock.shown(after.t);
  const bool moved =
      shown_before != shown_after && !(std::abs(shown_before - shown_after) <= clock.tolerance);
  if (moved) change.op = '~';
  change.row.reported_t = moved ? after.t : before.reported_t;
  const bool same_time = clock.shown(before.t) == shown_after;
  change.row.due = due_of_reported(before, after, clock);
  change.writes = moved || !same_time || change.row.due != before.due;
  if (same_time && !moved) change.row.t = before.t;
  return change;
}

}  // namespace

PairChange change_between(const WatchedPair* before, const WatchedPair* after, const WatchClock& clock) {
  if (!after) return {.op = before->is_reported() ? '-' : '\0', .erases = true, .row = *before};
  const bool was_reported = before && before->is_reported();
  if (was_reported && after->is_reported()) return compare_reported(*before, *after, clock);
  PairChange change{.row = *after};
  change.row.reported_t = after->t;
  if (after->is_reported()) {
    change.op = '+';
  } else if (was_reported) {
    change.op = '-';
  }
  const bool goes_on_waiting = before && !was_reported && !after->is_reported();
  const bool keeps_stored_row = goes_on_waiting && before->due > clock.horizon_end && before->due <= after->t;
  change.writes = !keeps_stored_row;
  return change;
}

}  // namespace foresee
