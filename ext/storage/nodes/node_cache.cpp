#include "storage/nodes/node_cache.h"

#include <algorithm>
#include <limits>

#include "database/sqlite_api.h"
#include "format/inner_node.h"
#include "format/leaf_node.h"

namespace foresee {

// --- reading

const char* NodeCache::fault(NodeNumber number, std::span<const std::byte> blob) const {
  if (number < 1) return "nodes are numbered from 1";
  if (blob.size() == format_.node_size && blob[NodeFormat::level_at] != std::byte{0})
    return inner_fault(format_, blob, number);
  return leaf_fault(format_, blob, number);
}

NodeNumber NodeCache::find_root() {
  if (head_->root == Head::unknown) {
    const std::optional<std::int64_t> stored = rows_->read_root();
    if (!stored || *stored < 0) throw_damaged(name_, "the root is not a node");
    if (*stored == 0 && !rows_->map().is_empty())
      throw_damaged(name_, "there is no root, but the map has objects");
    head_.change().root = *stored;
  }
  return head_->root;
}

/// Null if no such node is stored.
NodeCache::Slot* NodeCache::fetch_if_stored(NodeNumber number) {
  if (Slot* slot = slots_.in_memory(number)) {
    slots_.note_used(*slot);
    return slot;
  }
  const Slot* const deleted = slots_.find(number);
  if (deleted && deleted->state.dirty) return nullptr;
  evict_if_full();
  std::shared_ptr<Node> node;
  rows_->nodes().read_one(number, [&](std::span<const std::byte> blob) {
    if (const char* what = fault(number, blob))
      throw_damaged(name_, "node " + std::to_string(number) + " is damaged: " + what);
    const bool is_leaf = blob[NodeFormat::level_at] == std::byte{0};
    node = std::make_shared<Node>(is_leaf ? decode_leaf(format_, blob) : decode_inner(format_, blob));
  });
  if (!node) return nullptr;
  Slot& slot = add_slot(number);
  slot = {.state = {std::move(node), false}, .used = slots_.used()};
  if (!hints_.empty()) learn(number, slot);
  return &slot;
}

NodeCache::Slot& NodeCache::fetch(NodeNumber number) {
  if (Slot* slot = fetch_if_stored(number)) return *slot;
  throw_damaged(name_, "node " + std::to_string(number) + " is missing");
}

std::optional<std::shared_ptr<const Node>> NodeCache::dirty_node(NodeNumber number) const {
  if (slots_.dirty() == 0) return std::nullopt;
  const Slot* const slot = slots_.find(number);
  return slot && slot->state.dirty ? std::optional(slot->state.node) : std::nullopt;
}

NodeNumber NodeCache::next_dirty(NodeNumber after, NodeNumber before) {
  if (slots_.dirty() == 0 || before - after <= 1) return 0;
  const std::span<const NodeNumber> numbers = changed_.dirty(slots_);
  const auto next = std::upper_bound(numbers.begin(), numbers.end(), after);
  return next == numbers.end() || *next >= before ? 0 : *next;
}

std::span<const NodeNumber> ChangedNodes::dirty(const NodeSlots& slots) {
  if (sorted_at_ == slots.turns()) return dirty_;
  dirty_.clear();
  for (const NodeNumber number : numbers_)
    if (const NodeSlots::Slot* slot = slots.find(number); slot && slot->state.dirty) dirty_.push_back(number);
  std::sort(dirty_.begin(), dirty_.end());
  dirty_.erase(std::unique(dirty_.begin(), dirty_.end()), dirty_.end());
  sorted_at_ = slots.turns();
  return dirty_;
}

// --- changing

void NodeCache::keep_before_change(NodeNumber number, Slot& slot) {
  join();
  changed_.add(number, slot);
  if (slot.kept_by == keeper_) return;
  if (is_marked() || history_.has_snapshots()) history_.keep(number, slot.state);
  slot.kept_by = keeper_;
}

NodeCache::Slot& NodeCache::slot_to_replace(NodeNumber number) {
  if (Slot* slot = slots_.find(number)) return *slot;
  Slot* stored = history_.has_snapshots() ? fetch_if_stored(number) : nullptr;
  return stored ? *stored : add_slot(number);
}

Node& NodeCache::modify(NodeNumber number) {
  Slot& slot = fetch(number);
  keep_before_change(number, slot);
  std::shared_ptr<Node>& node = slot.state.node;
  if (node.use_count() > 1) node = std::make_shared<Node>(*node);
  slots_.set_dirty(slot, true);
  return *node;
}

NodeNumber NodeCache::reserve(std::size_t count) {
  Head& head = head_.change();
  if (head.last == Head::unknown) head.last = std::max<std::int64_t>(rows_->nodes().read_largest(), 0);
  const auto more = static_cast<NodeNumber>(count);
  if (head.last > std::numeric_limits<std::int64_t>::max() - more)
    throw_damaged(name_, "there is no node number left");
  const NodeNumber first = head.last + 1;
  head.last += more;
  return first;
}

void NodeCache::replace(NodeNumber number, Slot& slot, std::shared_ptr<Node> node) {
  keep_before_change(number, slot);
  slot.state.node = std::move(node);
  slot.learned = false;
  slots_.set_dirty(slot, true);
}

NodeNumber NodeCache::allocate() {
  auto node = std::make_shared<Node>();
  const NodeNumber number = reserve(1);
  replace(number, add_slot(number), std::move(node));
  return number;
}

void NodeCache::put(NodeNumber number, Node node) {
  auto shared = std::make_shared<Node>(std::move(node));
  replace(number, slot_to_replace(number), std::move(shared));
  make_room();
}

void NodeCache::free(NodeNumber number) {
  replace(number, slot_to_replace(number), nullptr);
}

// An empty tree numbers its nodes from 1 again.
void NodeCache::set_root(NodeNumber number) {
  Head& head = head_.change();
  head.root = number;
  head.root_dirty = true;
  if (number == 0) head.last = 0;
}

void NodeCache::erase_everything() {
  std::vector<NodeNumber> numbers;
  rows_->nodes().read_numbers([&](NodeNumber number) { numbers.push_back(number); });
  slots_.for_each([&](NodeNumber number, const Slot&) { numbers.push_back(number); });
  for (const NodeNumber number : numbers) {
    if (history_.has_snapshots() && !slots_.find(number)) {
      try {
        fetch(number);
      } catch (const StoreError& error) {
        if (!error.is_damage()) throw;
        slots_.add(number);  // no snapshot can read it
      }
    }
    free(number);
  }
  set_root(0);
  ids_.void_stored();
}

}  // namespace foresee
