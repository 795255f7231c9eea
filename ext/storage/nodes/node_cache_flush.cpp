// NodeCache: eviction of clean nodes, and writing of dirty nodes, map and root.
#include <algorithm>

#include "base/interrupt_steps.h"
#include "storage/format/inner_node.h"
#include "storage/format/leaf_node.h"
#include "storage/nodes/node_cache.h"

namespace foresee {

// --- memory

void NodeCache::drop_nodes(bool all) {
  drop_unused(all ? use_ + 1 : use_);
  ++use_;
  if (undo_.snapshots() == 0) undo_.drop_stored();
  note_memory();
}

void NodeCache::drop_unused(std::uint64_t before) {
  const bool watched = undo_.snapshots() > 0;
  places_.clear();
  std::erase_if(slots_, [&](const auto& entry) {
    const Slot& slot = entry.second;
    const bool changed = slot.changed == transaction_;
    if (slot.state.dirty || slot.used >= before || (changed && watched)) return false;
    dropped_changed_ |= changed;
    return true;
  });
}

void NodeCache::erase_slot(NodeNumber number) noexcept {
  if (!places_.empty()) places_[static_cast<std::size_t>(number) & (places_.size() - 1)] = {};
  slots_.erase(number);
}

// --- writing

void NodeCache::write(Interrupt& interrupt) {
  write_nodes(Deletions::write);
  if (map_.has_unwritten()) {
    if (map_.stored_is_void()) shadow_rows_->map().erase_all();
    std::vector<IdHashMap::Entry> changes = map_.unwritten();
    Steps step(interrupt);
    std::sort(changes.begin(), changes.end(),
              [&](const IdHashMap::Entry& a, const IdHashMap::Entry& b) { return step(), a.id < b.id; });
    shadow_rows_->write_map(changes);
    map_.written();
    last_block_.reset();
  }
  if (head_.root_dirty) shadow_rows_->write_root(head_.root);
  head_.root_dirty = wrote_early_ = false;
  if (undo_.snapshots() == 0) undo_.drop_stored();
  evict_if_full();
}

void NodeCache::write_packed_map(Interrupt& interrupt) {
  if (!packed_map_->is_complete()) other_objects();
  prepare_early_write();
  map_.void_stored();
  shadow_rows_->map().erase_all();
  packed_map_->for_each_chunk([&](std::span<const IdHashMap::Entry> chunk) {
    interrupt.check();
    shadow_rows_->write_map(chunk);
  });
  filter_.emplace(packed_map_->ids().size());
  for (const std::int64_t id : packed_map_->ids()) filter_->add(id);
  packed_map_ = nullptr;
  map_.written();
  last_block_.reset();
}

void NodeCache::write_nodes(Deletions deletions) {
  const std::vector<NodeNumber> numbers = dirty_numbers();
  wrote_in_change_ |= in_change_ && !numbers.empty();
  for (const NodeNumber number : numbers) {
    Slot& slot = slots_.at(number);
    const Node* node = slot.state.node.get();
    if (!node && deletions == Deletions::defer) continue;
    keep_before_change(number, slot);
    if (node)
      shadow_rows_->write_node(number, node->is_leaf() ? encode_leaf(format_, number, *node)
                                                       : encode_inner(format_, number, *node));
    else
      shadow_rows_->erase_node(number);
    set_dirty(slot, false);
    slot.learned = false;
    if (!slot.state.node) erase_slot(number);
  }
}

}  // namespace foresee
