// State of a pair that a watch keeps, and the change that is logged when that state is computed again.
//
//   const PairChange change = change_between(&before, &after, {.clock = 1260, .tolerance = 0});
//   if (change.op) log(change.op, change.row.t);       // '+' new, '~' its time moved, '-' gone
//   if (change.writes) write(change.row);              // else the row that is stored stays true
//
// A pair's time is the start of its first contact that ends at or after the clock. A time at or before the
// clock means that the pair touches, whichever time it is: shown is the later of the two. So the passage of
// time changes no row. A pair whose contact starts beyond the horizon is not reported yet: it waits.
//
// `due` says when the pair has to be computed again. For a pair that waits it is a time not after the start of the
// contact: the pair is computed once the horizon reaches it. Else it is a time not after the end of the contact, for
// the clock, or never if the contact lasts beyond all that the watch has computed. A `due` that is too early costs
// one computation; one that is too late would give a wrong result. So a row keeps its `due` while that is not too
// late: reports move the times of most pairs a little, and then mostly no `due` is written.
#pragma once

#include <cstdint>
#include <limits>

namespace foresee {

/// The end of the contact lies beyond all that was computed: only a longer horizon finds it.
inline constexpr double never_due = std::numeric_limits<double>::infinity();

/// A watch shows its reported pairs. A waiting one starts beyond the horizon: it is stored, but not shown.
enum class PairState : std::uint8_t { waiting, reported };

struct WatchedPair {
  std::int64_t a = 0, b = 0;
  double t = 0;
  double due = 0;
  double reported_t = 0;  ///< of a reported pair: the time that was logged, within the tolerance of `t`
  PairState state = PairState::waiting;

  bool is_reported() const { return state == PairState::reported; }
};

struct WatchClock {
  double clock = 0;
  double tolerance = 0;
  double horizon_end = 0;

  double shown(double t) const { return t > clock ? t : clock; }
};

struct PairChange {
  char op = 0;          ///< '+', '~', '-'; 0: nothing to report
  bool writes = false;  ///< `row` replaces the stored one
  bool erases = false;  ///< the stored row is deleted
  WatchedPair row = {};
};

/// The change from `before` to `after`, both as of this clock; null where the watch does not store the pair.
/// At least one is not null.
PairChange change_between(const WatchedPair* before, const WatchedPair* after, const WatchClock& clock);

}  // namespace foresee
