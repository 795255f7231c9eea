// Log of the states of tree nodes before their changes, for rollbacks and for snapshots of queries.
//
//   const std::size_t position = history.end();     // a mark: copies nothing
//   history.keep(7, state);                         // before node 7 changes
//   history.find(position, 7)                       // node 7 as of that position; null: unchanged since
//
// Each entry refers to the one before it of the same node, so the state at a position is the oldest entry of the
// node from there on. A state that no mark and no snapshot needs, because one of them has an older one, is dropped
// by compact(). So the log costs what has changed since the oldest mark. Cost: a hash entry and about 50 bytes per
// kept state; a node is shared, not copied.
#pragma once

#include <cstdint>
#include <deque>
#include <list>
#include <memory>
#include <span>
#include <unordered_map>

#include "index/pages.h"

namespace foresee {

/// State of a node in memory. No node and clean: the row is valid. No node, but dirty: the node is deleted,
/// and its row must be deleted.
struct NodeState {
  std::shared_ptr<Node> node;
  bool dirty = false;  ///< the row has another state
};

/// The time of a query, whose nodes it reads whatever happens later.
struct NodeSnapshot {
  std::size_t position;
  bool broken = false;  ///< a rollback removed states that it needs
};

class NodeHistory {
 public:
  using Snapshot = std::list<NodeSnapshot>::iterator;

  /// The position after all entries.
  std::size_t end() const { return first_ + log_.size(); }
  void keep(NodeNumber number, const NodeState& state);
  /// The state of `number` at a position, if it changed since; else null.
  const NodeState* find(std::size_t position, NodeNumber number) const;
  /// Calls each(number, state) for the entries from a position up to another, newest first.
  template <class Each>
  void for_each_back(std::size_t position, std::size_t end, Each each) const {
    for (std::size_t i = end; i-- > position;)
      if (const Entry& entry = at(i); !entry.dropped) each(entry.number, entry.before);
  }
  /// Removes all entries from a position on.
  void truncate(std::size_t position) noexcept;
  /// Drops states from a position on that neither a snapshot needs nor a mark at one of these positions.
  void compact(std::size_t position, std::span<const std::size_t> marks) noexcept;
  /// Drops the nodes that equal their rows, which can be read again. Requires: no snapshots.
  void drop_stored() noexcept;
  void clear() noexcept { truncate(first_); }

  Snapshot take_snapshot() { return snapshots_.insert(snapshots_.end(), {end()}); }
  void give_up(Snapshot snapshot) noexcept { snapshots_.erase(snapshot); }
  bool has_snapshots() const { return !snapshots_.empty(); }
  bool has_snapshot_since(std::size_t position) const {
    return has_snapshots() && snapshots_.back().position >= position;
  }
  void break_snapshots() noexcept {
    for (NodeSnapshot& snapshot : snapshots_) snapshot.broken = true;
  }

 private:
  struct Entry {
    NodeNumber number;
    NodeState before;
    std::size_t previous;  ///< 1 + position of the entry before it of this node; 0: none
    bool dropped = false;
  };

  Entry& at(std::size_t position) { return log_[position - first_]; }
  const Entry& at(std::size_t position) const { return log_[position - first_]; }
  void pop_back() noexcept;

  std::deque<Entry> log_;
  std::size_t first_ = 0;                               ///< position of the first entry
  std::unordered_map<NodeNumber, std::size_t> newest_;  ///< as Entry::previous, of each node
  std::list<NodeSnapshot> snapshots_;                   ///< oldest first
};

}  // namespace foresee
