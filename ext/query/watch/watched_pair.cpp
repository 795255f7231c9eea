#include "query/watch/watched_pair.h"

#include <algorithm>
#include <cmath>

namespace foresee {
namespace {

// Of the time up to the end of a contact. The ends move with every report, and most by less than the rest; a smaller
// share has more pairs tested before they end.
constexpr double early_share = 0.9;

/// A `due` that is unlikely to be too late after the next report: a time not after `end`, and after the clock if that
/// is.
double early(double end, const WatchClock& clock) {
  if (!(end < never_due)) return end;
  const double due = clock.clock + early_share * (end - clock.clock);
  return due > clock.clock ? std::min(due, end) : end;
}

/// Requires: both are held. The stored row stays if it states the same.
PairChange compare_held(const WatchedPair& before, const WatchedPair& after, const WatchClock& clock) {
  PairChange change{.row = after};
  const double shown_before = clock.shown(before.told), shown_after = clock.shown(after.t);
  const bool moved =
      shown_before != shown_after && !(std::abs(shown_before - shown_after) <= clock.tolerance);
  if (moved) change.op = '~';
  change.row.told = moved ? after.t : before.told;
  const bool same_time = clock.shown(before.t) == shown_after;
  // A pair that was tested at its due time gets the end itself, or it would be tested again and again.
  const bool was_due = before.due <= clock.clock;
  change.row.due = was_due ? after.due : before.due <= after.due ? before.due : early(after.due, clock);
  change.writes = moved || !same_time || change.row.due != before.due;
  if (same_time && !moved) change.row.t = before.t;
  return change;
}

}  // namespace

PairChange change_between(const WatchedPair* before, const WatchedPair* after, const WatchClock& clock) {
  if (!after) return {.op = before->held ? '-' : '\0', .erases = true, .row = *before};
  if (before && before->held && after->held) return compare_held(*before, *after, clock);
  PairChange change{.row = *after};
  change.row.told = after->t;
  if (after->held)
    change.op = '+', change.row.due = early(after->due, clock);
  else if (before && before->held)
    change.op = '-';
  const bool keeps_stored_row =
      before && !before->held && !after->held && before->due > clock.horizon_end && before->due <= after->t;
  change.writes = !keeps_stored_row;
  return change;
}

}  // namespace foresee
