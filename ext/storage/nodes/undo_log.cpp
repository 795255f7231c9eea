#include "storage/nodes/undo_log.h"

#include <iterator>
#include <new>
#include <utility>

namespace foresee {

UndoLog::Handle UndoLog::set(const TreeHead& head, bool is_snapshot) {
  marks_.push_back({.head = head, .is_snapshot = is_snapshot, .before = {}});
  snapshots_ += is_snapshot;
  return std::prev(marks_.end());
}

void UndoLog::give_up(Handle mark) noexcept {
  snapshots_ -= mark->is_snapshot;
  mark->is_snapshot = false;
  mark->given_up = true;
  if (mark != marks_.begin()) {
    const auto older = std::prev(mark);
    if (older->before.size() < mark->before.size()) {
      // The smaller set is merged into the larger one; for a node in both the older state is valid.
      for (auto& [number, state] : older->before)
        if (const auto both = mark->before.find(number); both != mark->before.end())
          std::swap(both->second, state);
      older->before.swap(mark->before);
    }
    try {
      older->before.merge(mark->before);
    } catch (const std::bad_alloc&) {
      return;  // the mark stays, unused
    }
    marks_.erase(mark);
  }
  while (!marks_.empty() && marks_.front().given_up) marks_.pop_front();
}

const NodeState* UndoLog::find(Handle mark, NodeNumber number) const {
  for (auto at = std::list<UndoMark>::const_iterator(mark); at != marks_.end(); ++at)
    if (const auto found = at->before.find(number); found != at->before.end()) return &found->second;
  return nullptr;
}

std::unordered_map<NodeNumber, NodeState> UndoLog::changed_since(Handle mark) const {
  std::unordered_map<NodeNumber, NodeState> all;
  for (auto at = std::list<UndoMark>::const_iterator(mark); at != marks_.end(); ++at)
    all.insert(at->before.begin(), at->before.end());
  return all;
}

bool UndoLog::snapshot_since(Handle mark) const {
  for (auto at = std::list<UndoMark>::const_iterator(mark); at != marks_.end(); ++at)
    if (at->is_snapshot) return true;
  return false;
}

void UndoLog::break_snapshots() noexcept {
  for (UndoMark& mark : marks_) mark.broken |= mark.is_snapshot;
}

void UndoLog::drop_stored() noexcept {
  for (UndoMark& mark : marks_)
    for (auto& [number, state] : mark.before)
      if (!state.dirty) state.node.reset();
}

}  // namespace foresee
