// State of a predictive watch: its declaration and how far it has been computed. A database keeps it in
// <name>_meta, with the current names of the tables; the text of CREATE may have older ones.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "query/watch/watched_pair.h"

namespace foresee {

struct WatchDeclaration {
  std::string tbl = {};
  std::optional<std::string> other = {};  ///< nothing: pairs within tbl
  double horizon = 0;
  double within = 0;
  std::optional<double> within_z = {};
  bool manual = false;  ///< only 'advance' moves the clock
  double tolerance = 0;
  std::int64_t keep = 1000000;
  std::optional<double> ahead = {};  ///< a report later than clock + ahead does not move the clock
};

struct WatchState : WatchDeclaration {
  std::int64_t format = 0;                     ///< as read; writing uses the newest format
  std::optional<double> clock = {};            ///< nothing: there has been no object yet
  std::optional<double> requested_clock = {};  ///< time of an 'advance' in this transaction
  bool must_rebuild = false;                   ///< 'rebuild': stored pairs are to be computed again
  double known_to = 0;                         ///< the rows have all pairs that start up to this time
  double last_advance = 0;                     ///< last advance of the clock
  double look_ahead_length = 0;                ///< how far beyond the horizon the last look-ahead went
  std::int64_t found_waiting = 0;    ///< pairs beyond the horizon that it, or a change since, has found
  std::int64_t dropped_waiting = 0;  ///< how many of those were removed before they were reported
  std::int64_t seq = 0;              ///< number of the last change
  std::int64_t early_reports = 0;    ///< number of reports later than `ahead` allows
  std::int64_t early_score = 0;      ///< by how much they are more than twice the others, since it was 0
  std::optional<std::int64_t> created = {};  ///< a random number of its CREATE; nothing up to version 0.2.0
  std::optional<std::int64_t> stamp = {}, other_stamp = {};  ///< contents for which the rows were computed

  double now() const { return requested_clock ? *requested_clock : clock.value_or(0); }
};

// What a watch keeps: the rows of its pairs, and the log of what was reported.
//
//   const WatchedPair pair{.a = 1, .b = 2, .t = 95, .due = 105, .reported_t = 95, .state = PairState::reported};
//   storage.write_pair(nullptr, pair, false);
//   storage.write_keys();
//   storage.append({.seq = 7, .op = '+', .a = 1, .b = 2, .t = 95, .now = 0});
//
// An update (pair_update.h) reads and writes through this interface. Shadow tables of a database implement
// it (sqlite/watch/watch_rows.h), and so does memory (memory_watch.h).

struct LoggedChange {
  std::int64_t seq;
  char op;  ///< '+', '~' or '-'
  std::int64_t a, b;
  double t;  ///< not kept for a removed pair
  double now;
};

class WatchStorage {
 public:
  virtual ~WatchStorage() = default;

  // --- pairs

  /// In order of (a, b).
  virtual std::vector<WatchedPair> pairs() = 0;
  /// Those with one of these ids on its side, in any order. Requires: ids in rising order.
  virtual std::vector<WatchedPair> stored_pairs_of(std::span<const std::int64_t> a,
                                                   std::span<const std::int64_t> b) = 0;
  /// Those of this state whose `due` is at most `until`, in any order.
  virtual std::vector<WatchedPair> due_pairs(PairState state, double until) = 0;
  virtual std::optional<WatchedPair> pair(std::int64_t a, std::int64_t b) = 0;

  /// `before`: the stored row, null for a new pair. `with_reported_t`: otherwise it equals t and is not stored.
  virtual void write_pair(const WatchedPair* before, const WatchedPair& pair, bool with_reported_t) = 0;
  virtual void erase_pair(const WatchedPair& pair) = 0;
  virtual void erase_all_pairs() = 0;
  /// Call it after the last write: keys by b and by `due` may wait until then.
  virtual void write_keys() {}

  // --- log
  virtual void append(const LoggedChange& change) = 0;
  /// Removes the changes up to this number.
  virtual void trim(std::int64_t up_to) = 0;
};

}  // namespace foresee
