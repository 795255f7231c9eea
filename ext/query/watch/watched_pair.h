// What does a watch know of a pair, and what does it tell when that changes?
//
//   const PairChange change = change_between(&before, &after, {.clock = 1260, .tolerance = 0});
//   if (change.op) log(change.op, change.row.t);       // '+' new, '~' its time moved, '-' gone
//   if (change.writes) write(change.row);              // else the row that is stored stays true
//
// A pair's time is the begin of its first contact that ends at or after the clock. A time at or before the
// clock means that they touch, whichever it is: shown is the later of the two. So time that passes changes no
// row. Of a pair that begins beyond the horizon the watch knows, but tells nothing: it waits.
//
// `due` is when the clock makes the row a question: of what waits the begin of its contact, else some moment
// not after the end of it, or never where it lasts beyond all that the watch has looked at. Too early costs a
// question, too late would be a wrong answer; a later end is therefore written only where the row is due.
#pragma once

#include <cstdint>
#include <limits>

namespace foresee {

/// A look further finds the end.
inline constexpr double never_due = std::numeric_limits<double>::infinity();

struct WatchedPair {
  std::int64_t a = 0, b = 0;
  double t = 0;
  double due = 0;
  double told = 0;    ///< the time that readers know, within the tolerance
  bool held = false;  ///< else it waits
};

struct WatchClock {
  double clock = 0;
  double tolerance = 0;

  double shown(double t) const { return t > clock ? t : clock; }
};

struct PairChange {
  char op = 0;          ///< '+', '~', '-'; 0: nothing to tell
  bool writes = false;  ///< `row` takes the place of the stored one
  bool erases = false;  ///< the stored row goes
  WatchedPair row = {};
};

/// The change from `before` to `after`, each null where the watch does not know the pair; both as of this
/// clock. At least one is not null.
PairChange change_between(const WatchedPair* before, const WatchedPair* after, const WatchClock& clock);

}  // namespace foresee
