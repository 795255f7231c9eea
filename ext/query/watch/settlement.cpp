#include "query/watch/settlement.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

Settlement::Settlement(JoinedTables tables, const WatchState& before, WatchStorage& storage,
                       const JoinResources& resources)
    : tables_(std::move(tables)), storage_(storage), resources_(resources), before_(before), state_(before) {
  state_.stamp = tables_.a->stamp();
  if (tables_.b) state_.other_stamp = tables_.b->stamp();
}

std::optional<WatchState> Settlement::settle(Log log) {
  const bool same_contents = state_.stamp == before_.stamp && state_.other_stamp == before_.other_stamp;
  if (same_contents && !before_.asked && !before_.anew) return std::nullopt;
  logs_ = log == Log::changes;
  changed_ = changes_since(tables_, before_);
  move_clock();
  if (must_recompute())
    recompute();
  else
    apply_changes();
  state_.anew = false;
  if (!logs_) state_.seq = new_.empty() ? 0 : 1;
  if (state_.seq != before_.seq && state_.seq > state_.keep) storage_.trim(state_.seq - state_.keep);
  return state_;
}

// --- recomputation, or update by changes

void Settlement::recompute() {
  if (before_.clock && !before_.anew) adapt_look_ahead();
  extend_look_ahead();
  old_ = storage_.pairs();
  Join join(question_of_all(tables_, state_, queried_horizon(), resources_), resources_.interrupt);
  for (auto rows = join.next(); !rows.empty(); rows = join.next())
    for (const JoinRow& row : rows) take(row);
  write_differences(true);
}

void Settlement::apply_changes() {
  const double known_to = before_.known_to;
  const bool looks_ahead = !(next_above(horizon_end_) <= known_to);
  if (looks_ahead) {
    adapt_look_ahead();
    extend_look_ahead();
  } else {
    // The sum of the clock and this is not below known_to, in spite of rounding.
    const double beyond = next_above(next_above(known_to)) - clock_;
    queried_length_ = std::min(std::max(state_.horizon, beyond), std::numeric_limits<double>::max());
  }
  old_ = storage_.pairs_of(changed_.a.ids, changed_.b.ids);
  query_due_pairs();
  search_changed();
  if (looks_ahead) look_ahead(known_to);
  write_differences(false);
}

/// Reads the due pairs whose objects have not changed, with a contact query for each.
void Settlement::query_due_pairs() {
  std::vector<PairIds> uncertain;
  const auto is_changed = [&](const WatchedPair& pair) {
    return changed_.a.holds(pair.a) || changed_.b.holds(pair.b);
  };
  const auto read_pair = [&](const WatchedPair& pair) {
    if (is_changed(pair)) return;
    old_.push_back(pair);
    uncertain.push_back({pair.a, pair.b});
  };
  for (const WatchedPair& pair : storage_.due_pairs(PairState::held, clock_)) read_pair(pair);
  for (const WatchedPair& pair : storage_.due_pairs(PairState::waiting, horizon_end_)) read_pair(pair);
  const JoinQuestion question = question_of(tables_, state_, queried_horizon());
  for (const JoinRow& row : contacts_of(tables_, question, uncertain, resources_.interrupt)) take(row);
}

void Settlement::search_changed() {
  if (changed_.a.ids.empty() && changed_.b.ids.empty()) return;
  PairSearch search(tables_, question_of(tables_, state_, queried_horizon()), resources_);
  const auto take_row = [&](const JoinRow& row) { take(row); };
  search.pairs_of(Side::a, changed_.a.ids, take_row);
  if (tables_.b) search.pairs_of(Side::b, changed_.b.ids, take_row);
}

/// Adds the contacts that start at or after `from`, and those whose end is within reach only now.
void Settlement::look_ahead(double from) {
  const std::size_t first = new_.size();
  const double ends_from = ends_known_to(before_), ends_to = ends_known_to(state_);
  Join join(question_of_all(tables_, state_, queried_horizon(), resources_), resources_.interrupt);
  for (auto rows = join.next(); !rows.empty(); rows = join.next())
    for (const JoinRow& row : rows) {
      const double end = row.contact.t_end;
      if (row.contact.t >= from || (end >= ends_from && end <= ends_to)) take(row);
    }
  std::sort(new_.begin() + static_cast<std::ptrdiff_t>(first), new_.end(), by_ids);  // as the rows are
  for (std::size_t i = first; i < new_.size(); ++i)
    if (const auto known = storage_.pair(new_[i].a, new_[i].b)) old_.push_back(*known);
}

// --- the difference

// Ends beyond queried_horizon() are clipped to it. A contact that lasts beyond ends_known_to() is never due: the next
// look-ahead finds its end.
void Settlement::take(const JoinRow& found) {
  const double t = found.contact.t, t_end = found.contact.t_end;
  const bool none_waits = queried_length_ == state_.horizon;  // nothing beyond the horizon was searched
  new_.push_back({.a = found.a,
                  .b = found.b,
                  .t = t,
                  .due = t_end > ends_known_to(state_) ? never_due : t_end,
                  .told = t,
                  .held = t < horizon_end_ || none_waits});
}

// A start below or above the rounded end of the horizon decides. An equal one does not: then a contact query
// over the exact horizon decides.
void Settlement::decide_which_wait() {
  std::vector<PairIds> ties, held;
  for (const WatchedPair& pair : new_)
    if (!pair.held && pair.t == horizon_end_) ties.push_back({pair.a, pair.b});
  if (!ties.empty()) {
    const JoinQuestion exactly = question_of(tables_, state_, {clock_, state_.horizon});
    for (const JoinRow& row : contacts_of(tables_, exactly, ties, resources_.interrupt))
      held.push_back({row.a, row.b});
  }
  std::sort(held.begin(), held.end());
  for (WatchedPair& pair : new_) {
    if (!pair.held && pair.t == horizon_end_)
      pair.held = std::binary_search(held.begin(), held.end(), PairIds{pair.a, pair.b});
    if (!pair.held) pair.due = pair.t;
  }
}

void Settlement::for_each_difference(const std::function<void(const WatchedPair*, const WatchedPair*)>& use) {
  auto before = old_.begin();
  for (const WatchedPair& after : new_) {
    for (; before != old_.end() && by_ids(*before, after); ++before) use(&*before, nullptr);
    const bool known = before != old_.end() && same_ids(*before, after);
    use(known ? &*before : nullptr, &after);
    if (known) ++before;
  }
  for (; before != old_.end(); ++before) use(&*before, nullptr);
}

void Settlement::write_differences(bool all_are_known) {
  decide_which_wait();
  sort_and_unique(old_), sort_and_unique(new_);
  if (all_are_known && (before_.anew || differ_mostly())) {
    replaces_ = has_written_ = true;
    storage_.erase_all_pairs();
  }
  for_each_difference(
      [&](const WatchedPair* before, const WatchedPair* after) { write_difference(before, after); });
  storage_.write_keys();
}

bool Settlement::differ_mostly() {
  std::size_t kept = 0;
  for_each_difference([&](const WatchedPair* before, const WatchedPair* after) {
    const PairChange change = change_between(before, after, watch_clock());
    kept += !change.writes && !change.erases;
  });
  return old_.size() + new_.size() > 4 * kept;
}

void Settlement::write_difference(const WatchedPair* before, const WatchedPair* after) {
  const WatchClock clock = watch_clock();
  const PairChange change = change_between(before, after, clock);
  const WatchedPair& row = change.row;
  const auto waits = [](const WatchedPair* pair) { return pair && !pair->held; };
  state_.waited += waits(after) && !waits(before);
  state_.dropped += waits(before) && !after;
  has_written_ |= change.erases || change.writes || change.op;
  const bool with_told = state_.tolerance > 0;
  if (replaces_) {
    if (!change.erases) storage_.write_pair(nullptr, change.writes ? row : *before, with_told);
  } else if (change.erases) {
    storage_.erase_pair(row);
  } else if (change.writes) {
    storage_.write_pair(before, row, with_told);
  }
  if (change.op && logs_)
    storage_.append({++state_.seq, change.op, row.a, row.b, clock.shown(row.t), clock_});
}

}  // namespace foresee
