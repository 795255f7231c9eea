// NodeCache: undo of a change, a savepoint or a transaction, and reads of old states.
#include <algorithm>
#include <utility>

#include "storage/nodes/node_cache.h"
#include "storage/rows/store_error.h"

namespace foresee {

// Requires: slots to be restored exist, or their rows are valid.
void NodeCache::restore_node(NodeNumber number, const NodeState& state) noexcept {
  const auto found = slots_.find(number);
  if (found == slots_.end()) return;
  found->second.state.node = state.node;
  set_dirty(found->second, state.dirty);
  found->second.kept_by = 0;
  if (state.node || state.dirty) return;
  erase_slot(number);
}

void NodeCache::begin_change() {
  change_log_.clear();
  record_before_.leaf = 0;
  head_before_change_ = head_;
  in_change_ = true;
  wrote_in_change_ = false;
  ++newest_keeper_;
}

void NodeCache::end_change() {
  if (undo_.none()) {
    if (!change_log_.empty() && change_log_.front().second.node.use_count() == 1)
      spare_ = std::move(change_log_.front().second.node);
  } else {
    hand_change_to_undo_log();
  }
  change_log_.clear();
  record_before_.leaf = 0;
  in_change_ = false;
}

/// Keeps the old states for savepoints and snapshots. Once rows are written only a savepoint can undo the
/// change, and nodes that leave memory cannot be restored from the change's own log.
void NodeCache::hand_change_to_undo_log() {
  if (undo_.none()) return;
  for (const auto& [number, state] : change_log_) undo_.keep(number, state);
}

void NodeCache::cancel_change() noexcept {
  for (auto change = change_log_.rbegin(); change != change_log_.rend(); ++change)
    restore_node(change->first, change->second);
  change_log_.clear();
  restore_record();
  filter_.reset();
  head_ = head_before_change_;
  packed_map_ = nullptr;
  in_change_ = false;
}

/// Call it last: if the leaf was also changed as a whole, that happened later.
void NodeCache::restore_record() noexcept {
  const NodeNumber leaf = std::exchange(record_before_.leaf, 0);
  if (leaf == 0) return;
  const auto found = slots_.find(leaf);
  if (found == slots_.end()) return;
  NodeState& state = found->second.state;
  std::copy(record_before_.values.begin(), record_before_.values.end(),
            state.node->values.begin() +
                static_cast<std::ptrdiff_t>(record_before_.slot * record_before_.values.size()));
  set_dirty(found->second, record_before_.dirty);
}

UndoLog::Handle NodeCache::set_mark(bool is_snapshot) {
  const UndoLog::Handle mark = undo_.set(head_, is_snapshot);
  ++newest_keeper_;
  return mark;
}

std::shared_ptr<const Node> NodeCache::read_at(UndoLog::Handle mark, NodeNumber number) {
  if (mark->broken)
    throw StoreError(SQLITE_ABORT, name_.table + ": a rollback ended this query; run it again");
  const NodeState* before = undo_.find(mark, number);
  if (!before) return read(number);
  if (!before->node) damaged("node " + std::to_string(number) + " is missing");
  return before->node;
}

void NodeCache::restore(UndoLog::Handle mark) {
  const bool watched = undo_.snapshot_since(mark);
  if (watched && dropped_changed_) undo_.break_snapshots();
  const auto wanted = undo_.changed_since(mark);
  changed_.reserve(changed_.size() + wanted.size());
  ++newest_keeper_;
  for (const auto& [number, state] : wanted) {
    const bool as_stored = !state.node && !state.dirty;
    if (!as_stored) slots_[number];
    const auto slot = slots_.find(number);
    if (slot == slots_.end()) continue;
    if (watched) keep_before_change(number, slot->second);
    slot->second.changed = transaction_;
    changed_.push_back(number);
    restore_node(number, state);
  }
  head_ = mark->head;
  last_block_.reset();
  filter_.reset();
}

void NodeCache::forget_all() noexcept {
  slots_.clear();
  places_.clear();
  hints_.clear();
  head_ = {};
  map_.clear();
  last_block_.reset();
  filter_.reset();
  changed_.clear();
  dirty_numbers_.clear();
  dirty_numbers_are_stale_ = wrote_early_ = false;
  dirty_ = dirty_held_ = 0;
  note_memory();
}

void NodeCache::forget_clean() {
  drop_unused(use_ + 1);
  head_.root = TreeHead::unknown;
  last_block_.reset();
  filter_.reset();
}

void NodeCache::begin() {
  ++transaction_;
  changed_.clear();
  dropped_changed_ = false;
  head_.last = TreeHead::unknown;
  last_block_.reset();
}

void NodeCache::commit() noexcept {
  ++transaction_;
  wrote_early_ = false;
  changed_.clear();
  dropped_changed_ = false;
  last_block_.reset();
}

// SQLite has restored the rows already.
void NodeCache::roll_back() noexcept {
  if (undo_.snapshots() > 0) try {
      for (const NodeNumber number : changed_)
        if (const auto slot = slots_.find(number); slot != slots_.end())
          undo_.keep(number, slot->second.state);
    } catch (const std::bad_alloc&) {
      undo_.break_snapshots();
    }
  if (dropped_changed_) {
    undo_.break_snapshots();
    forget_all();
  }
  for (const NodeNumber number : changed_) restore_node(number, {});
  head_ = {};
  filter_.reset();
  commit();
}

}  // namespace foresee
