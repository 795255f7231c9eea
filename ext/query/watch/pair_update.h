// Incremental update of the pairs of one watch (incremental view maintenance): writes the difference between its stored
// pairs and the current pairs as rows and in its log.
//
//   PairUpdate update(tables, before, storage, {interrupt});           // before COMMIT, or after CREATE
//   if (const auto after = update.run()) keep(*after);
//
// The watch stores all pairs whose first contact starts in [clock, known_to]. Pairs beyond the horizon wait:
// they are stored, but not shown.
//
//   changed objects   old pairs come from range reads, new pairs from a search (pair_search.h)
//   the clock         a due row is shown, gets its next contact, or is erased; before the horizon passes
//                     known_to, a look-ahead join finds the contacts that start beyond it, and those that end
//                     before the next look-ahead; it reaches further if few waiting pairs are erased before they
//                     are shown
//   recomputation     if the changes are unknown, or the clock goes back or beyond the known ends: the join of all
//                     objects is compared with all rows
//
// Only differences are written. Guarantee: afterwards the reported rows are those of predictive_join at the
// clock, with bit-identical times. Cost: about twenty microseconds per changed object and per row that
// differs, most of it in SQLite; one join per look-ahead. Memory: the changed objects and their pairs, or
// all pairs if it recomputes.
//
// In memory (memory_watch.h) an update is cheaper than a join of all objects only while few of them change: of 5,000
// 1 to 2 % per tick (bench/core_watch.cpp). Beyond that, fill a new scene and join it.
#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "query/watch/pair_search.h"
#include "query/watch/watch_state.h"

namespace foresee {

inline double next_above(double x) {
  return std::nextafter(x, std::numeric_limits<double>::infinity());
}

/// Up to this time the ends of the stored contacts are known: such a pair is due at its end or before. Later ends are
/// unknown until the next look-ahead. At most known_to.
double ends_known_to(const WatchState& state);

class PairUpdate {
 public:
  enum class Log : std::uint8_t { changes, nothing };

  /// Reads the present stamps: they are those of the state that run() returns. Requires: the contents of the tables
  /// are those of their stamps, nothing waits to be written. Throws Error without a table a.
  PairUpdate(JoinedTables tables, const WatchState& before, WatchStorage& storage,
             const JoinResources& resources);

  /// Writes the changes of the tables since `before` as rows. Returns the state after them, for the caller to
  /// keep; nothing if the watch is up to date. `log`: `nothing` for a new watch, which no reader knows yet.
  /// Throws what tables and rows throw. Requires: it is called once.
  std::optional<WatchState> run(Log log = Log::changes);

  /// Whether rows are written already: an error after that leaves changes that the log does not have.
  bool has_written() const { return has_written_; }

 private:
  // the clock (pair_update_clock.cpp)
  /// Sets the new clock, and the end of the horizon: by an 'advance', else by the newest reference times.
  void move_clock();
  void follow_reports();
  void follow_early_reports();
  struct Reporting {
    const ChangedObjects* changed;
    TableSource* table;
  };
  std::vector<Reporting> reporting_tables() const;
  std::vector<double> report_times(bool of_all = false) const;
  /// Whether all pairs are joined again: after 'rebuild', for unknown or too many changes, or if the clock has left the
  /// time that the rows cover.
  bool must_recompute() const;
  /// Whether the clock passes the known starts now, or the known ends soon. A look-ahead in time is cheaper than a
  /// recomputation.
  bool must_look_ahead() const;
  /// Sets known_to and the length of the queries, for a search beyond the horizon; starts to count its pairs.
  void extend_look_ahead();
  /// Doubles or halves the look-ahead, by the share of its pairs that were erased while they waited.
  void adapt_look_ahead();

  /// Compares the join of all objects with all rows.
  void recompute();
  /// Compares only the pairs that can differ: of changed objects, due ones, and those of a look-ahead.
  void apply_changes();
  void query_due_pairs();
  /// Searches the pairs of the changed objects.
  void search_changed();
  void look_ahead(double from);

  /// Adds a contact that was found as a new pair: reported, or waiting.
  void add_found(const JoinRow& found);
  /// Decides finally which new pairs are reported, and sets `due` of those that wait.
  void finish_new_pairs();
  /// `all_are_known`: old_ has every stored row.
  void write_differences(bool all_are_known);
  /// Visits each old or new pair, whether the two differ or not, in order of the ids. Null if it does not exist before
  /// or after.
  void for_each_pair(const std::function<void(const WatchedPair*, const WatchedPair*)>& use);
  /// Whether writing all rows is cheaper than updating those that differ.
  bool differ_mostly();
  /// Writes the row of a pair if it differs, and logs what is reported. Null: it is new, or gone.
  void write_if_different(const WatchedPair* before, const WatchedPair* after);
  /// Writes, erases or leaves the stored row of a pair. When every row is replaced, an unchanged one is written too.
  void write_row_of(const PairChange& change, const WatchedPair* before);
  /// For adapt_look_ahead().
  void count_waiting(const WatchedPair* before, const WatchedPair* after);

  Horizon queried_horizon() const { return {clock_, queried_length_}; }
  WatchClock watch_clock() const { return {clock_, state_.tolerance, horizon_end_}; }

  JoinedTables tables_;
  WatchStorage& storage_;
  JoinResources resources_;
  WatchState before_, state_;
  ChangedSides changed_;
  double clock_ = 0;           ///< new value
  double horizon_end_ = 0;     ///< clock + horizon, rounded: a time
  double queried_length_ = 0;  ///< of the contact queries, from the clock
  std::vector<WatchedPair> old_, new_;
  bool logs_ = true;
  bool has_written_ = false;
  bool replaces_ = false;  ///< every row is written, into an empty table, and every key
};

}  // namespace foresee
