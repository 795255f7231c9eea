#include "query/watch/watched_pair.h"

#include <algorithm>
#include <cmath>

namespace foresee {
namespace {

// A pair is tested after this share of the time up to the end of its contact. The ends move with every report, and most
// by less than the rest; a smaller share has more pairs tested before they end.
constexpr double tested_share = 0.9;

/// A `due` that is unlikely to be too late after the next report: a time not after `end`, and after the clock if `end`
/// is.
double due_with_margin(double end, const WatchClock& clock) {
  if (!(end < never_due)) return end;
  const double due = clock.clock + tested_share * (end - clock.clock);
  return due > clock.clock ? std::min(due, end) : end;
}

/// The `due` of a pair that stays reported.
double due_of_reported(const WatchedPair& before, const WatchedPair& after, const WatchClock& clock) {
  // It was due, and has just been tested. It gets the end itself: with a margin it would be tested again and again.
  if (before.due <= clock.clock) return after.due;
  // The stored time is not too late, so it stays, and the row need not be written.
  if (before.due <= after.due) return before.due;
  // The contact now ends before the stored time.
  return due_with_margin(after.due, clock);
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
    change.row.due = due_with_margin(after->due, clock);
  } else if (was_reported) {
    change.op = '-';
  }
  const bool goes_on_waiting = before && !was_reported && !after->is_reported();
  const bool keeps_stored_row = goes_on_waiting && before->due > clock.horizon_end && before->due <= after->t;
  change.writes = !keeps_stored_row;
  return change;
}

}  // namespace foresee
