#include "query/watch/pair_update.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "query/input_checks.h"
#include "query/join/join.h"
#include "query/watch/pair_contacts.h"

namespace foresee {
namespace {

bool by_ids(const WatchedPair& x, const WatchedPair& y) {
  return x.a != y.a ? x.a < y.a : x.b < y.b;
}

bool same_ids(const WatchedPair& x, const WatchedPair& y) {
  return x.a == y.a && x.b == y.b;
}

void sort_and_unique(std::vector<WatchedPair>& pairs) {
  std::sort(pairs.begin(), pairs.end(), by_ids);
  pairs.erase(std::unique(pairs.begin(), pairs.end(), same_ids), pairs.end());
}

}  // namespace

PairUpdate::PairUpdate(JoinedTables tables, const WatchState& before, WatchStorage& storage,
                       const JoinResources& resources)
    : tables_(std::move(tables)), storage_(storage), resources_(resources), before_(before), state_(before) {
  require_set(tables_.a != nullptr, "a watch has no table a", "JoinedTables::a");
  state_.stamp = tables_.a->stamp();
  if (tables_.b) state_.other_stamp = tables_.b->stamp();
}

std::optional<WatchState> PairUpdate::run(Log log) {
  const bool same_contents = state_.stamp == before_.stamp && state_.other_stamp == before_.other_stamp;
  if (same_contents && !before_.requested_clock && !before_.must_rebuild) return std::nullopt;
  logs_ = log == Log::changes;
  changed_ = changed_sides(tables_, before_);
  move_clock();
  if (must_recompute())
    recompute();
  else
    apply_changes();
  state_.must_rebuild = false;
  if (!logs_) state_.seq = new_.empty() ? 0 : 1;
  if (state_.seq != before_.seq && state_.seq > state_.keep) storage_.trim(state_.seq - state_.keep);
  return state_;
}

// --- recomputation, or update by changes

void PairUpdate::recompute() {
  if (before_.clock && !before_.must_rebuild) adapt_look_ahead();
  extend_look_ahead();
  old_ = storage_.pairs();
  Join join(question_of_all(tables_, state_, queried_horizon(), resources_), resources_.interrupt);
  for (auto rows = join.next(); !rows.empty(); rows = join.next())
    for (const JoinRow& row : rows) add_found(row);
  write_differences(true);
}

void PairUpdate::apply_changes() {
  const double known_to = before_.known_to;
  const bool looks_ahead = must_look_ahead();
  if (looks_ahead) {
    adapt_look_ahead();
    extend_look_ahead();
  } else {
    // The queries must find every contact that starts up to known_to, since the stored pairs do. Two doubles more make
    // the sum of the clock and this length reach known_to in spite of rounding. A horizon is finite.
    const double beyond = next_above(next_above(known_to)) - clock_;
    queried_length_ = std::min(std::max(state_.horizon, beyond), std::numeric_limits<double>::max());
  }
  old_ = storage_.stored_pairs_of(changed_.a.ids, changed_.b.ids);
  query_due_pairs();
  search_changed();
  if (looks_ahead) look_ahead(known_to);
  write_differences(false);
}

/// Reads the due pairs whose objects have not changed, with a contact query for each.
void PairUpdate::query_due_pairs() {
  std::vector<PairIds> due;
  const auto is_changed = [&](const WatchedPair& pair) {
    return changed_.a.holds(pair.a) || changed_.b.holds(pair.b);
  };
  const auto read_pair = [&](const WatchedPair& pair) {
    if (is_changed(pair)) return;
    old_.push_back(pair);
    due.push_back({pair.a, pair.b});
  };
  for (const WatchedPair& pair : storage_.due_pairs(PairState::reported, clock_)) read_pair(pair);
  for (const WatchedPair& pair : storage_.due_pairs(PairState::waiting, horizon_end_)) read_pair(pair);
  const JoinQuestion question = question_of(tables_, state_, queried_horizon());
  for (const JoinRow& row : contacts_of(tables_, question, due, resources_.interrupt)) add_found(row);
}

void PairUpdate::search_changed() {
  if (changed_.a.ids.empty() && changed_.b.ids.empty()) return;
  PairSearch search(tables_, question_of(tables_, state_, queried_horizon()), resources_);
  const auto add = [&](const JoinRow& row) { add_found(row); };
  search.find_pairs_of(Side::a, changed_.a.ids, add);
  if (tables_.b) search.find_pairs_of(Side::b, changed_.b.ids, add);
}

/// Adds the contacts that start at or after `from`, and those whose end is within reach only now.
void PairUpdate::look_ahead(double from) {
  const std::size_t first = new_.size();
  const double ends_from = ends_known_to(before_), ends_to = ends_known_to(state_);
  Join join(question_of_all(tables_, state_, queried_horizon(), resources_), resources_.interrupt);
  for (auto rows = join.next(); !rows.empty(); rows = join.next())
    for (const JoinRow& row : rows) {
      const double end = row.contact.t_end;
      if (row.contact.t >= from || (end >= ends_from && end <= ends_to)) add_found(row);
    }
  std::sort(new_.begin() + static_cast<std::ptrdiff_t>(first), new_.end(), by_ids);  // as the rows are
  for (std::size_t i = first; i < new_.size(); ++i)
    if (const auto known = storage_.pair(new_[i].a, new_[i].b)) old_.push_back(*known);
}

// --- the difference

// Ends beyond queried_horizon() are clipped to it. A contact that lasts beyond ends_known_to() is never due: the next
// look-ahead finds its end.
void PairUpdate::add_found(const JoinRow& found) {
  const double t = found.contact.t, t_end = found.contact.t_end;
  const bool none_waits = queried_length_ == state_.horizon;  // nothing beyond the horizon was searched
  new_.push_back({.a = found.a,
                  .b = found.b,
                  .t = t,
                  .due = t_end > ends_known_to(state_) ? never_due : t_end,
                  .reported_t = t,
                  .state = t < horizon_end_ || none_waits ? PairState::reported : PairState::waiting});
}

// A start below or above the rounded end of the horizon decides. An equal one does not: then a contact query
// over the exact horizon decides.
void PairUpdate::finish_new_pairs() {
  const auto is_tie = [&](const WatchedPair& pair) { return !pair.is_reported() && pair.t == horizon_end_; };
  std::vector<PairIds> ties, reported;
  for (const WatchedPair& pair : new_)
    if (is_tie(pair)) ties.push_back({pair.a, pair.b});
  if (!ties.empty()) {
    const JoinQuestion exactly = question_of(tables_, state_, {clock_, state_.horizon});
    for (const JoinRow& row : contacts_of(tables_, exactly, ties, resources_.interrupt))
      reported.push_back({row.a, row.b});
  }
  std::sort(reported.begin(), reported.end());
  for (WatchedPair& pair : new_) {
    if (is_tie(pair) && std::binary_search(reported.begin(), reported.end(), PairIds{pair.a, pair.b}))
      pair.state = PairState::reported;
    if (!pair.is_reported()) pair.due = pair.t;
  }
}

void PairUpdate::for_each_pair(const std::function<void(const WatchedPair*, const WatchedPair*)>& use) {
  auto before = old_.begin();
  for (const WatchedPair& after : new_) {
    for (; before != old_.end() && by_ids(*before, after); ++before) use(&*before, nullptr);
    const bool known = before != old_.end() && same_ids(*before, after);
    use(known ? &*before : nullptr, &after);
    if (known) ++before;
  }
  for (; before != old_.end(); ++before) use(&*before, nullptr);
}

void PairUpdate::write_differences(bool all_are_known) {
  finish_new_pairs();
  sort_and_unique(old_);
  sort_and_unique(new_);
  if (all_are_known && (before_.must_rebuild || differ_mostly())) {
    replaces_ = true;
    has_written_ = true;
    storage_.erase_all_pairs();
  }
  for_each_pair(
      [&](const WatchedPair* before, const WatchedPair* after) { write_if_different(before, after); });
  storage_.write_keys();
}

bool PairUpdate::differ_mostly() {
  std::size_t kept = 0;
  for_each_pair([&](const WatchedPair* before, const WatchedPair* after) {
    const PairChange change = change_between(before, after, watch_clock());
    if (!change.writes && !change.erases) ++kept;
  });
  return old_.size() + new_.size() > 4 * kept;
}

void PairUpdate::write_if_different(const WatchedPair* before, const WatchedPair* after) {
  const WatchClock clock = watch_clock();
  const PairChange change = change_between(before, after, clock);
  count_waiting(before, after);
  has_written_ |= change.erases || change.writes || change.op;
  write_row_of(change, before);
  const WatchedPair& row = change.row;
  if (change.op && logs_)
    storage_.append({++state_.seq, change.op, row.a, row.b, clock.shown(row.t), clock_});
}

void PairUpdate::count_waiting(const WatchedPair* before, const WatchedPair* after) {
  const auto waits = [](const WatchedPair* pair) { return pair && !pair->is_reported(); };
  if (waits(after) && !waits(before)) ++state_.found_waiting;
  if (waits(before) && !after) ++state_.dropped_waiting;
}

void PairUpdate::write_row_of(const PairChange& change, const WatchedPair* before) {
  const bool with_reported_t = state_.tolerance > 0;
  if (replaces_) {
    if (!change.erases) storage_.write_pair(nullptr, change.writes ? change.row : *before, with_reported_t);
  } else if (change.erases) {
    storage_.erase_pair(change.row);
  } else if (change.writes) {
    storage_.write_pair(before, change.row, with_reported_t);
  }
}

}  // namespace foresee
