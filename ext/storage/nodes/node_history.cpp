#include "storage/nodes/node_history.h"

#include <algorithm>

namespace foresee {

void NodeHistory::keep(NodeNumber number, const NodeState& state) {
  std::size_t& newest = newest_[number];
  log_.push_back({number, state, newest});
  newest = end();
}

const NodeState* NodeHistory::find(std::size_t position, NodeNumber number) const {
  const auto newest = newest_.find(number);
  if (newest == newest_.end()) return nullptr;
  const NodeState* found = nullptr;
  for (std::size_t i = newest->second; i > position && i > first_; i = at(i - 1).previous)
    if (!at(i - 1).dropped) found = &at(i - 1).before;
  return found;
}

void NodeHistory::pop_back() noexcept {
  const Entry& last = log_.back();
  if (const auto newest = newest_.find(last.number); last.previous > first_)
    newest->second = last.previous;
  else
    newest_.erase(newest);
  log_.pop_back();
}

// A hash table that was large is replaced: to clear it would cost as much again after every small change.
void NodeHistory::truncate(std::size_t position) noexcept {
  constexpr std::size_t few = 64;
  if (position <= first_ && log_.size() > few) {
    first_ = end();
    log_.clear();
    std::unordered_map<NodeNumber, std::size_t>().swap(newest_);
    return;
  }
  while (end() > position && !log_.empty()) pop_back();
}

// A state at i is needed if the newest mark or snapshot up to i has no older state of the same node.
void NodeHistory::compact(std::size_t position, std::span<const std::size_t> marks) noexcept {
  std::size_t newest = 0;
  const auto for_each_need = [&](auto each) {
    for (const std::size_t mark : marks) each(mark);
    for (const NodeSnapshot& snapshot : snapshots_) each(snapshot.position);
  };
  for_each_need([&](std::size_t mark) { newest = std::max(newest, mark); });
  for (std::size_t i = std::max(position, first_); i < end(); ++i) {
    Entry& entry = at(i);
    bool needed = false;
    std::size_t since = 0;
    for_each_need([&](std::size_t mark) {
      if (mark <= i) {
        needed = true;
        since = std::max(since, mark);
      }
    });
    if (needed && entry.previous <= since) continue;
    entry.dropped = true;
    entry.before.node.reset();
  }
  while (!log_.empty() && log_.back().dropped && end() > newest) pop_back();
  for (; !log_.empty() && log_.front().dropped; ++first_) {
    if (const auto newest = newest_.find(log_.front().number); newest->second == first_ + 1)
      newest_.erase(newest);
    log_.pop_front();
  }
}

void NodeHistory::drop_stored() noexcept {
  for (Entry& entry : log_)
    if (!entry.before.dirty) entry.before.node.reset();
}

}  // namespace foresee
