#include <algorithm>

#include "base/integer_of.h"
#include "query/watch/pair_contacts.h"
#include "query/watch/pair_search.h"
#include "sqlite/watch/watch_table.h"

namespace foresee {
namespace {

/// The id that is equal to the value; nothing if no id is, because then no row satisfies the statement.
std::optional<std::int64_t> id_of(sqlite3_value* value) {
  const int type = sqlite3_value_numeric_type(value);
  if (type == SQLITE_INTEGER) return sqlite3_value_int64(value);
  if (type != SQLITE_FLOAT) return std::nullopt;
  return integer_of(sqlite3_value_double(value));
}

/// The key of a pair: its two ids as big-endian integers of eight bytes, as in SQLite's record format.
void result_key(sqlite3_context* context, const JoinRow& row) {
  unsigned char key[16];
  for (int i = 0; i < 8; ++i) {
    key[i] = static_cast<unsigned char>(static_cast<std::uint64_t>(row.a) >> (56 - 8 * i));
    key[8 + i] = static_cast<unsigned char>(static_cast<std::uint64_t>(row.b) >> (56 - 8 * i));
  }
  sqlite3_result_blob(context, key, sizeof key, SQLITE_TRANSIENT);
}

}  // namespace

bool is_up_to_date(Connection& connection, const WatchState& state, const OpenTables& tables) {
  const auto holds = [](const OpenTable& table, const std::optional<std::int64_t>& stamp) {
    return stamp && table.store->stamp_if_written() == stamp;
  };
  return !state.must_rebuild && !state.requested_clock && holds(tables.a, state.stamp) &&
         (!tables.b || holds(*tables.b, state.other_stamp)) &&
         (state.clock || !any_object(sources_of(connection, tables)));
}

void WatchCursor::filter(int plan, sqlite3_value** arguments) {
  plan_ = plan;
  join_.reset();
  rows_ = {};
  stored_.clear();
  only_a_.reset();
  only_b_.reset();
  int next_argument = 0;
  for (const int bit : {WatchPlan::by_a, WatchPlan::by_b}) {
    if ((plan & bit) == 0) continue;
    std::optional<std::int64_t>& only = bit == WatchPlan::by_a ? only_a_ : only_b_;
    only = id_of(arguments[next_argument++]);
    if (!only) return;
  }
  Connection& connection = *table_.connection;
  const std::shared_ptr<WatchRows> rows = table_.rows();
  const WatchState state = rows->read_state();
  const OpenTables tables = watched_tables(connection, table_.name.schema, state);
  now_ = state.now();
  if (is_up_to_date(connection, state, tables)) {
    give(kept_pairs(*rows, {}), state, tables);
  } else if (!read_changed(*rows, state, tables)) {
    rows->pair(0, 0);  // throws if the table of pairs is missing
    join_now(state, tables);
  }
}

/// The stored pairs, without those of changed objects.
std::vector<ShownPair> WatchCursor::kept_pairs(WatchRows& rows, const ChangedSides& changed) const {
  const auto one_id = [](const auto& id) {
    return id ? std::span(&*id, 1) : std::span<const std::int64_t>();
  };
  const auto pairs = only_a_   ? rows.stored_pairs_of(one_id(only_a_), {})
                     : only_b_ ? rows.stored_pairs_of({}, one_id(only_b_))
                               : rows.pairs();
  std::vector<ShownPair> kept;
  for (const WatchedPair& pair : pairs)
    if (pair.is_reported() && (!only_b_ || pair.b == *only_b_) && !changed.a.holds(pair.a) &&
        !changed.b.holds(pair.b))
      kept.push_back({pair.a, pair.b, std::max(pair.t, now_)});
  return kept;
}

/// Reads within an open transaction: the stored pairs of unchanged objects, and the current pairs of changed
/// ones. False if the join is cheaper, or if the changes are unknown.
bool WatchCursor::read_changed(WatchRows& rows, const WatchState& state, const OpenTables& tables) {
  if (state.must_rebuild || state.requested_clock || !state.clock) return false;
  const JoinedTables sources = sources_of(*table_.connection, tables);
  const ChangedSides changed = changed_sides(sources, state);
  if (!changed.a.are_known || !changed.b.are_known || is_majority(changed.a, *sources.a)) return false;
  if (is_majority(changed.b, sources.side_b())) return false;
  // For one object, all its pairs are recomputed, however many other objects have changed.
  const bool of_one = only_a_ || only_b_;
  std::vector<ShownPair> pairs = of_one ? std::vector<ShownPair>{} : kept_pairs(rows, changed);
  if (of_one) rows.pair(0, 0);  // throws if the table of pairs is missing
  JoinQuestion question = question_of(sources, state, {now_, state.horizon});
  question.wants.ends = false;
  const JoinResources resources = resources_of(*table_.connection);
  PairSearch search(sources, std::move(question), resources);
  const auto add = [&](const JoinRow& row) { pairs.push_back({row.a, row.b, row.contact.t}); };
  if (of_one) {
    const std::int64_t id = only_a_ ? *only_a_ : *only_b_;
    search.find_pairs_of(only_a_ || !tables.b ? Side::a : Side::b, std::span(&id, 1), add);
  } else {
    search.find_pairs_of(Side::a, changed.a.ids, add);
    if (tables.b) search.find_pairs_of(Side::b, changed.b.ids, add);
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  std::erase_if(pairs, [&](const ShownPair& pair) {
    return (only_a_ && pair.a != *only_a_) || (only_b_ && pair.b != *only_b_);
  });
  give(pairs, state, tables);
  return true;
}

void WatchCursor::give(std::span<const ShownPair> pairs, const WatchState& state, const OpenTables& tables) {
  if (!only_a_ && !only_b_) table_.likely_pairs = std::max(1.0, static_cast<double>(pairs.size()));
  if ((plan_ & (WatchPlan::times | WatchPlan::approach)) != 0) {
    std::vector<PairIds> ids;
    for (const ShownPair& pair : pairs) ids.push_back({pair.a, pair.b});
    const JoinedTables sources = sources_of(*table_.connection, tables);
    JoinQuestion question = question_of(sources, state, {now_, state.horizon});
    question.wants.approach = (plan_ & WatchPlan::approach) != 0;
    stored_ = contacts_of(sources, question, ids, table_.connection->interrupt());
  } else {
    for (const ShownPair& pair : pairs) {
      JoinRow& row = stored_.emplace_back();
      row.a = pair.a;
      row.b = pair.b;
      row.contact.t = pair.t;
    }
  }
  rows_ = stored_;
}

/// After an 'advance' that is not committed yet, or after changes that were not reported to the watch.
void WatchCursor::join_now(const WatchState& state, const OpenTables& tables) {
  Connection& connection = *table_.connection;
  JoinQuestion question = question_of_all(sources_of(connection, tables), state, {state.now(), state.horizon},
                                          resources_of(connection));
  question.only_a = only_a_;
  question.only_b = only_b_;
  question.wants.ends = (plan_ & WatchPlan::times) != 0;
  question.wants.approach = (plan_ & WatchPlan::approach) != 0;
  join_ = std::make_unique<Join>(std::move(question), connection.interrupt());
  rows_ = join_->next();
}

void WatchCursor::next() {
  rows_ = rows_.subspan(1);
  if (rows_.empty() && join_) rows_ = join_->next();
}

void WatchCursor::column(sqlite3_context* context, int column) const {
  const JoinRow& row = rows_.front();
  const ContactTimes& contact = row.contact;
  const ClosestApproach& approach = row.approach;
  if (column == watch_a || column == watch_b)
    return sqlite3_result_int64(context, column == watch_a ? row.a : row.b);
  if (column == watch_pair) return result_key(context, row);
  if (column == watch_command) return sqlite3_result_null(context);
  const double values[] = {contact.t,  contact.t_end, contact.dt, contact.dt_end,
                           approach.t, approach.dt,   approach.d, now_};
  sqlite3_result_double(context, values[column - watch_t]);
}

}  // namespace foresee
