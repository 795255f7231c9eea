#include "sqlite/watch/watch_rows.h"

#include <algorithm>
#include <array>

#include "database/sqlite_api.h"

namespace foresee {
namespace {

constexpr std::array<const char*, 5> suffixes{"pair", "back", "due", "log", "meta"};

/// Whether the last statement failed because a row is there already. The application chooses whether results have
/// extended codes.
bool is_conflict(sqlite3* db) {
  const int code = sqlite3_extended_errcode(db);
  return code == SQLITE_CONSTRAINT_PRIMARYKEY || code == SQLITE_CONSTRAINT_UNIQUE;
}

constexpr const char* pair_columns = "SELECT a, b, t, due, state, coalesce(told, t) FROM {pair} ";

}  // namespace

bool is_watch_suffix(std::string_view suffix) {
  return is_one_of(suffix, suffixes);
}

ShadowTables WatchRows::tables(sqlite3* db, const QualifiedName& name, bool has_key_tables) {
  std::vector<ShadowTable> all{
      {"pair",
       "(a INTEGER, b INTEGER, t REAL, due REAL, state INTEGER, told REAL, PRIMARY KEY(a, b)) WITHOUT ROWID"},
      {"log", "(seq INTEGER PRIMARY KEY, op TEXT, a INTEGER, b INTEGER, t REAL, now REAL)"},
      {"meta", "(key TEXT PRIMARY KEY, value) WITHOUT ROWID"}};
  if (has_key_tables)
    for (ShadowTable& table : PairKeys::tables()) all.push_back(std::move(table));
  return {db, name, std::move(all)};
}

WatchRows::WatchRows(sqlite3* db, const QualifiedName& name) : db_(db), name_(name) {
  const ShadowTables shadow = tables(db, name, false);
  shadow.require_tables();
  const auto sql = [&](const std::string& text) { return shadow.statement(text); };
  meta_ = sql("SELECT key, value FROM {meta}");
  write_meta_ = sql("INSERT OR REPLACE INTO {meta} VALUES(?1, ?2)");
  log_ = {.append = sql("INSERT OR REPLACE INTO {log} VALUES(?1, ?2, ?3, ?4, ?5, ?6)"),
          .trim = sql("DELETE FROM {log} WHERE seq <= ?1"),
          .oldest = sql("SELECT min(seq) FROM {log}"),
          .after = sql(
              "SELECT seq, op, a, b, t, now FROM {log} WHERE seq > ?1 AND seq <= ?2 ORDER BY seq LIMIT ?3")};
}

/// Another connection may have created the watch again, with or without tables of keys.
void WatchRows::use_pairs(bool with_key_tables) {
  if (has_key_tables_ == with_key_tables) return;
  const ShadowTables shadow = tables(db_, name_, with_key_tables);
  shadow.require_tables();
  has_key_tables_.reset();  // until all statements are made
  keys_.connect(shadow, with_key_tables);
  const auto sql = [&](const std::string& text) { return shadow.statement(text); };
  const std::string select = pair_columns, of_pair = " WHERE a = ?1 AND b = ?2";
  pairs_ = {.all = sql(select + "ORDER BY a, b"),
            .of_a = sql(select + "WHERE a = ?1 ORDER BY b"),
            .one = sql(select + of_pair),
            .any = sql("SELECT 1 FROM {pair} LIMIT 1"),
            .count = sql("SELECT count(*) FROM {pair} WHERE state = ?1"),
            .add = sql("INSERT INTO {pair} VALUES(?1, ?2, ?3, ?4, ?5, ?6)"),
            .move = sql("UPDATE {pair} SET t = ?3, told = ?6" + of_pair),
            .change = sql("UPDATE {pair} SET t = ?3, due = ?4, state = ?5, told = ?6" + of_pair),
            .erase = sql("DELETE FROM {pair}" + of_pair),
            .erase_all = sql("DELETE FROM {pair}")};
  has_key_tables_ = with_key_tables;
}

void WatchRows::damaged(const std::string& what) const {
  throw StoreError(SQLITE_CORRUPT_VTAB, name_.table + ": " + name_.table + "_" + what +
                                            " is damaged: DROP TABLE " + name_.table +
                                            " and CREATE it again");
}

// --- _pair

void WatchRows::read_pairs(Statement::Run& run, std::vector<WatchedPair>& pairs) const {
  while (run.step()) {
    const auto number = [&](int column) {
      if (sqlite3_value_type(run.value(column)) != SQLITE_FLOAT) damaged("pair");
      return sqlite3_value_double(run.value(column));
    };
    if (!run.is_integer(0) || !run.is_integer(1) || !run.is_integer(4)) damaged("pair");
    const std::int64_t a = run.integer(0), b = run.integer(1), state = run.integer(4);
    if (state != 0 && state != 1) damaged("pair");
    // In a damaged file pages may refer back to one another: no order has a pair twice in a row.
    if (!pairs.empty() && pairs.back().a == a && pairs.back().b == b) damaged("pair");
    const bool is_due = sqlite3_value_type(run.value(3)) != SQLITE_NULL;
    pairs.push_back({a, b, number(2), is_due ? number(3) : never_due, number(5),
                     state == 1 ? PairState::reported : PairState::waiting});
  }
}

/// The rows of these keys, read in the order of the table: its pages once.
std::vector<WatchedPair> WatchRows::pairs_with(std::vector<PairIds> keys) {
  std::sort(keys.begin(), keys.end());
  std::vector<WatchedPair> pairs;
  pairs.reserve(keys.size());
  for (const PairIds& key : keys) {
    const std::size_t before = pairs.size();
    Statement::Run run(pairs_.one);
    run.bind(1, key.a);
    run.bind(2, key.b);
    read_pairs(run, pairs);
    if (pairs.size() == before) damaged("pair");  // it lacks the pair of a key
  }
  return pairs;
}

std::vector<WatchedPair> WatchRows::pairs() {
  std::vector<WatchedPair> pairs;
  Statement::Run run(pairs_.all);
  read_pairs(run, pairs);
  return pairs;
}

std::vector<WatchedPair> WatchRows::stored_pairs_of(std::span<const std::int64_t> a,
                                                    std::span<const std::int64_t> b) {
  std::vector<WatchedPair> pairs;
  for (const std::int64_t id : a) {
    Statement::Run run(pairs_.of_a);
    run.bind(1, id);
    read_pairs(run, pairs);
  }
  std::vector<PairIds> keys;
  for (const std::int64_t id : b) keys_.append_of_b(id, keys);
  std::erase_if(keys, [&](const PairIds& key) { return std::binary_search(a.begin(), a.end(), key.a); });
  const std::vector<WatchedPair> others = pairs_with(std::move(keys));
  pairs.insert(pairs.end(), others.begin(), others.end());
  return pairs;
}

std::vector<WatchedPair> WatchRows::due_pairs(PairState state, double until) {
  return pairs_with(keys_.due(state, until));
}

std::optional<WatchedPair> WatchRows::pair(std::int64_t a, std::int64_t b) {
  Statement::Run run(pairs_.one);
  run.bind(1, a);
  run.bind(2, b);
  std::vector<WatchedPair> found;
  read_pairs(run, found);
  return found.empty() ? std::nullopt : std::optional(found.front());
}

// An unexpected row is damage of the watch, not an error of the statement that commits.
void WatchRows::write_pair(const WatchedPair* before, const WatchedPair& pair, bool with_reported_t) try {
  const bool only_moves = before && before->state == pair.state && before->due == pair.due;
  Statement::Run run(!before ? pairs_.add : only_moves ? pairs_.move : pairs_.change);
  run.bind(1, pair.a);
  run.bind(2, pair.b);
  run.bind(3, pair.t);
  if (!only_moves) {
    if (pair.due != never_due) run.bind(4, pair.due);
    run.bind(5, static_cast<std::int64_t>(pair.state));
  }
  if (with_reported_t) run.bind(6, pair.reported_t);
  run.step();
  if (before)
    keys_.change(*before, pair);
  else
    keys_.add(pair);
} catch (const StoreError&) {
  if (!is_conflict(db_)) throw;
  damaged("pair");
}

void WatchRows::erase_pair(const WatchedPair& pair) {
  Statement::Run run(pairs_.erase);
  run.bind(1, pair.a);
  run.bind(2, pair.b);
  run.step();
  keys_.erase(pair);
}

void WatchRows::erase_all_pairs() {
  Statement::Run run(pairs_.erase_all);
  run.step();
  keys_.erase_all();
}

void WatchRows::write_keys() try { keys_.write(); } catch (const StoreError&) {
  if (!is_conflict(db_)) throw;
  damaged("pair");
}

std::int64_t WatchRows::count_pairs(PairState state) {
  Statement::Run run(pairs_.count);
  run.bind(1, static_cast<std::int64_t>(state));
  return run.step() ? run.integer(0) : 0;
}

bool WatchRows::has_pairs() {
  Statement::Run run(pairs_.any);
  return run.step();
}

// --- _log

void WatchRows::append(const LoggedChange& change) {
  Statement::Run run(log_.append);
  run.bind(1, change.seq);
  run.bind(2, std::string_view(&change.op, 1));
  run.bind(3, change.a);
  run.bind(4, change.b);
  if (change.op != '-') run.bind(5, change.t);
  run.bind(6, change.now);
  run.step();
}

void WatchRows::trim(std::int64_t up_to) {
  Statement::Run run(log_.trim);
  run.bind(1, up_to);
  run.step();
}

std::optional<std::int64_t> WatchRows::readable_after() {
  Statement::Run run(log_.oldest);
  if (!run.step() || !run.is_integer(0)) return std::nullopt;
  return run.integer(0) - 1;
}

std::vector<LoggedChange> WatchRows::changes(std::int64_t after, std::int64_t last, std::int64_t limit) {
  std::vector<LoggedChange> found;
  Statement::Run run(log_.after);
  run.bind(1, after);
  run.bind(2, last);
  run.bind(3, limit);
  while (run.step()) {
    const std::string op = run.text(1, 2);
    const bool is_gone = op == "-", is_op = is_gone || op == "+" || op == "~";
    const auto is_number = [&](int column) { return sqlite3_value_type(run.value(column)) == SQLITE_FLOAT; };
    if (!is_op || run.integer(0) <= after || !run.is_integer(2) || !run.is_integer(3) || !is_number(5) ||
        (is_gone ? !run.is_null(4) : !is_number(4)))
      damaged("log");
    after = run.integer(0);
    found.push_back({after, op[0], run.integer(2), run.integer(3), sqlite3_value_double(run.value(4)),
                     sqlite3_value_double(run.value(5))});
  }
  return found;
}

}  // namespace foresee
