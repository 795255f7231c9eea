// Nodes of a tree in memory, by number, each with what the cache must know about it.
//
//   NodeSlots slots;
//   NodeSlots::Slot& slot = slots.add(7);
//   slot.state.node = node; slots.set_dirty(slot, true);
//   slots.in_memory(7)                     // null: not in memory
//   slots.drop_unused(slots.used(), [](NodeNumber, const NodeSlots::Slot&) { return true; });
//
// References to slots stay valid until the slot is erased.
#pragma once

#include <algorithm>
#include <bit>
#include <utility>
#include <vector>

#include "storage/nodes/node_history.h"

namespace foresee {

/// Direct-mapped table of pointers, by the low bits of a number. It stands before a hash table, whose look-ups miss the
/// processor's caches.
template <class T>
class NumberPlaces {
 public:
  /// The pointer that find(number) has returned, perhaps earlier; null is not kept. `size`: of the hash table.
  template <class Find>
  T* find(std::int64_t number, std::size_t size, Find find) {
    if (places_.size() < size || places_.empty())
      places_.assign(std::bit_ceil(std::max<std::size_t>(64, 2 * size)), {});
    auto& [known, place] = at(number);
    if (place && known == number) return place;
    T* const found = find(number);
    if (found) known = number, place = found;
    return found;
  }
  void forget(std::int64_t number) noexcept {
    if (!places_.empty()) at(number) = {};
  }
  void clear() noexcept { places_.clear(); }

 private:
  std::pair<std::int64_t, T*>& at(std::int64_t number) {
    return places_[static_cast<std::size_t>(number) & (places_.size() - 1)];
  }

  std::vector<std::pair<std::int64_t, T*>> places_;
};

class NodeSlots {
 public:
  struct Slot {
    NodeState state;
    std::uint64_t kept_by = 0;  ///< newest mark for which the history has its old state
    std::uint64_t changed = 0;  ///< last transaction that changed it
    std::uint64_t used = 0;
    bool learned = false;  ///< its objects have hints
    bool holds = false;    ///< dirty and not deleted
  };

  std::size_t size() const { return slots_.size(); }
  /// Dirty nodes, and those of them that are not deleted.
  std::size_t dirty() const { return dirty_; }
  std::size_t dirty_held() const { return dirty_held_; }
  /// Nodes in memory, approximately.
  std::size_t held() const {
    const std::size_t gone = dirty_ - dirty_held_;
    return slots_.size() - std::min(gone, slots_.size());
  }

  /// Null if there is no slot.
  Slot* find(NodeNumber number) {
    const auto found = slots_.find(number);
    return found == slots_.end() ? nullptr : &found->second;
  }
  const Slot* find(NodeNumber number) const { return const_cast<NodeSlots*>(this)->find(number); }
  /// Null if the node is not in memory.
  Slot* in_memory(NodeNumber number) {
    Slot* const slot =
        places_.find(number, slots_.size(), [this](NodeNumber wanted) { return find(wanted); });
    return slot && slot->state.node ? slot : nullptr;
  }
  /// The slot of a node, created if necessary. With many, room for `limit` is reserved: to rehash a large table
  /// later would delay one statement.
  Slot& add(NodeNumber number, std::size_t limit = 0) {
    constexpr std::size_t few = 1024;
    if (slots_.size() == few) slots_.reserve(limit);
    return slots_[number];
  }
  void erase(NodeNumber number) noexcept {
    places_.forget(number);
    slots_.erase(number);
  }
  void set_dirty(Slot& slot, bool dirty) noexcept {
    const bool holds = dirty && slot.state.node;
    turns_ += dirty != slot.state.dirty;
    dirty_ = dirty_ + dirty - slot.state.dirty;
    dirty_held_ = dirty_held_ + holds - slot.holds;
    slot.state.dirty = dirty;
    slot.holds = holds;
  }

  /// Advances whenever a node becomes dirty or clean.
  std::uint64_t turns() const { return turns_; }

  void note_used(Slot& slot) const { slot.used = use_; }
  std::uint64_t used() const { return use_; }
  /// Drops clean nodes that were last used before `before`, if may_go(number, slot); a new period of use starts.
  template <class MayGo>
  void drop_unused(std::uint64_t before, MayGo may_go) {
    places_.clear();
    std::erase_if(slots_, [&](const auto& entry) {
      const Slot& slot = entry.second;
      return !slot.state.dirty && slot.used < before && may_go(entry.first, slot);
    });
    ++use_;
  }
  template <class Each>
  void for_each(Each each) const {
    for (const auto& [number, slot] : slots_) each(number, slot);
  }
  void clear() noexcept {
    slots_.clear();
    places_.clear();
    dirty_ = dirty_held_ = 0;
    ++turns_;
  }

 private:
  std::unordered_map<NodeNumber, Slot> slots_;
  NumberPlaces<Slot> places_;
  std::size_t dirty_ = 0, dirty_held_ = 0;
  std::uint64_t use_ = 1;  ///< advances whenever unused nodes are dropped
  std::uint64_t turns_ = 0;
};

/// The nodes that one transaction has changed.
class ChangedNodes {
 public:
  void add(NodeNumber number, NodeSlots::Slot& slot) {
    if (has(slot)) return;
    numbers_.push_back(number);
    slot.changed = transaction_;
  }
  bool has(const NodeSlots::Slot& slot) const { return slot.changed == transaction_; }
  std::span<const NodeNumber> numbers() const { return numbers_; }  ///< with repetitions
  /// One of them was written and then dropped from memory.
  bool dropped() const { return dropped_; }
  void note_dropped() noexcept { dropped_ = true; }
  /// The dirty ones, ascending. Cost: after each change, a sort of all.
  std::span<const NodeNumber> dirty(const NodeSlots& slots);
  void start_transaction() noexcept {
    ++transaction_;
    numbers_.clear();
    dropped_ = false;
  }

 private:
  std::uint64_t transaction_ = 1;
  std::vector<NodeNumber> numbers_;
  bool dropped_ = false;
  std::vector<NodeNumber> dirty_;
  std::uint64_t sorted_at_ = 0;  ///< turns() of the slots when dirty_ was sorted
};

}  // namespace foresee
