#include "sqlite/watch/pair_keys.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace foresee {
namespace {

void append_ids(Statement::Run& run, std::vector<PairIds>& pairs) {
  while (run.step()) pairs.push_back({run.integer(0), run.integer(1)});
}

void run_all(Statement& statement) {
  Statement::Run run(statement);
  run.step();
}

}  // namespace

std::vector<ShadowTable> PairKeys::tables() {
  return {{"back", "(b INTEGER, a INTEGER, PRIMARY KEY(b, a)) WITHOUT ROWID"},
          {"due",
           "(state INTEGER, due REAL, a INTEGER, b INTEGER, PRIMARY "
           "KEY(state, due, a, b)) WITHOUT ROWID"}};
}

void PairKeys::connect(const ShadowTables& tables, bool in_tables) {
  in_tables_ = in_tables;
  const std::string back = in_tables ? "{back} " : "{pair} ", due = in_tables ? "{due} " : "{pair} ";
  const auto sql = [&](const std::string& text) { return tables.statement(text); };
  back_.found = sql("SELECT a, b FROM " + back + "WHERE b = ?1 ORDER BY a");
  back_.all = sql("SELECT a, b FROM " + back + "ORDER BY b, a");
  due_.found = sql("SELECT a, b FROM " + due + "WHERE state = ?1 AND due <= ?2");
  due_.all = sql("SELECT a, b, due, state FROM " + due + "ORDER BY state, due, a, b");
  if (!in_tables) return;
  back_.add = sql("INSERT INTO {back} VALUES(?1, ?2)");
  back_.erase = sql("DELETE FROM {back} WHERE b = ?1 AND a = ?2");
  back_.erase_all = sql("DELETE FROM {back}");
  due_.add = sql("INSERT INTO {due} VALUES(?1, ?2, ?3, ?4)");
  due_.erase = sql("DELETE FROM {due} WHERE state = ?1 AND due = ?2 AND a = ?3 AND b = ?4");
  due_.erase_all = sql("DELETE FROM {due}");
}

// --- reading

void PairKeys::append_of_b(std::int64_t b, std::vector<PairIds>& pairs) {
  Statement::Run run(back_.found);
  run.bind(1, b);
  append_ids(run, pairs);
}

std::vector<PairIds> PairKeys::due(PairState state, double until) {
  std::vector<PairIds> pairs;
  Statement::Run run(due_.found);
  run.bind(1, static_cast<std::int64_t>(state));
  run.bind(2, until);
  append_ids(run, pairs);
  return pairs;
}

/// Compares keys with `pairs`, in their order.
bool PairKeys::holds(Statement& keys, const std::vector<WatchedPair>& pairs, bool with_due) {
  auto pair = pairs.begin();
  for (Statement::Run run(keys); run.step(); ++pair) {
    if (pair == pairs.end() || run.integer(0) != pair->a || run.integer(1) != pair->b) return false;
    if (!with_due) continue;
    const bool is_due = sqlite3_value_type(run.value(2)) != SQLITE_NULL;
    const double due = is_due ? sqlite3_value_double(run.value(2)) : never_due;
    if (due != pair->due || run.integer(3) != static_cast<std::int64_t>(pair->state)) return false;
  }
  return pair == pairs.end();
}

bool PairKeys::agree(std::vector<WatchedPair> pairs) {
  const auto sort_by = [&](auto key) {
    std::sort(pairs.begin(), pairs.end(), [&](const auto& x, const auto& y) { return key(x) < key(y); });
  };
  sort_by([](const WatchedPair& pair) { return std::tuple(pair.b, pair.a); });
  if (!holds(back_.all, pairs, false)) return false;
  if (in_tables_) std::erase_if(pairs, [](const WatchedPair& pair) { return pair.due == never_due; });
  sort_by([](const WatchedPair& pair) {  // NULL, never due, comes first
    return std::tuple(pair.state, pair.due != never_due, pair.due, pair.a, pair.b);
  });
  return holds(due_.all, pairs, true);
}

// --- writing

void PairKeys::note_due(const WatchedPair& pair, bool adds) {
  if (pair.due != never_due) due_waits_.push_back({pair.state, pair.due, pair.a, pair.b, adds});
}

void PairKeys::add(const WatchedPair& pair) {
  if (!in_tables_) return;
  back_waits_.push_back({pair.b, pair.a, true});
  note_due(pair, true);
}

void PairKeys::erase(const WatchedPair& pair) {
  if (!in_tables_) return;
  back_waits_.push_back({pair.b, pair.a, false});
  note_due(pair, false);
}

void PairKeys::change(const WatchedPair& before, const WatchedPair& after) {
  if (!in_tables_ || (before.state == after.state && before.due == after.due)) return;
  note_due(before, false);
  note_due(after, true);
}

void PairKeys::erase_all() {
  forget();
  if (!in_tables_) return;
  run_all(back_.erase_all);
  run_all(due_.erase_all);
}

void PairKeys::write() {
  // Emptied first: after an error they must not be written again. The transaction is rolled back then, or the watch is
  // marked as damaged.
  std::vector<BackKey> back = std::exchange(back_waits_, {});
  std::vector<DueKey> due = std::exchange(due_waits_, {});
  std::sort(back.begin(), back.end());
  std::sort(due.begin(), due.end());
  for (const BackKey& key : back) {
    Statement::Run run(key.adds ? back_.add : back_.erase);
    run.bind(1, key.b);
    run.bind(2, key.a);
    run.step();
  }
  for (const DueKey& key : due) {
    Statement::Run run(key.adds ? due_.add : due_.erase);
    run.bind(1, static_cast<std::int64_t>(key.state));
    run.bind(2, key.due);
    run.bind(3, key.a);
    run.bind(4, key.b);
    run.step();
  }
}

}  // namespace foresee
