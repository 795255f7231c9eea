// NodeCache: look-up of the leaf and the record of an object, by hints in memory, else by the stored map.
#include <algorithm>
#include <array>

#include "base/interrupt_steps.h"
#include "storage/nodes/node_cache.h"

namespace foresee {

void NodeCache::learn(NodeNumber number, Slot& slot) {
  if (slot.learned || !slot.state.node->is_leaf()) return;
  hints_.reserve(2 * slots_.size() * format_.leaf_capacity);
  hints_.learn(slot.state.node->keys, number);
  slot.learned = true;
}

std::optional<NodeNumber> NodeCache::find_leaf(std::int64_t id) {
  const std::int64_t leaf = ids_.find_unwritten(id);
  if (leaf == IdMap::erased) return std::nullopt;
  if (leaf != IdMap::unknown) return leaf;
  if (!ids_.may_be_stored(id)) return std::nullopt;
  const bool is_new_block = !ids_.has_block(id);
  if (is_new_block)
    if (const Place place = find_by_hint(id); place.leaf != 0) return place.leaf;
  const IdBlock& block = ids_.block(id);
  if (is_new_block) {
    hints_.reserve(static_cast<std::size_t>(IdBlock::ids));
    block.for_each([&](std::int64_t other, std::int64_t its) {
      if (hints_.find(other).leaf != its) hints_.learn(other, its);
    });
  }
  const NodeNumber found = block.leaf_of(id);
  if (found == 0) return std::nullopt;
  if (Slot* slot = slots_.in_memory(found)) learn(found, *slot);
  return found;
}

NodeNumber NodeCache::known_leaf(std::int64_t id) {
  if (trusted_.pending && trusted_.writes == ids_.writes())
    if (const NodeNumber leaf = trusted_.pending->leaf_of(id); leaf != 0) return leaf;
  return find_by_hint(id).leaf;
}

std::vector<NodeNumber> NodeCache::leaves_of(std::span<const std::int64_t> ids, Interrupt& interrupt) {
  Steps step(interrupt);
  std::vector<NodeNumber> leaves(ids.size());
  std::vector<std::uint32_t> others;
  for (std::uint32_t i = 0; i < ids.size(); ++i) {
    step();
    if (ids_.find_unwritten(ids[i]) == IdMap::unknown) leaves[i] = known_leaf(ids[i]);
    if (leaves[i] == 0) others.push_back(i);
  }
  std::sort(others.begin(), others.end(), [&](std::uint32_t a, std::uint32_t b) {
    step();
    return ids[a] < ids[b];
  });
  for (const std::uint32_t i : others) {
    step();
    leaves[i] = find_leaf(ids[i]).value_or(0);
  }
  return leaves;
}

NodeCache::Place NodeCache::find_by_hint(std::int64_t id) {
  const LeafHints::Hint hint = hints_.find(id);
  if (hint.leaf == 0) return {};
  Slot* slot = slots_.in_memory(hint.leaf);
  if (!slot || !slot->state.node->is_leaf()) return {};
  const std::vector<std::int64_t>& ids = slot->state.node->keys;
  const std::size_t record = hint.slot_in(ids, id);
  return record < ids.size() ? Place{hint.leaf, slot, record} : Place{};
}

const double* NodeCache::record_at(const Place& place) {
  if (place.leaf == 0) return nullptr;
  slots_.note_used(*place.slot);
  return place.slot->state.node->values.data() + place.record * static_cast<std::size_t>(format_.at.size);
}

// A leaf in memory is up to date, and the hint is checked there. If the object has moved in this transaction,
// its old leaf may be out of date.
NodeCache::Place NodeCache::find_in_memory(std::int64_t id) {
  return ids_.find_unwritten(id) == IdMap::unknown ? find_by_hint(id) : Place{};
}

// Consecutive ids are spread over memory: hint, slot, node and record are each a dependent cache miss. Many
// ids advance one step at a time, so that their cache misses overlap.
void NodeCache::fetch_ahead(std::int64_t first, std::int64_t many) {
  constexpr std::int64_t limit = 16;
  std::array<LeafHints::Hint, limit> hints;
  std::array<const Slot*, limit> slots;
  const auto count = static_cast<std::size_t>(std::min(many, limit));
  for (std::size_t i = 0; i < count; ++i) hints[i] = hints_.find(first + static_cast<std::int64_t>(i));
  for (std::size_t i = 0; i < count; ++i)
    slots[i] = hints[i].leaf == 0 ? nullptr : slots_.in_memory(hints[i].leaf);
  for (std::size_t i = 0; i < count; ++i) {
    if (!slots[i]) continue;
    const Node& node = *slots[i]->state.node;
    if (!node.is_leaf() || hints[i].slot >= node.size()) continue;
    const double* record = node.values.data() + hints[i].slot * static_cast<std::size_t>(format_.at.size);
    __builtin_prefetch(node.keys.data() + hints[i].slot);
    __builtin_prefetch(record);
    __builtin_prefetch(record + format_.at.size - 1);
  }
}

NodeCache::Place NodeCache::find_place(std::int64_t id) {
  if (const Place place = find_in_memory(id); place.leaf != 0) return place;
  const std::optional<NodeNumber> number = find_leaf(id);
  if (!number) return {};
  const auto where = [&] { return "node " + std::to_string(*number); };
  Slot* slot = fetch_if_stored(*number);
  if (!slot) throw_damaged(name_, where() + " of object " + std::to_string(id) + " is missing");
  const std::vector<std::int64_t>& ids = slot->state.node->keys;
  const auto found = std::find(ids.begin(), ids.end(), id);
  if (found == ids.end() || !slot->state.node->is_leaf())
    throw_damaged(name_, where() + " lacks object " + std::to_string(id));
  const Place place{*number, slot, static_cast<std::size_t>(found - ids.begin())};
  if (!hints_.empty()) hints_.learn(id, place.leaf, place.record);
  return place;
}

}  // namespace foresee
