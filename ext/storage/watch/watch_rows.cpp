#include "storage/watch/watch_rows.h"

#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "storage/rows/store_error.h"

namespace foresee::storage {
namespace {

constexpr std::array<const char*, 3> suffixes{"pair", "log", "meta"};

constexpr const char* pair_columns = "SELECT a, b, t, due, state, coalesce(told, t) FROM {pair} ";

/// What one row of _meta holds, as a number.
struct MetaValue {
  std::string text;
  std::optional<std::int64_t> integer;
  std::optional<double> number;
};

}  // namespace

bool is_watch_suffix(std::string_view suffix) {
  return is_one_of(suffix, suffixes);
}

// The keys beside the first are indexes: named by SQLite, they are renamed with their table.
ShadowTables WatchRows::tables(sqlite3* db, const QualifiedName& name) {
  return {
      db,
      name,
      {{"pair",
        "(a INTEGER, b INTEGER, t REAL, due REAL, state INTEGER, told REAL, PRIMARY KEY(a, b), UNIQUE(b, a), "
        "UNIQUE(state, due, a, b)) WITHOUT ROWID"},
       {"log", "(seq INTEGER PRIMARY KEY, op TEXT, a INTEGER, b INTEGER, t REAL, now REAL)"},
       {"meta", "(key TEXT PRIMARY KEY, value) WITHOUT ROWID"}}};
}

WatchRows::WatchRows(sqlite3* db, const QualifiedName& name) : name_(name) {
  const ShadowTables shadow = tables(db, name);
  shadow.require_tables();
  const auto sql = [&](const std::string& text) { return shadow.statement(text); };
  const std::string pairs = pair_columns;
  meta_ = sql("SELECT key, value FROM {meta}");
  write_meta_ = sql("INSERT OR REPLACE INTO {meta} VALUES(?1, ?2)");
  pairs_ = sql(pairs + "ORDER BY a, b");
  pairs_of_a_ = sql(pairs + "WHERE a = ?1 ORDER BY b");
  pairs_of_b_ = sql(pairs + "WHERE b = ?1 ORDER BY a");
  due_pairs_ = sql(pairs + "WHERE state = ?1 AND due <= ?2");
  pair_ = sql(pairs + "WHERE a = ?1 AND b = ?2");
  write_pair_ =
      sql("INSERT INTO {pair} VALUES(?1, ?2, ?3, ?4, ?5, ?6) ON CONFLICT(a, b) DO UPDATE "
          "SET t = ?3, due = ?4, state = ?5, told = ?6");
  erase_pair_ = sql("DELETE FROM {pair} WHERE a = ?1 AND b = ?2");
  count_pairs_ = sql("SELECT count(*) FROM {pair} WHERE state = ?1");
  counts_ = sql(
      "SELECT (SELECT count(*) FROM {pair} WHERE b IS NOT NULL ORDER BY a, b), "
      "(SELECT count(*) FROM {pair} p WHERE EXISTS(SELECT 1 FROM {pair} q WHERE q.b = p.b AND q.a = p.a)), "
      "(SELECT count(*) FROM {pair} WHERE state IN (0, 1))");
  append_ = sql("INSERT OR REPLACE INTO {log} VALUES(?1, ?2, ?3, ?4, ?5, ?6)");
  trim_ = sql("DELETE FROM {log} WHERE seq <= ?1");
  oldest_ = sql("SELECT min(seq) FROM {log}");
  changes_ =
      sql("SELECT seq, op, a, b, t, now FROM {log} WHERE seq > ?1 AND seq <= ?2 ORDER BY seq LIMIT ?3");
}

void WatchRows::damaged(const std::string& what) const {
  throw StoreError(SQLITE_CORRUPT_VTAB, name_.table + ": " + name_.table + "_" + what +
                                            " is damaged: DROP TABLE " + name_.table +
                                            " and CREATE it again");
}

// --- _meta

WatchState WatchRows::read_state() {
  std::map<std::string, MetaValue> values;
  for (Statement::Run run(meta_); run.step();) {
    MetaValue value{.text = run.text(1, 1000), .integer = {}, .number = {}};
    if (run.is_integer(1)) value.integer = run.integer(1);
    const int type = sqlite3_value_type(run.value(1));
    if (type == SQLITE_INTEGER || type == SQLITE_FLOAT) value.number = sqlite3_value_double(run.value(1));
    values[run.text(0, 100)] = std::move(value);
  }
  const auto number = [&](const char* key) { return values[key].number; };
  const auto required = [&](const char* key, double least) {
    if (const auto found = number(key); found && *found >= least) return *found;
    damaged("meta");
  };
  const auto integer = [&](const char* key) {
    if (const auto found = values[key].integer; found && *found >= 0) return *found;
    damaged("meta");
  };
  WatchState state;
  state.tbl = values["tbl"].text;
  if (state.tbl.empty()) damaged("meta");
  if (!values["other"].text.empty()) state.other = values["other"].text;
  state.horizon = required("horizon", 0), state.within = required("within", 0);
  state.within_z = number("within_z");
  state.manual = values["clock"].text == "manual";
  state.tolerance = required("tolerance", 0), state.keep = integer("keep");
  state.ahead = number("ahead");
  state.clock = number("now"), state.asked = number("asked");
  state.anew = number("anew").value_or(0) != 0;
  state.known_to = number("known_to").value_or(-std::numeric_limits<double>::infinity());
  state.step = number("step").value_or(0);
  state.seq = integer("seq"), state.early = integer("early");
  state.stamp = values["stamp"].integer, state.other_stamp = values["other_stamp"].integer;
  for (const auto& moment : {state.clock, state.asked})
    if (moment && !std::isfinite(*moment)) damaged("meta");
  return state;
}

template <class Value>
void WatchRows::write_meta(std::string_view key, const std::optional<Value>& value) {
  Statement::Run run(write_meta_);
  run.bind(1, key);
  if (value) run.bind(2, *value);
  run.step();
}

template <class Value>
void WatchRows::write_changed(std::string_view key, const Value& value, const Value& before) {
  if (value == before) return;
  if constexpr (requires { value.has_value(); })
    write_meta(key, value);
  else
    write_meta(key, std::optional(value));
}

void WatchRows::write_tables(const WatchDeclaration& declaration) {
  write_meta("tbl", std::optional<std::string_view>(declaration.tbl));
  write_meta("other", std::optional<std::string_view>(declaration.other));
}

void WatchRows::write_declaration(const WatchDeclaration& declaration) {
  write_tables(declaration);
  write_meta("format", std::optional(std::int64_t{1}));
  write_meta("horizon", std::optional(declaration.horizon));
  write_meta("within", std::optional(declaration.within));
  write_meta("within_z", declaration.within_z);
  write_meta("clock", std::optional<std::string_view>(declaration.manual ? "manual" : "newest"));
  write_meta("tolerance", std::optional(declaration.tolerance));
  write_meta("keep", std::optional(declaration.keep));
  write_meta("ahead", declaration.ahead);
  write_meta("seq", std::optional(std::int64_t{0}));
  write_meta("early", std::optional(std::int64_t{0}));
}

void WatchRows::write_state(const WatchState& state, const WatchState& before) {
  write_changed("now", state.clock, before.clock);
  write_changed("asked", state.asked, before.asked);
  if (state.anew != before.anew) write_anew(state.anew);
  write_changed("known_to", state.known_to, before.known_to);
  write_changed("step", state.step, before.step);
  write_changed("seq", state.seq, before.seq);
  write_changed("early", state.early, before.early);
  write_changed("stamp", state.stamp, before.stamp);
  write_changed("other_stamp", state.other_stamp, before.other_stamp);
}

void WatchRows::write_asked(std::optional<double> moment) {
  write_meta("asked", moment);
}

void WatchRows::write_anew(bool anew) {
  write_meta("anew", std::optional(std::int64_t{anew}));
}

// --- _pair

std::vector<StoredPair> WatchRows::read_pairs(Statement::Run& run) const {
  std::vector<StoredPair> pairs;
  while (run.step()) {
    const auto number = [&](int column) {
      if (sqlite3_value_type(run.value(column)) != SQLITE_FLOAT) damaged("pair");
      return sqlite3_value_double(run.value(column));
    };
    if (!run.is_integer(0) || !run.is_integer(1) || !run.is_integer(4)) damaged("pair");
    const std::int64_t a = run.integer(0), b = run.integer(1);
    // Pages of a damaged file may lead back to one another: no order has a pair twice in a row.
    if (!pairs.empty() && pairs.back().a == a && pairs.back().b == b) damaged("pair");
    pairs.push_back({a, b, number(2), number(3), number(5), run.integer(4) != 0});
  }
  return pairs;
}

std::vector<StoredPair> WatchRows::pairs() {
  Statement::Run run(pairs_);
  return read_pairs(run);
}

std::vector<StoredPair> WatchRows::pairs_of_a(std::int64_t id) {
  Statement::Run run(pairs_of_a_);
  run.bind(1, id);
  return read_pairs(run);
}

std::vector<StoredPair> WatchRows::pairs_of_b(std::int64_t id) {
  Statement::Run run(pairs_of_b_);
  run.bind(1, id);
  return read_pairs(run);
}

std::vector<StoredPair> WatchRows::due_pairs(bool held, double until) {
  Statement::Run run(due_pairs_);
  run.bind(1, std::int64_t{held});
  run.bind(2, until);
  return read_pairs(run);
}

std::optional<StoredPair> WatchRows::pair(std::int64_t a, std::int64_t b) {
  Statement::Run run(pair_);
  run.bind(1, a);
  run.bind(2, b);
  const std::vector<StoredPair> found = read_pairs(run);
  return found.empty() ? std::nullopt : std::optional(found.front());
}

void WatchRows::write_pair(const StoredPair& pair, bool with_told) {
  Statement::Run run(write_pair_);
  run.bind(1, pair.a);
  run.bind(2, pair.b);
  run.bind(3, pair.t);
  run.bind(4, pair.due);
  run.bind(5, std::int64_t{pair.held});
  if (with_told) run.bind(6, pair.told);
  run.step();
}

void WatchRows::erase_pair(std::int64_t a, std::int64_t b) {
  Statement::Run run(erase_pair_);
  run.bind(1, a);
  run.bind(2, b);
  run.step();
}

std::int64_t WatchRows::count_pairs(bool held) {
  Statement::Run run(count_pairs_);
  run.bind(1, std::int64_t{held});
  return run.step() ? run.integer(0) : 0;
}

bool WatchRows::indexes_agree() {
  Statement::Run run(counts_);
  return run.step() && run.integer(0) == run.integer(1) && run.integer(0) == run.integer(2);
}

// --- _log

void WatchRows::append(const StoredChange& change) {
  Statement::Run run(append_);
  run.bind(1, change.seq);
  run.bind(2, std::string_view(&change.op, 1));
  run.bind(3, change.a);
  run.bind(4, change.b);
  if (change.op != '-') run.bind(5, change.t);
  run.bind(6, change.now);
  run.step();
}

void WatchRows::trim(std::int64_t up_to) {
  Statement::Run run(trim_);
  run.bind(1, up_to);
  run.step();
}

std::optional<std::int64_t> WatchRows::oldest() {
  Statement::Run run(oldest_);
  if (!run.step() || !run.is_integer(0)) return std::nullopt;
  return run.integer(0) - 1;
}

std::vector<StoredChange> WatchRows::changes(std::int64_t after, std::int64_t last, std::int64_t most) {
  std::vector<StoredChange> found;
  Statement::Run run(changes_);
  run.bind(1, after);
  run.bind(2, last);
  run.bind(3, most);
  while (run.step()) {
    const std::string op = run.text(1, 1);
    if (op.empty() || run.integer(0) <= after) damaged("log");
    after = run.integer(0);
    found.push_back({after, op[0], run.integer(2), run.integer(3), sqlite3_value_double(run.value(4)),
                     sqlite3_value_double(run.value(5))});
  }
  return found;
}

}  // namespace foresee::storage
