// Incremental update of one watch: writes the difference between its stored pairs and the current pairs as
// rows and in its log.
//
//   Settlement(connection, rows).settle();               // before COMMIT, or after CREATE
//
// Known are all pairs whose first contact starts in [clock, known_to]; those beyond the horizon wait.
//
//   changed objects   their old pairs are range reads, their new ones searched for (pair_search.h)
//   the clock         rows that are due are shown, queried for their next contact, or taken out; when the
//                     horizon passes known_to, a join looks ahead for what starts or ends beyond it, the
//                     further the fewer of the pairs that wait are dropped again unseen
//   recomputation     where the changes are unknown, or the clock goes back or far ahead: the join of all
//                     against all rows
//
// Only what differs is written. Guarantee: afterwards the rows that are held are those of predictive_join at
// the clock, their times bit for bit. Cost: some twenty microseconds per changed object, and as much for each
// row that differs, of which SQLite has most; a join where it looks ahead. Memory: the changed objects and
// their pairs, or all pairs where it recomputes.
#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "query/watch/watched_pair.h"
#include "sqlite/watch/pair_search.h"
#include "storage/watch/watch_rows.h"

namespace foresee {

inline double next_above(double x) {
  return std::nextafter(x, std::numeric_limits<double>::infinity());
}

class Settlement {
 public:
  enum class Log : std::uint8_t { changes, nothing };

  /// Writes out what the watch's tables hold in memory. Throws StoreError or Error where watch or tables
  /// cannot be read.
  Settlement(Connection& connection, WatchRows& rows);

  /// `nothing`: the rows of a new watch, which nobody has read yet.
  void settle(Log log = Log::changes);

  /// Whether rows are written already: an error after that leaves changes that nobody is told of.
  bool has_written() const { return has_written_; }

 private:
  void follow_reports();
  std::vector<double> reported_times() const;
  bool any_object() const;
  void move_clock();
  bool must_compute_anew() const;
  void extend_look_ahead();
  void adapt_look_ahead();

  void compute_anew();
  void follow_changes();
  void read_old_pairs();
  void query_due_pairs();
  void search_changed();
  void look_ahead(double from);

  /// What contact found becomes rows: held, or waiting.
  void take(std::span<const JoinRow> found);
  void decide_ties();
  /// `all_are_known`: old_ is every row that is stored.
  void write_differences(bool all_are_known);
  /// In order of the ids; null where the pair is not known before or after.
  void for_each_difference(const std::function<void(const WatchedPair*, const WatchedPair*)>& use);
  /// So much that writing all rows is cheaper than finding those that differ.
  bool differ_mostly();
  void write_difference(const WatchedPair* before, const WatchedPair* after);

  Horizon queried_horizon() const { return {clock_, reach_}; }
  JoinQuestion question(const Horizon& horizon) const;

  Connection& connection_;
  WatchRows& rows_;
  WatchState before_, state_;
  WatchedTables tables_;
  ChangedObjects changed_a_, changed_b_;
  double clock_ = 0;        ///< from now on
  double horizon_end_ = 0;  ///< clock + horizon, rounded
  double reach_ = 0;        ///< how far beyond the clock contact is asked
  std::vector<WatchedPair> old_, new_;
  bool logs_ = true, has_written_ = false;
  bool replaces_ = false;  ///< every row is written, into a table without any
};

}  // namespace foresee
