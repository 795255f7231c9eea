#include "query/watch/memory_watch.h"

#include <algorithm>
#include <limits>

namespace foresee {
namespace {

constexpr std::int64_t first_id = std::numeric_limits<std::int64_t>::min();

}  // namespace

std::vector<WatchedPair> MemoryWatch::pairs() {
  std::vector<WatchedPair> all;
  all.reserve(rows_.size());
  for (const auto& [ids, row] : rows_) all.push_back(row);
  return all;
}

std::vector<WatchedPair> MemoryWatch::stored_pairs_of(std::span<const std::int64_t> a,
                                                      std::span<const std::int64_t> b) {
  std::vector<WatchedPair> found;
  for (const std::int64_t id : a)
    for (auto row = rows_.lower_bound({id, first_id}); row != rows_.end() && row->first.first == id; ++row)
      found.push_back(row->second);
  for (const std::int64_t id : b)
    for (auto key = by_b_.lower_bound({id, first_id}); key != by_b_.end() && key->first == id; ++key)
      if (!std::binary_search(a.begin(), a.end(), key->second))
        found.push_back(rows_.at({key->second, key->first}));
  return found;
}

std::vector<WatchedPair> MemoryWatch::due_pairs(PairState state, double until) {
  constexpr double first_time = -std::numeric_limits<double>::infinity();
  std::vector<WatchedPair> found;
  for (auto due = by_due_.lower_bound({state, first_time, {first_id, first_id}}); due != by_due_.end();
       ++due) {
    if (std::get<0>(*due) != state || !(std::get<1>(*due) <= until)) break;
    found.push_back(rows_.at(std::get<2>(*due)));
  }
  return found;
}

std::optional<WatchedPair> MemoryWatch::pair(std::int64_t a, std::int64_t b) {
  const auto found = rows_.find({a, b});
  return found == rows_.end() ? std::nullopt : std::optional(found->second);
}

void MemoryWatch::write_pair(const WatchedPair* /*before*/, const WatchedPair& pair, bool with_reported_t) {
  const auto [row, is_new] = rows_.try_emplace({pair.a, pair.b}, pair);
  if (is_new)
    by_b_.insert({pair.b, pair.a});
  else
    by_due_.erase(due_of(row->second));
  row->second = pair;
  if (!with_reported_t) row->second.reported_t = pair.t;
  by_due_.insert(due_of(pair));
}

void MemoryWatch::erase_pair(const WatchedPair& pair) {
  const auto row = rows_.find({pair.a, pair.b});
  if (row == rows_.end()) return;
  by_due_.erase(due_of(row->second));
  by_b_.erase({pair.b, pair.a});
  rows_.erase(row);
}

void MemoryWatch::erase_all_pairs() {
  rows_.clear();
  by_b_.clear();
  by_due_.clear();
}

void MemoryWatch::trim(std::int64_t up_to) {
  while (!log_.empty() && log_.front().seq <= up_to) log_.pop_front();
}

}  // namespace foresee
