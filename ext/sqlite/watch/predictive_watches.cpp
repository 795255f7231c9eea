// predictive_watches in SQL: every watch that the connection sees, with its declaration, clock and position.
#include <algorithm>

#include "base/number_text.h"
#include "sqlite/functions/table_functions.h"
#include "sqlite/names/visible_tables.h"
#include "sqlite/sql_tokens.h"
#include "sqlite/watch/watch_table.h"
#include "sqlite/watch/watches.h"

namespace foresee {
namespace {

constexpr ColumnList watches_outputs{"name TEXT",      "schema TEXT",    "tbl TEXT",       "other TEXT",
                                     "horizon REAL",   "within REAL",    "within_z REAL",  "clock TEXT",
                                     "tolerance REAL", "keep INTEGER",   "ahead REAL",     "now REAL",
                                     "seq INTEGER",    "oldest INTEGER", "pairs INTEGER",  "waiting INTEGER",
                                     "early INTEGER",  "fault TEXT",     "created INTEGER"};
constexpr int out_name = watches_outputs["name"], out_schema = watches_outputs["schema"],
              out_tbl = watches_outputs["tbl"], out_other = watches_outputs["other"],
              out_horizon = watches_outputs["horizon"], out_within = watches_outputs["within"],
              out_within_z = watches_outputs["within_z"], out_clock = watches_outputs["clock"],
              out_tolerance = watches_outputs["tolerance"], out_keep = watches_outputs["keep"],
              out_ahead = watches_outputs["ahead"], out_now = watches_outputs["now"],
              out_seq = watches_outputs["seq"], out_oldest = watches_outputs["oldest"],
              out_pairs = watches_outputs["pairs"], out_waiting = watches_outputs["waiting"],
              out_fault = watches_outputs["fault"], out_created = watches_outputs["created"];
constexpr ColumnList watches_inputs{"schema_name", "within_schema"};  // the second: its name up to 0.2.0
constexpr int in_schema = watches_inputs["schema_name"], in_old_schema = watches_inputs["within_schema"];

struct ListedWatch {
  QualifiedName name;
  WatchState state = {};
  std::int64_t oldest = 0, pairs = 0, waiting = 0;
  std::string fault = {};
};

/// Whether the next commit must recompute the watch. Changes of an open transaction are not a reason.
bool is_lost(Connection& connection, const WatchState& state, const OpenTables& tables) {
  if (is_up_to_date(connection, state, tables)) return false;
  const auto has_followed = [](const OpenTable& table, const std::optional<std::int64_t>& stamp) {
    return stamp && table.store->stamp_at_begin() == stamp;
  };
  if (state.must_rebuild || !has_followed(tables.a, state.stamp)) return true;
  if (tables.b && !has_followed(*tables.b, state.other_stamp)) return true;
  const JoinedTables sources = sources_of(connection, tables);
  const ChangedSides changed = changed_sides(sources, state);
  if (!changed.a.are_known || !changed.b.are_known) return false;
  // Objects without a clock: it is lost, unless this transaction has added them.
  return changed.a.ids.empty() && changed.b.ids.empty() && !state.clock && any_object(sources);
}

/// Throws Error if the table's _meta does not list the watch. A table updates only the watches of that list.
void require_listed(const OpenTable& table, const std::string& watch) {
  const std::vector<std::string>& listed = table.store->watch_names();
  if (std::any_of(listed.begin(), listed.end(), [&](const auto& name) { return same_name(name, watch); }))
    return;
  throw Error(watch + ": " + table.table + "_meta does not list it, so commits pass it over; DROP TABLE " +
              watch + " and CREATE it again");
}

/// A clock that no report advances while many are too early: in a table with plans it does not follow them.
std::string fault_of_clock(const WatchState& state, const std::string& watch) {
  constexpr std::int64_t many = 16;
  if (!state.ahead || !state.clock || state.early_score < many) return "";
  return "its clock stands at " + shown(*state.clock) +
         ", and reports are later by more than ahead: INSERT INTO " + watch + "(" + watch +
         ", now) VALUES('advance', ...) with the present time";
}

ListedWatch read_watch(Connection& connection, const QualifiedName& name, bool counts) {
  ListedWatch watch{name};
  try {
    const std::shared_ptr<WatchRows> rows = watches_of(connection).rows(name);
    watch.state = rows->read_state();
    watch.oldest = rows->readable_after().value_or(watch.state.seq);
    if (counts) {
      watch.pairs = rows->count_pairs(PairState::reported);
      watch.waiting = rows->count_pairs(PairState::waiting);
    }
    const OpenTables tables = watched_tables(connection, name.schema, watch.state);
    require_listed(tables.a, name.table);
    if (tables.b) require_listed(*tables.b, name.table);
    if (is_lost(connection, watch.state, tables))
      watch.fault = "not up to date: read by the join, and recomputed at the next commit";
    else
      watch.fault = fault_of_clock(watch.state, name.table);
  } catch (const StoreError& error) {
    if (!error.is_of_contents()) throw;
    watches_of(connection).forget(name);
    watch.fault = error.what();
  } catch (const Error& error) {
    watch.fault = error.what();
  }
  return watch;
}

class WatchList final : public FunctionRows {
 public:
  explicit WatchList(std::vector<ListedWatch> watches) : watches_(std::move(watches)) {}

  bool next() override { return ++row_ < watches_.size(); }

  void output(sqlite3_context* context, int output) const override {
    const ListedWatch& watch = watches_[row_];
    const WatchState& state = watch.state;
    const auto text = [&](const std::string& value) {
      sqlite3_result_text64(context, value.data(), value.size(), SQLITE_TRANSIENT, SQLITE_UTF8);
    };
    const auto number = [&](const std::optional<double>& value) {
      if (value) sqlite3_result_double(context, *value);
    };
    if (output == out_name) return text(watch.name.table);
    if (output == out_schema) return text(watch.name.schema);
    if (output == out_fault) return watch.fault.empty() ? sqlite3_result_null(context) : text(watch.fault);
    if (state.tbl.empty()) return;  // damaged: the state is unknown
    switch (output) {
      case out_tbl:
        return text(state.tbl);
      case out_other:
        return state.other ? text(*state.other) : sqlite3_result_null(context);
      case out_horizon:
        return number(state.horizon);
      case out_within:
        return number(state.within);
      case out_within_z:
        return number(state.within_z);
      case out_clock:
        return text(state.manual ? "manual" : "newest");
      case out_tolerance:
        return number(state.tolerance);
      case out_keep:
        return sqlite3_result_int64(context, state.keep);
      case out_ahead:
        return number(state.ahead);
      case out_now:
        return number(state.now());
      case out_seq:
        return sqlite3_result_int64(context, state.seq);
      case out_oldest:
        return sqlite3_result_int64(context, watch.oldest);
      case out_pairs:
        return sqlite3_result_int64(context, watch.pairs);
      case out_waiting:
        return sqlite3_result_int64(context, watch.waiting);
      case out_created:
        return state.created ? sqlite3_result_int64(context, *state.created) : sqlite3_result_null(context);
      default:
        return sqlite3_result_int64(context, state.early_reports);
    }
  }

 private:
  std::vector<ListedWatch> watches_;
  std::size_t row_ = static_cast<std::size_t>(-1);
};

bool is_in(const VisibleTable& table, const std::optional<std::string>& schema) {
  return !schema || same_name(table.schema, *schema);
}

std::unique_ptr<FunctionRows> start(const FunctionCall& call) {
  Connection& connection = call.connection();
  const auto schema = call.text(in_schema), old_schema = call.text(in_old_schema);
  const bool counts = call.reads(out_pairs) || call.reads(out_waiting);
  std::vector<ListedWatch> watches;
  for (const VisibleTable& table : visible_tables(connection.db()))
    if (table.is_watch && is_in(table, schema) && is_in(table, old_schema))
      watches.push_back(read_watch(connection, {table.schema, table.name}, counts));
  return std::make_unique<WatchList>(std::move(watches));
}

}  // namespace

const TableFunction& predictive_watches() {
  static const TableFunction function = {.name = "predictive_watches",
                                         .outputs = watches_outputs,
                                         .inputs = watches_inputs,
                                         .key = "schema, name",
                                         .hinted = 0,
                                         .estimate =
                                             [](const CallSizes&) {
                                               return CallEstimate{100, 3};
                                             },
                                         .start = start,
                                         .unread_if_left_out = 0x3};
  return function;
}

}  // namespace foresee
