// Undo log of tree nodes: marks (savepoints and snapshots), and for each mark the old states of the nodes
// that changed after it.
//
//   undo.set(head, false);                 // sets a mark; copies nothing
//   undo.keep(7, state);                   // before node 7 changes: the newest mark keeps its state
//   undo.find(mark, 7)                     // node 7 as of that mark; null: unchanged since
//
// A savepoint and the snapshot of a query are both a mark. A node that changes is kept once, by the newest
// mark; an older mark finds it there: the node is unchanged between the two marks. A mark that is given up
// passes its states to the mark before it. Cost: one entry per changed node, none per mark; passing states on
// costs the smaller of the two numbers of entries.
#pragma once

#include <cstdint>
#include <list>
#include <memory>
#include <unordered_map>

#include "index/pages.h"

namespace foresee {

/// State of a node in memory. No node and clean: the row is valid. No node, but dirty: the node is deleted,
/// and its row must be deleted.
struct NodeState {
  std::shared_ptr<Node> node;
  bool dirty = false;  ///< the row has another state
};

/// State of the tree besides its nodes.
struct TreeHead {
  static constexpr NodeNumber unknown = -1;

  NodeNumber root = unknown;
  NodeNumber last = unknown;  ///< no node has a larger number
  bool root_dirty = false;
};

struct UndoMark {
  TreeHead head;
  bool is_snapshot = false;
  bool given_up = false;
  bool broken = false;  ///< a rollback removed states that this mark needs
  std::unordered_map<NodeNumber, NodeState> before;
};

class UndoLog {
 public:
  using Handle = std::list<UndoMark>::iterator;

  bool none() const { return marks_.empty(); }
  int snapshots() const { return snapshots_; }

  Handle set(const TreeHead& head, bool is_snapshot);
  void give_up(Handle mark) noexcept;

  /// Requires: a mark is set.
  void keep(NodeNumber number, const NodeState& state) { marks_.back().before.try_emplace(number, state); }
  /// The state of `number` as of the mark, if it changed since; else null.
  const NodeState* find(Handle mark, NodeNumber number) const;
  /// The states, as of the mark, of all nodes that changed since.
  std::unordered_map<NodeNumber, NodeState> changed_since(Handle mark) const;

  bool snapshot_since(Handle mark) const;
  void break_snapshots() noexcept;
  /// Drops the nodes that savepoints keep and that equal their rows, which can be read again. Requires: no
  /// snapshots.
  void drop_stored() noexcept;

 private:
  std::list<UndoMark> marks_;  // oldest first
  int snapshots_ = 0;
};

}  // namespace foresee
