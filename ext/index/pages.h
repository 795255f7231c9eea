// The node store of a TPR-tree, as an interface: nodes that the tree reads, changes, allocates and frees.
//
// Storage implements it over SQLite; MemoryPages implements it for tests and embedders. A node is decoded:
// its keys, and an array with the same number of doubles per key.
//
//             keys[i]                      values[i * stride …]
//   leaf      id of an object              its record, record_offsets(layout).size doubles
//   inner     number of a child node       the child's entry, entry_size(axes) doubles:
//                                          min t, max t, max until beneath it;
//                                          lower x…, upper x…, lower v…, upper v…, lower a…, upper a…
//
// The bounds of an entry contain all motions beneath it, carried to the node's epoch: position, velocity and
// acceleration there. They hold at every time, also before the epoch (tpr_tree/bounds.h). Max t is exact; the
// other two times and the bounds may be wider than necessary. An infinite bound is no bound.
//
// Validity. Pages validate each node separately: keys and values fit together, sizes are within the
// capacities, and no value is NaN. Times and records are finite where docs/reference/moving_objects.md#values requires
// it.
//
// Lifetimes. read() returns a shared pointer to a node that never changes while it is held. modify() returns
// a reference that is valid until the tree's current public call returns. So pages may write out and drop
// nodes between two calls of the tree, in put() and in make_room(), but in no other call. Before the tree
// first changes a node in such a call, it announces the change by modify(), put() or free(). Pages that support
// savepoints copy the node then. The tree does not read a shared pointer to a node after it has announced a
// change of that node.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/error.h"
#include "shape/kinds.h"
#include "shape/row_layout.h"

namespace foresee {

class FormSource;

/// Thrown if nodes contradict one another: a parent without its child, levels that do not count down. So
/// hostile nodes cause an error and nothing worse.
struct BrokenTree : Error {
  using Error::Error;
  bool is_damage() const noexcept override { return true; }
};

/// Positive; 0 means no node.
using NodeNumber = std::int64_t;

struct Node {
  int level = 0;  ///< 0: a leaf; otherwise one more than the level of its children
  NodeNumber parent = 0;
  double epoch = 0;  ///< of an inner node's bounds
  std::vector<std::int64_t> keys;
  std::vector<double> values;
  /// Of an inner node: the kinds of all objects beneath each child, or-ed. Empty if all are the default.
  std::vector<Kinds> kinds = {};

  bool is_leaf() const { return level == 0; }
  std::size_t size() const { return keys.size(); }
};

inline Kinds kinds_at(const Node& inner, std::size_t slot) {
  return inner.kinds.empty() ? Kinds{} : inner.kinds[slot];
}

/// Requires: the node has the key of this slot.
inline void set_kinds(Node& inner, std::size_t slot, Kinds kinds) {
  if (inner.kinds.empty() && kinds == Kinds{}) return;
  inner.kinds.resize(inner.size());
  inner.kinds[slot] = kinds;
}

/// Number of doubles in an inner node's entry.
constexpr int entry_size(int axes) {
  return 3 + 6 * axes;
}

/// Read access for walks. A source is the live tree or a snapshot of it.
class NodeSource {
 public:
  virtual ~NodeSource() = default;

  virtual const Layout& layout() const = 0;
  /// 0 if the tree has no objects.
  virtual NodeNumber find_root() = 0;
  virtual std::shared_ptr<const Node> read(NodeNumber number) = 0;
  /// The outlines or meshes that records name by number; null if the layout has none. It lives as long as
  /// this.
  virtual FormSource* forms() { return nullptr; }
};

/// Write access for the tree. Any call may throw; the caller then rolls back the announced changes.
class Pages : public NodeSource {
 public:
  /// Max number of objects in a leaf, and of children in an inner node; at least 4 each.
  virtual std::size_t leaf_capacity() const = 0;
  virtual std::size_t inner_capacity() const = 0;

  virtual Node& modify(NodeNumber number) = 0;
  /// Returns a new number, with an empty node.
  virtual NodeNumber allocate() = 0;
  /// Returns the first of `count` consecutive new numbers, without nodes: each is put() before it is read.
  virtual NodeNumber reserve(std::size_t count) = 0;
  /// Replaces a whole node. Requires: no reference to it is in use.
  virtual void put(NodeNumber number, Node node) = 0;
  /// Called during a large change, when no reference is in use: pages may write out and drop nodes.
  virtual void make_room() {}
  virtual void free(NodeNumber number) = 0;
  virtual void set_root(NodeNumber number) = 0;

  /// The leaf that holds an object; no value if the tree does not have it.
  virtual std::optional<NodeNumber> find_leaf(std::int64_t id) = 0;
  /// find_leaf() of each of these objects; 0: the tree does not have it.
  virtual std::vector<NodeNumber> leaves_of(std::span<const std::int64_t> ids, Interrupt& interrupt) {
    std::vector<NodeNumber> leaves;
    for (const std::int64_t id : ids) interrupt.check(), leaves.push_back(find_leaf(id).value_or(0));
    return leaves;
  }
  /// From now on these objects are in `leaf`, whichever leaf they were in before.
  virtual void place(std::span<const std::int64_t> ids, NodeNumber leaf) = 0;
  virtual void forget(std::int64_t id) = 0;
  /// Between the two calls objects are placed, each at most once, and no leaf is looked up: pages may keep the
  /// places in a list. `new_ids`: of the objects that no leaf has yet.
  virtual void start_placing(std::span<const std::int64_t> /*new_ids*/) {}
  virtual void finish_placing(Interrupt& /*interrupt*/) {}
};

}  // namespace foresee
