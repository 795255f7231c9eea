// predictive_changes(watch, since, schema) in SQL: the changes that a watch has logged since a position.
#include "sqlite/callback.h"
#include "sqlite/functions/table_function.h"
#include "sqlite/functions/table_functions.h"
#include "sqlite/names/open_table.h"
#include "sqlite/names/visible_tables.h"
#include "sqlite/sql_tokens.h"
#include "sqlite/watch/watches.h"

namespace foresee {
namespace {

constexpr ColumnList changes_outputs{"seq INTEGER", "op TEXT", "a INTEGER",
                                     "b INTEGER",   "t REAL",  "now REAL"};
constexpr int out_seq = changes_outputs["seq"], out_op = changes_outputs["op"], out_a = changes_outputs["a"],
              out_b = changes_outputs["b"], out_now = changes_outputs["now"];
constexpr ColumnList changes_inputs{"watch", "since", "schema"};
constexpr int in_watch = changes_inputs["watch"], in_since = changes_inputs["since"],
              in_schema = changes_inputs["schema"];

constexpr std::int64_t batch_size = 1000;

/// Holds a read transaction, so that several statements read the same state of the database.
class ReadTransaction {
 public:
  ReadTransaction(sqlite3* db, const std::string& schema)
      : statement_(db, "SELECT 1 FROM " + quoted_name(schema) + ".sqlite_master"), run_(statement_) {
    run_.step();
  }

 private:
  Statement statement_;
  Statement::Run run_;
};

[[noreturn]] void refuse_trimmed(const std::string& watch, std::int64_t oldest) {
  throw Error(watch + ": changes up to " + std::to_string(oldest) +
              " are no longer kept; read the whole watch with since = 0");
}

/// Reads the log in batches, so that no statement stays open while the query processes a row. Changes that
/// are appended meanwhile are beyond `last`. Trimmed changes are detected, because positions have no gaps.
class ChangeRows final : public FunctionRows {
 public:
  ChangeRows(std::shared_ptr<WatchRows> rows, std::int64_t after, std::int64_t last)
      : rows_(std::move(rows)), after_(after), last_(last) {}
  explicit ChangeRows(std::vector<LoggedChange> all) : batch_(std::move(all)) {}

  bool next() override {
    if (++row_ < batch_.size()) return true;
    if (!rows_ || after_ >= last_) return false;
    batch_ = rows_->changes(after_, last_, batch_size);
    row_ = 0;
    const auto count = static_cast<std::int64_t>(batch_.size());
    if (count == 0 || batch_.front().seq != after_ + 1 || batch_.back().seq != after_ + count)
      refuse_trimmed(rows_->name().table, rows_->readable_after().value_or(last_));
    after_ += count;
    return true;
  }

  void output(sqlite3_context* context, int output) const override {
    const LoggedChange& row = batch_[row_];
    if (output == out_seq) return sqlite3_result_int64(context, row.seq);
    if (output == out_op) return sqlite3_result_text(context, &row.op, 1, SQLITE_TRANSIENT);
    if (output == out_a || output == out_b)
      return sqlite3_result_int64(context, output == out_a ? row.a : row.b);
    if (output == out_now) return sqlite3_result_double(context, row.now);
    if (row.op != '-') sqlite3_result_double(context, row.t);
  }

 private:
  std::shared_ptr<WatchRows> rows_;
  std::int64_t after_ = 0, last_ = 0;
  std::vector<LoggedChange> batch_;
  std::size_t row_ = static_cast<std::size_t>(-1);
};

/// " (watches here: 'alerts', 'storms' with schema = 'main')": each as a query must write it.
std::string list_watches(const std::vector<VisibleTable>& tables, bool with_schemas) {
  std::string list;
  for (const VisibleTable& table : tables) {
    if (!table.is_watch) continue;
    list += (list.empty() ? "" : ", ") + quoted(table.name);
    if (with_schemas || !same_name(table.schema, "main")) list += " with schema = " + quoted(table.schema);
  }
  return list.empty() ? " (none here; make one with CREATE VIRTUAL TABLE alerts USING "
                        "predictive_watch(ships, horizon = 600))"
                      : " (watches here: " + list + ")";
}

/// The watch of this name, as SQLite resolves names. By the list of all tables, which the messages need too.
QualifiedName find_watch(sqlite3* db, const std::string& name, const std::optional<std::string>& schema) {
  const std::vector<VisibleTable> tables = visible_tables(db);
  const VisibleTable* other = nullptr;
  for (const VisibleTable& table : tables) {
    if (!same_name(table.name, name) || (schema && !same_name(table.schema, *schema))) continue;
    if (table.is_watch) return {table.schema, table.name};
    if (!other) other = &table;
  }
  const std::string given = quoted(name) + (schema ? " in schema " + quoted(*schema) : ""),
                    list = list_watches(tables, schema.has_value());
  if (!other) throw Error("no such watch: " + given + list);
  throw Error(given + " is not a watch" +
              (other->holds_moving_objects ? " but a table of moving objects" : "") +
              "; write a name of SELECT name FROM predictive_watches" + list);
}

/// The reported pairs, all with the current position of the watch. Their times are those of the log and not
/// clipped to the clock, so that every reader sees the same times after the clock goes back.
std::vector<LoggedChange> whole_watch(WatchRows& rows, const WatchState& state) {
  std::vector<LoggedChange> all;
  const double now = state.clock.value_or(0);
  for (const WatchedPair& pair : rows.pairs())
    if (pair.is_reported()) all.push_back({state.seq, '+', pair.a, pair.b, pair.reported_t, now});
  return all;
}

std::unique_ptr<FunctionRows> start(const FunctionCall& call) {
  Connection& connection = call.connection();
  const auto name = call.text(in_watch, "the name of a watch in quotes");
  if (!name) throw Error("watch is missing or NULL: write predictive_changes('alerts', since)");
  const QualifiedName watch = find_watch(connection.db(), *name, call.text(in_schema));
  call.reads_back_as(in_schema, watch.schema);
  const ReadTransaction transaction(connection.db(), watch.schema);
  const std::shared_ptr<WatchRows> rows = watches_of(connection).rows(watch);
  const WatchState state = rows->read_state();
  const std::int64_t since = call.number(in_since) ? call.required_integer(in_since) : 0;
  if (since < 0) throw Error("since must be a whole number >= 0, not " + std::to_string(since));
  if (since == 0) return std::make_unique<ChangeRows>(whole_watch(*rows, state));
  if (since > state.seq)
    throw Error("since = " + std::to_string(since) + " is beyond the last change of " + watch.table + ", " +
                std::to_string(state.seq) + ": was the file restored? Read again with since = 0");
  const std::int64_t oldest = rows->readable_after().value_or(state.seq);
  if (since < oldest) refuse_trimmed(watch.table, oldest);
  return std::make_unique<ChangeRows>(rows, since, state.seq);
}

}  // namespace

const TableFunction& predictive_changes() {
  static const TableFunction function = {.name = "predictive_changes",
                                         .outputs = changes_outputs,
                                         .inputs = changes_inputs,
                                         .key = "seq, a, b",
                                         .hinted = 0,
                                         .estimate =
                                             [](const CallSizes&) {
                                               return CallEstimate{1000, 1000};
                                             },
                                         .start = start,
                                         .orders = {{out_seq}}};
  return function;
}

}  // namespace foresee
