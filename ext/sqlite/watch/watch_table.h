// One watch in this connection: SQLite's handle (sqlite3_vtab), its cursor, its commands.
#pragma once

#include <memory>
#include <string>

#include "query/join/join.h"
#include "query/watch/pair_search.h"
#include "sqlite/watch/watches.h"

namespace foresee {

// Column numbers in SQL.
enum WatchColumn {
  watch_a,
  watch_b,
  watch_t,
  watch_t_end,
  watch_dt,
  watch_dt_end,
  watch_t_cpa,
  watch_dt_cpa,
  watch_d_cpa,
  watch_now,
  watch_command,
  watch_pair
};

struct WatchTable : sqlite3_vtab {
  WatchTable(std::shared_ptr<Connection> connection, const QualifiedName& name)
      : sqlite3_vtab{}, connection(std::move(connection)), name(name) {}
  ~WatchTable() {
    connection->finalize();
    sqlite3_free(zErrMsg);
  }
  WatchTable(const WatchTable&) = delete;
  WatchTable& operator=(const WatchTable&) = delete;

  Watches& watches() const { return watches_of(*connection); }
  /// Throws StoreError for a watch whose tables are damaged or missing.
  std::shared_ptr<WatchRows> rows() const { return watches().rows(name); }

  std::shared_ptr<Connection> connection;
  QualifiedName name;
  /// Its names before in this transaction: a rollback to a savepoint may restore one.
  std::vector<std::string> old_names = {};
  double likely_pairs = 1000;  ///< as many as were read last, for the planner
};

/// Query plan of a watch, as xBestIndex chooses it: bits for the given ids and for the columns read.
struct WatchPlan {
  enum Bits : int { by_a = 1, by_b = 2, times = 4, approach = 8 };
};

/// A pair with the time that readers see: its contact's start, clipped to the clock.
struct ShownPair {
  std::int64_t a, b;
  double t;

  friend auto operator<=>(const ShownPair&, const ShownPair&) = default;
};

/// Cursor over the pairs as of the start of the statement; later writes do not change them.
class WatchCursor : public sqlite3_vtab_cursor {
 public:
  explicit WatchCursor(WatchTable& table) : sqlite3_vtab_cursor{}, table_(table) {}

  /// `plan`: bits of WatchPlan. `arguments`: the values of a and b, each only if its bit is set.
  void filter(int plan, sqlite3_value** arguments);
  void next();
  bool at_end() const { return rows_.empty(); }
  void column(sqlite3_context* context, int column) const;

 private:
  std::vector<ShownPair> kept_pairs(WatchRows& rows, const ChangedSides& changed) const;
  bool read_changed(WatchRows& rows, const WatchState& state, const OpenTables& tables);
  void give(std::span<const ShownPair> pairs, const WatchState& state, const OpenTables& tables);
  void join_now(const WatchState& state, const OpenTables& tables);

  WatchTable& table_;
  int plan_ = 0;
  std::optional<std::int64_t> only_a_, only_b_;
  double now_ = 0;
  std::vector<JoinRow> stored_;
  std::unique_ptr<Join> join_;
  std::span<const JoinRow> rows_;  ///< from the current one on
};

/// Runs 'advance', 'rebuild' or 'integrity-check'. Throws Error for any other command.
void run_watch_command(WatchTable& table, sqlite3_value* command, sqlite3_value* now);

/// One sentence about the first fault that the integrity check of the watch finds; "" if it is intact.
std::string watch_fault(WatchTable& table);

/// Whether the rows match the tables as this connection sees them, at the time of the watch's clock.
bool is_up_to_date(Connection& connection, const WatchState& state, const OpenTables& tables);

}  // namespace foresee
