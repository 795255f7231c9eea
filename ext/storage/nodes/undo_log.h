// How was the tree at an earlier moment? An undo log of nodes: marks in time, and what each node was like
// before it changed.
//
//   undo.set(head, false);                 // a mark: nothing is copied
//   undo.keep(7, state);                   // node 7 is about to change: the newest mark keeps what it is
//   undo.find(mark, 7)                     // node 7 as it was at that mark; null: it is so still
//
// A savepoint and a question's snapshot are both a mark. A node that changes is kept once, by the newest
// mark; an older one finds it there, because the node did not change in between. A mark that is given up
// leaves what it keeps to the mark before it. Cost: one entry for each node that changes, none for a mark;
// leaving what two marks keep to one of them: the fewer entries of both.
#pragma once

#include <cstdint>
#include <list>
#include <memory>
#include <unordered_map>

#include "index/pages.h"

namespace foresee {

/// A node between the tree and its row. No node and not dirty: whatever the row says. No node, but dirty: it
/// is gone, and its row must go.
struct NodeState {
  std::shared_ptr<Node> node;
  bool dirty = false;  ///< the row says something else
};

/// What there is beside the nodes.
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
  bool broken = false;  ///< a rollback took away what this mark should know
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
  /// What `number` was like at the mark, if it changed since; else null.
  const NodeState* find(Handle mark, NodeNumber number) const;
  /// Every node that changed since the mark, as it was then.
  std::unordered_map<NodeNumber, NodeState> changed_since(Handle mark) const;

  bool snapshot_since(Handle mark) const;
  void break_snapshots() noexcept;
  /// Where rows can be read again: drops the nodes that savepoints keep of them. Requires: no snapshots.
  void drop_stored() noexcept;

 private:
  std::list<UndoMark> marks_;  // oldest first
  int snapshots_ = 0;
};

}  // namespace foresee
