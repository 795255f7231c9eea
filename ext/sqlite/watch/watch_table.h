// One watch as this connection sees it: SQLite's handle, its rows, its commands.
#pragma once

#include <memory>
#include <string>

#include "query/join/join.h"
#include "sqlite/connection.h"
#include "sqlite/watch/pair_search.h"
#include "sqlite/watch/watches.h"

namespace foresee {

// Columns as SQL numbers them.
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
  /// Throws StoreError for a watch whose tables are damaged or gone.
  std::shared_ptr<WatchRows> rows() const { return watches().rows(*connection, name); }

  std::shared_ptr<Connection> connection;
  QualifiedName name;
  std::vector<std::string> old_names =
      {};  ///< of this transaction: a rollback to a savepoint may bring one back
};

/// What a statement reads of a watch: xBestIndex's plan.
struct WatchPlan {
  enum Bits : int { by_a = 1, by_b = 2, times = 4, approach = 8 };
};

/// A pair as its reader sees it.
struct ShownPair {
  std::int64_t a, b;
  double t;

  friend auto operator<=>(const ShownPair&, const ShownPair&) = default;
};

/// The pairs as they are when a statement begins to read them, whatever is written beneath it.
class WatchCursor : public sqlite3_vtab_cursor {
 public:
  explicit WatchCursor(WatchTable& table) : sqlite3_vtab_cursor{}, table_(table) {}

  /// `plan`: WatchPlan's bits; the values of a and b follow, as many as it has.
  void filter(int plan, sqlite3_value** arguments);
  void next();
  bool at_end() const { return rows_.empty(); }
  void column(sqlite3_context* context, int column) const;

 private:
  std::vector<ShownPair> kept_pairs(WatchRows& rows, const ChangedSides& changed) const;
  bool read_changed(WatchRows& rows, const WatchState& state, const WatchedTables& tables);
  void give(std::span<const ShownPair> pairs, const WatchState& state, const WatchedTables& tables);
  void join_now(const WatchState& state, const WatchedTables& tables);

  WatchTable& table_;
  int plan_ = 0;
  std::optional<std::int64_t> only_a_, only_b_;
  double now_ = 0;
  std::vector<JoinRow> stored_;
  std::unique_ptr<Join> join_;
  std::span<const JoinRow> rows_;  ///< from the current one on
};

/// 'advance', 'rebuild', 'integrity-check'. Throws Error for another.
void run_watch_command(WatchTable& table, sqlite3_value* command, sqlite3_value* now);

/// What is wrong with the watch, as one sentence; "" if nothing is.
std::string watch_fault(WatchTable& table);

/// Whether the rows are about the tables as this connection sees them now, at the watch's moment.
bool is_settled(const WatchState& state, const WatchedTables& tables);

/// Whether there are objects and no clock: it is lost, unless the transaction under way has brought them.
bool lacks_clock(const WatchState& state, const WatchedTables& tables);

}  // namespace foresee
