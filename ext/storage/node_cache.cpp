#include "storage/node_cache.h"

#include <algorithm>
#include <limits>

#include "storage/inner_node.h"
#include "storage/leaf_node.h"
#include "storage/object_store.h"

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

NodeNumber NodeCache::root() {
  if (head_.root == TreeHead::unknown) {
    const std::optional<std::int64_t> stored = rows_->root();
    if (!stored || *stored < 0) damaged("the root is no node");
    head_.root = *stored;
  }
  return head_.root;
}

NodeCache::Slot& NodeCache::fetch(NodeNumber number) {
  auto& [recent_number, recent] = recent_[static_cast<std::size_t>(number) % recent_.size()];
  if (recent && recent_number == number && recent->state.node) {
    recent->used = use_;
    return *recent;
  }
  const auto found = slots_.find(number);
  if (found != slots_.end() && found->second.state.node) {
    recent_number = number, recent = &found->second;
    recent->used = use_;
    return *recent;
  }
  const bool gone = found != slots_.end() && found->second.state.dirty;
  if (!gone) evict();
  std::shared_ptr<Node> node;
  if (!gone)
    rows_->read_node(number, [&](std::span<const std::byte> blob) {
      if (const char* what = fault(number, blob))
        damaged("node " + std::to_string(number) + " is damaged: " + what);
      const bool is_leaf = blob[NodeFormat::level_at] == std::byte{0};
      node = std::make_shared<Node>(is_leaf ? decode_leaf(format_, blob) : decode_inner(format_, blob));
    });
  if (!node) damaged("node " + std::to_string(number) + " is missing");
  Slot& slot = slots_[number];
  slot = {.state = {std::move(node), false}, .used = use_};
  return slot;
}

std::optional<NodeNumber> NodeCache::leaf_of(std::int64_t id) {
  const std::int64_t leaf = map_.find(id);
  if (leaf == MapChanges::erased) return std::nullopt;
  if (leaf != MapChanges::unknown) return leaf;
  if (last_found_ && last_found_->first == id) return last_found_->second;
  const std::optional<std::int64_t> stored = rows_->leaf_of(id);
  if (stored) last_found_ = {id, *stored};
  return stored;
}

std::optional<std::shared_ptr<const Node>> NodeCache::waiting(NodeNumber number) const {
  if (dirty_ == 0) return std::nullopt;
  const auto found = slots_.find(number);
  if (found == slots_.end() || !found->second.state.dirty) return std::nullopt;
  return found->second.state.node;
}

NodeNumber NodeCache::next_waiting(NodeNumber after, NodeNumber before) {
  if (dirty_ == 0 || before - after <= 1) return 0;
  const std::vector<NodeNumber>& waiting = waiting_numbers();
  const auto next = std::upper_bound(waiting.begin(), waiting.end(), after);
  return next == waiting.end() || *next >= before ? 0 : *next;
}

/// Cost: a sort of what has changed in this transaction, once after each change.
const std::vector<NodeNumber>& NodeCache::waiting_numbers() {
  if (!waiting_is_stale_) return waiting_;
  waiting_.clear();
  for (const NodeNumber number : changed_)
    if (const auto found = slots_.find(number); found != slots_.end() && found->second.state.dirty)
      waiting_.push_back(number);
  std::sort(waiting_.begin(), waiting_.end());
  waiting_.erase(std::unique(waiting_.begin(), waiting_.end()), waiting_.end());
  waiting_is_stale_ = false;
  return waiting_;
}

// --- changing

void NodeCache::set_dirty(Slot& slot, bool dirty) noexcept {
  dirty_ += static_cast<std::size_t>(dirty) - static_cast<std::size_t>(slot.state.dirty);
  waiting_is_stale_ |= slot.state.dirty != dirty;
  slot.state.dirty = dirty;
}

// Nothing is lost if this throws.
void NodeCache::about_to_change(NodeNumber number, Slot& slot) {
  if (slot.changed != transaction_) {
    changed_.push_back(number);
    slot.changed = transaction_;
  }
  if (slot.kept == moment_) return;
  if (in_call_)
    call_log_.emplace_back(number, slot.state);
  else if (!marks_.none())
    marks_.keep(number, slot.state);
  slot.kept = moment_;
}

// What a node was matters only to those who read it at an earlier moment.
NodeCache::Slot& NodeCache::overwritten(NodeNumber number) {
  const auto found = slots_.find(number);
  if (found != slots_.end()) return found->second;
  return marks_.snapshots() > 0 ? fetch(number) : slots_[number];
}

Node& NodeCache::modify(NodeNumber number) {
  Slot& slot = fetch(number);
  about_to_change(number, slot);
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

NodeNumber NodeCache::allocate() {
  if (head_.last == TreeHead::unknown) head_.last = std::max<std::int64_t>(rows_->largest_node(), 0);
  if (head_.last == std::numeric_limits<std::int64_t>::max()) damaged("there is no node number left");
  auto node = std::make_shared<Node>();
  const NodeNumber number = head_.last + 1;
  Slot& slot = slots_[number];
  about_to_change(number, slot);
  slot.state.node = std::move(node);
  set_dirty(slot, true);
  return head_.last = number;
}

void NodeCache::put(NodeNumber number, Node node) {
  auto shared = std::make_shared<Node>(std::move(node));
  Slot& slot = overwritten(number);
  about_to_change(number, slot);
  slot.state.node = std::move(shared);
  set_dirty(slot, true);
  if (dirty_ * format_.node_size > limits_.waiting) {
    hand_call_to_marks();
    write_nodes();
    evict();
  }
}

void NodeCache::free(NodeNumber number) {
  Slot& slot = overwritten(number);
  about_to_change(number, slot);
  slot.state.node.reset();
  set_dirty(slot, true);
}

// Numbers begin again when the tree does.
void NodeCache::set_root(NodeNumber number) {
  head_.root = number;
  head_.root_dirty = true;
  if (number == 0) head_.last = 0;
}

void NodeCache::place(std::span<const std::int64_t> ids, NodeNumber leaf) {
  for (const std::int64_t id : ids) map_.set(id, leaf);
}

void NodeCache::erase_everything() {
  std::vector<NodeNumber> numbers;
  rows_->read_node_numbers([&](NodeNumber number) { numbers.push_back(number); });
  for (const auto& [number, slot] : slots_) numbers.push_back(number);
  for (const NodeNumber number : numbers) {
    if (marks_.snapshots() > 0 && !slots_.contains(number)) {
      try {
        fetch(number);
      } catch (const StoreError&) {
        slots_[number];  // a damaged node, which no snapshot can read
      }
    }
    free(number);
  }
  set_root(0);
  map_.void_stored();
}

// --- memory

void NodeCache::evict() {
  const std::size_t most = limits_.memory / format_.node_size;
  if (slots_.size() < std::max(most, evict_at_)) return;
  drop_unused(use_);
  if (slots_.size() > most / 2) drop_unused(use_ + 1);
  ++use_;
  evict_at_ = slots_.size() + most / 8;
  if (marks_.snapshots() == 0) marks_.drop_stored();
}

void NodeCache::drop_unused(std::uint64_t before) {
  const bool watched = marks_.snapshots() > 0;
  forget_recent();
  std::erase_if(slots_, [&](const auto& entry) {
    const Slot& slot = entry.second;
    const bool changed = slot.changed == transaction_;
    if (slot.state.dirty || slot.used >= before || (changed && watched)) return false;
    dropped_changed_ |= changed;
    return true;
  });
}

// --- writing

void NodeCache::write() {
  write_nodes();
  if (map_.waits()) {
    if (map_.stored_is_void()) rows_->erase_map();
    rows_->write_map(map_.sorted());
    map_.written(!marks_.none());
    last_found_.reset();
  }
  if (head_.root_dirty) rows_->write_root(head_.root);
  head_.root_dirty = false;
  if (marks_.snapshots() == 0) marks_.drop_stored();
}

void NodeCache::write_nodes() {
  const std::vector<NodeNumber> numbers = waiting_numbers();
  wrote_in_call_ |= in_call_ && !numbers.empty();
  for (const NodeNumber number : numbers) {
    Slot& slot = slots_.at(number);
    about_to_change(number, slot);
    if (const Node* node = slot.state.node.get())
      rows_->write_node(number, node->is_leaf() ? encode_leaf(format_, number, *node)
                                                : encode_inner(format_, number, *node));
    else
      rows_->erase_node(number);
    set_dirty(slot, false);
    if (slot.state.node) continue;
    forget_recent();
    slots_.erase(number);
  }
}

}  // namespace foresee
