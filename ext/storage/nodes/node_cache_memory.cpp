// NodeCache: eviction of clean nodes, writing of dirty nodes, rollbacks and snapshots.
#include <new>

#include "database/sqlite_api.h"
#include "format/inner_node.h"
#include "format/leaf_node.h"
#include "storage/nodes/node_cache.h"

namespace foresee {

// --- memory

void NodeCache::evict_if_full() {
  note_memory();
  share_.budget().evict();
}

void NodeCache::drop_nodes(bool all) {
  drop_unused(all ? slots_.used() + 1 : slots_.used());
  if (!history_.has_snapshots()) history_.drop_stored();
  note_memory();
}

void NodeCache::drop_unused(std::uint64_t before) {
  slots_.drop_unused(before, [&](NodeNumber, const Slot& slot) {
    if (!changed_.has(slot)) return true;
    if (history_.has_snapshots()) return false;
    changed_.note_dropped();
    return true;
  });
}

void NodeCache::make_room() {
  note_memory();
  if (!share_.budget().too_many_nodes_wait(slots_.dirty_held() * format_.node_size)) return;
  prepare_early_write();
  write_nodes(Deletions::defer);  // a deleted number may be used again
  if (!history_.has_snapshots()) history_.drop_stored();
  evict_if_full();
}

void NodeCache::forget_all() {
  slots_.clear();
  changed_.start_transaction();
  hints_.clear();
  head_.change() = {};
  ids_.clear();
  ids_.forget_stored();
  note_memory();
}

void NodeCache::forget_clean() {
  drop_unused(slots_.used() + 1);
  head_.change().root = Head::unknown;
  ids_.forget_stored();
}

// --- writing

void NodeCache::write(Interrupt& interrupt) {
  write_nodes(Deletions::write);
  ids_.write(interrupt);
  if (head_->root_dirty) rows_->write_root(head_->root);
  Head& head = head_.change();
  head.root_dirty = head.wrote_early = false;
  if (!history_.has_snapshots()) history_.drop_stored();
  evict_if_full();
}

void NodeCache::write_nodes(Deletions deletions) {
  const std::span<const NodeNumber> dirty = changed_.dirty(slots_);
  const std::vector<NodeNumber> numbers(dirty.begin(), dirty.end());
  const std::size_t kept_before = history_.end();
  for (const NodeNumber number : numbers) {
    Slot& slot = *slots_.find(number);
    const Node* node = slot.state.node.get();
    if (!node && deletions == Deletions::defer) continue;
    keep_before_change(number, slot);
    if (node)
      rows_->nodes().write(number, node->is_leaf() ? encode_leaf(format_, number, *node)
                                                   : encode_inner(format_, number, *node));
    else
      rows_->nodes().erase(number, number);
    slots_.set_dirty(slot, false);
    slot.learned = false;
    if (!node) slots_.erase(number);
  }
  compact(kept_before);  // a long statement writes a node many times, and needs its first state alone
}

// Places that wait take more memory and time than those in the list.
void NodeCache::finish_placing(Interrupt& interrupt) {
  if (!is_marked()) return write_places({}, interrupt);
  const std::size_t places = ids_.listed() * IdMap::bytes_per_change;
  const std::size_t nodes = slots_.dirty_held() * format_.node_size;
  if (share_.budget().too_much_would_wait(nodes + places)) return write_places({}, interrupt);
  ids_.keep_list(interrupt);
}

void NodeCache::write_places(const std::optional<IdSum>& expected, Interrupt& interrupt) {
  prepare_early_write();
  ids_.write_list(expected, interrupt);
}

void NodeCache::prepare_early_write() {
  abandon_newest_mark();
  head_.change().wrote_early = true;
}

// --- rollbacks

void NodeCache::restore_node(NodeNumber number, const NodeState& state) noexcept {
  Slot* const slot = slots_.find(number);
  if (!slot) return;
  slot->state.node = state.node;
  slots_.set_dirty(*slot, state.dirty);
  slot->kept_by = 0;
  if (!state.node && !state.dirty) slots_.erase(number);
}

// Snapshots newer than the mark still need the nodes as they are now. A node whose row is valid again needs no slot.
void NodeCache::rewind(std::size_t position) {
  const std::size_t end = history_.end();
  const bool watched = history_.has_snapshot_since(position);
  if (watched && changed_.dropped()) history_.break_snapshots();
  ++keeper_;
  if (watched)
    history_.for_each_back(position, end, [&](NodeNumber number, const NodeState&) {
      Slot* const slot = slots_.find(number);
      if (!slot || slot->kept_by == keeper_) return;
      history_.keep(number, slot->state);
      slot->kept_by = keeper_;
    });
  history_.for_each_back(position, end, [&](NodeNumber number, const NodeState& state) {
    if (state.node || state.dirty) changed_.add(number, slots_.add(number));
    restore_node(number, state);
  });
  if (!watched) history_.truncate(position);
}

void NodeCache::compact(std::size_t position) noexcept try {
  std::vector<std::size_t> marks;
  for_each_position([&](std::size_t mark) { marks.push_back(mark); });
  history_.compact(position, marks);
} catch (const std::bad_alloc&) {
  // Without memory for the list the states stay, which is also correct.
}

void NodeCache::forget() noexcept {
  if (history_.has_snapshots()) return compact(0);
  history_.clear();
}

// Rolled back: SQLite has restored the rows already. Snapshots keep what they saw.
void NodeCache::end(Journal::Ended how) noexcept {
  if (how == Journal::Ended::rolled_back) {
    if (history_.has_snapshots()) try {
        for (const NodeNumber number : changed_.numbers())
          if (const Slot* slot = slots_.find(number)) history_.keep(number, slot->state);
      } catch (const std::bad_alloc&) {
        history_.break_snapshots();
      }
    for (const NodeNumber number : changed_.numbers()) restore_node(number, {});
    if (changed_.dropped()) {
      history_.break_snapshots();
      forget_all();
    }
  }
  changed_.start_transaction();
  head_.change().last = Head::unknown;
  forget();
}

// --- snapshots

NodeHistory::Snapshot NodeCache::take_snapshot() {
  const NodeHistory::Snapshot snapshot = history_.take_snapshot();
  ++keeper_;
  return snapshot;
}

void NodeCache::give_up(NodeHistory::Snapshot snapshot) noexcept {
  const std::size_t position = snapshot->position;
  history_.give_up(snapshot);
  compact(position);
}

std::shared_ptr<const Node> NodeCache::read_at(NodeHistory::Snapshot snapshot, NodeNumber number) {
  if (snapshot->broken)
    throw StoreError(SQLITE_ABORT, name_.table + ": a rollback ended this query; run it again");
  const NodeState* before = history_.find(snapshot->position, number);
  if (!before) return read(number);
  if (!before->node) throw_damaged(name_, "node " + std::to_string(number) + " is missing");
  return before->node;
}

}  // namespace foresee
