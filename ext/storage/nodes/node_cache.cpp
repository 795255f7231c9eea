#include "storage/nodes/node_cache.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "storage/format/inner_node.h"
#include "storage/format/leaf_node.h"
#include "storage/rows/store_error.h"

namespace foresee {

void NodeCache::damaged(const std::string& what) const {
  throw StoreError(SQLITE_CORRUPT_VTAB, name_.table + ": " + what);
}

// --- reading

const char* NodeCache::fault(NodeNumber number, std::span<const std::byte> blob) const {
  if (number < 1) return "nodes are numbered from 1";
  if (blob.size() == format_.node_size && blob[NodeFormat::level_at] != std::byte{0})
    return inner_fault(format_, blob, number);
  return leaf_fault(format_, blob, number);
}

NodeNumber NodeCache::find_root() {
  if (head_.root == TreeHead::unknown) {
    const std::optional<std::int64_t> stored = shadow_rows_->read_root();
    if (!stored || *stored < 0) damaged("the root is not a node");
    if (*stored == 0 && !shadow_rows_->map().is_empty()) damaged("there is no root, but the map has objects");
    head_.root = *stored;
  }
  return head_.root;
}

NodeCache::Slot* NodeCache::in_memory(NodeNumber number) {
  if (places_.size() < slots_.size() || places_.empty())
    places_.assign(std::bit_ceil(std::max<std::size_t>(64, 2 * slots_.size())), {});
  auto& [known, slot] = places_[static_cast<std::size_t>(number) & (places_.size() - 1)];
  if (!slot || known != number) {
    const auto found = slots_.find(number);
    if (found == slots_.end()) return nullptr;
    known = number, slot = &found->second;
  }
  return slot->state.node ? slot : nullptr;
}

void NodeCache::evict_if_full() {
  note_memory();
  share_.budget().evict();
}

// Reserves the maximum number of slots early: to rehash a large table later would delay one statement.
NodeCache::Slot& NodeCache::add_slot(NodeNumber number) {
  constexpr std::size_t few = 1024;
  if (slots_.size() == few) slots_.reserve(share_.budget().max_kept() / format_.node_size);
  return slots_[number];
}

/// Null if no such node is stored.
NodeCache::Slot* NodeCache::fetch_if_stored(NodeNumber number) {
  if (Slot* slot = in_memory(number)) {
    slot->used = use_;
    return slot;
  }
  const auto found = slots_.find(number);
  const bool gone = found != slots_.end() && found->second.state.dirty;
  if (!gone) evict_if_full();
  std::shared_ptr<Node> node;
  if (!gone)
    shadow_rows_->read_node(number, [&](std::span<const std::byte> blob) {
      if (const char* what = fault(number, blob))
        damaged("node " + std::to_string(number) + " is damaged: " + what);
      const bool is_leaf = blob[NodeFormat::level_at] == std::byte{0};
      node = std::make_shared<Node>(is_leaf ? decode_leaf(format_, blob) : decode_inner(format_, blob));
    });
  if (!node) return nullptr;
  Slot& slot = add_slot(number);
  slot = {.state = {std::move(node), false}, .used = use_};
  if (!hints_.empty()) learn(number, slot);
  return &slot;
}

NodeCache::Slot& NodeCache::fetch(NodeNumber number) {
  if (Slot* slot = fetch_if_stored(number)) return *slot;
  damaged("node " + std::to_string(number) + " is missing");
}

std::optional<std::shared_ptr<const Node>> NodeCache::dirty_node(NodeNumber number) const {
  if (dirty_ == 0) return std::nullopt;
  const auto found = slots_.find(number);
  if (found == slots_.end() || !found->second.state.dirty) return std::nullopt;
  return found->second.state.node;
}

NodeNumber NodeCache::next_dirty(NodeNumber after, NodeNumber before) {
  if (dirty_ == 0 || before - after <= 1) return 0;
  const std::vector<NodeNumber>& numbers = dirty_numbers();
  const auto next = std::upper_bound(numbers.begin(), numbers.end(), after);
  return next == numbers.end() || *next >= before ? 0 : *next;
}

const std::vector<NodeNumber>& NodeCache::dirty_numbers() {
  if (!dirty_numbers_are_stale_) return dirty_numbers_;
  dirty_numbers_.clear();
  for (const NodeNumber number : changed_)
    if (const auto found = slots_.find(number); found != slots_.end() && found->second.state.dirty)
      dirty_numbers_.push_back(number);
  std::sort(dirty_numbers_.begin(), dirty_numbers_.end());
  dirty_numbers_.erase(std::unique(dirty_numbers_.begin(), dirty_numbers_.end()), dirty_numbers_.end());
  dirty_numbers_are_stale_ = false;
  return dirty_numbers_;
}

// --- changing

void NodeCache::set_dirty(Slot& slot, bool dirty) noexcept {
  dirty_ += static_cast<std::size_t>(dirty) - static_cast<std::size_t>(slot.state.dirty);
  dirty_numbers_are_stale_ |= slot.state.dirty != dirty;
  slot.state.dirty = dirty;
  const bool holds = dirty && slot.state.node;
  dirty_held_ += static_cast<std::size_t>(holds) - static_cast<std::size_t>(slot.holds);
  slot.holds = holds;
}

void NodeCache::note_changed(NodeNumber number, Slot& slot) {
  if (slot.changed == transaction_) return;
  changed_.push_back(number);
  slot.changed = transaction_;
}

void NodeCache::keep_before_change(NodeNumber number, Slot& slot) {
  note_changed(number, slot);
  if (slot.kept_by == newest_keeper_) return;
  if (in_change_ && !wrote_in_change_)
    change_log_.emplace_back(number, slot.state);
  else if (!undo_.none())
    undo_.keep(number, slot.state);
  slot.kept_by = newest_keeper_;
}

NodeCache::Slot& NodeCache::slot_to_replace(NodeNumber number) {
  const auto found = slots_.find(number);
  if (found != slots_.end()) return found->second;
  Slot* stored = undo_.snapshots() > 0 ? fetch_if_stored(number) : nullptr;
  return stored ? *stored : add_slot(number);
}

Node& NodeCache::modify(NodeNumber number) {
  Slot& slot = fetch(number);
  keep_before_change(number, slot);
  std::shared_ptr<Node>& node = slot.state.node;
  if (node.use_count() > 1) {
    if (!spare_) spare_ = std::make_shared<Node>();
    *spare_ = *node;
    node = std::move(spare_);
    spare_.reset();
  }
  set_dirty(slot, true);
  return *node;
}

double* NodeCache::modify_record(NodeNumber leaf, std::size_t place) {
  const auto size = static_cast<std::size_t>(format_.at.size);
  Slot& slot = fetch(leaf);
  const bool record_is_enough = in_change_ && undo_.none() && record_before_.leaf == 0 &&
                                slot.kept_by != newest_keeper_ && slot.state.node.use_count() == 1;
  if (!record_is_enough) return modify(leaf).values.data() + place * size;
  double* record = slot.state.node->values.data() + place * size;
  note_changed(leaf, slot);
  record_before_.values.assign(record, record + size);
  record_before_.leaf = leaf, record_before_.slot = place, record_before_.dirty = slot.state.dirty;
  set_dirty(slot, true);
  return record;
}

NodeNumber NodeCache::reserve(std::size_t count) {
  if (head_.last == TreeHead::unknown)
    head_.last = std::max<std::int64_t>(shadow_rows_->read_largest_node(), 0);
  const auto more = static_cast<NodeNumber>(count);
  if (head_.last > std::numeric_limits<std::int64_t>::max() - more) damaged("there is no node number left");
  const NodeNumber first = head_.last + 1;
  head_.last += more;
  return first;
}

NodeNumber NodeCache::allocate() {
  auto node = std::make_shared<Node>();
  const NodeNumber number = reserve(1);
  Slot& slot = add_slot(number);
  keep_before_change(number, slot);
  slot.state.node = std::move(node);
  slot.learned = false;
  set_dirty(slot, true);
  return number;
}

void NodeCache::put(NodeNumber number, Node node) {
  auto shared = std::make_shared<Node>(std::move(node));
  Slot& slot = slot_to_replace(number);
  keep_before_change(number, slot);
  slot.state.node = std::move(shared);
  slot.learned = false;
  set_dirty(slot, true);
  make_room();
}

void NodeCache::make_room() {
  note_memory();
  if (!share_.budget().too_many_nodes_wait(dirty_held_ * format_.node_size)) return;
  prepare_early_write();
  write_nodes(Deletions::defer);  // a deleted number may be used again
  evict_if_full();
}

void NodeCache::prepare_early_write() {
  hand_change_to_undo_log();
  wrote_in_change_ = in_change_;  // from here on only a rollback can undo it, or one to a savepoint
  change_log_.clear();
  wrote_early_ = true;
}

void NodeCache::free(NodeNumber number) {
  Slot& slot = slot_to_replace(number);
  keep_before_change(number, slot);
  slot.state.node.reset();
  set_dirty(slot, true);
}

// An empty tree numbers its nodes from 1 again.
void NodeCache::set_root(NodeNumber number) {
  head_.root = number;
  head_.root_dirty = true;
  if (number == 0) head_.last = 0;
}

void NodeCache::place(std::span<const std::int64_t> ids, NodeNumber leaf) {
  if (packed_map_ && !packed_map_->place(ids, leaf)) other_objects();
  if (packed_map_) return;
  for (const std::int64_t id : ids) map_.set(id, leaf);
  if (filter_)
    for (const std::int64_t id : ids) filter_->add(id);
}

void NodeCache::other_objects() const {
  throw StoreError(SQLITE_IOERR,
                   name_.table +
                       ": the objects changed while they were read twice: another program writes to "
                       "the database or to the temporary file; roll back");
}

void NodeCache::erase_everything() {
  std::vector<NodeNumber> numbers;
  shadow_rows_->read_node_numbers([&](NodeNumber number) { numbers.push_back(number); });
  for (const auto& [number, slot] : slots_) numbers.push_back(number);
  for (const NodeNumber number : numbers) {
    if (undo_.snapshots() > 0 && !slots_.contains(number)) {
      try {
        fetch(number);
      } catch (const StoreError&) {
        slots_[number];  // damaged: no snapshot can read it
      }
    }
    free(number);
  }
  set_root(0);
  map_.void_stored();
  filter_.reset();
}

}  // namespace foresee
