#include "query/watch/watched_pair.h"

#include <cmath>

namespace foresee {
namespace {

/// Requires: both are held. The stored row stays if it states the same.
PairChange compare_held(const WatchedPair& before, const WatchedPair& after, const WatchClock& clock) {
  PairChange change{.row = after};
  const double before_t = clock.shown(before.told), now = clock.shown(after.t);
  const bool moved = before_t != now && !(std::abs(before_t - now) <= clock.tolerance);
  if (moved) change.op = '~';
  change.row.told = moved ? after.t : before.told;
  const bool same_time = clock.shown(before.t) == now;
  if (before.due > clock.clock && before.due < after.due) change.row.due = before.due;
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
    change.op = '+';
  else if (before && before->held)
    change.op = '-';
  change.writes =
      !before || before->held || after->held || before->t != after->t || before->due != after->due;
  return change;
}

}  // namespace foresee
