// Which pages does an index need? The index says so here; storage supplies them, and MemoryPages does for
// tests and embedders.
//
// A node is decoded: its keys and, side by side with them, the same number of doubles per key.
//
//             keys[i]                      values[i * stride …]
//   leaf      id of an object              its record, record_offsets(layout).size doubles
//   inner     number of a child node       the child's entry, entry_size(axes) doubles:
//                                          least t, greatest t, greatest until beneath it;
//                                          lower x…, upper x…, lower v…, upper v…, lower a…, upper a…
//
// The bounds of an entry are those of all motions beneath it, carried to the node's epoch: position,
// velocity and acceleration there. They hold at every moment, before the epoch too (tpr_tree/bounds.h).
// Greatest t is exact; the other two times and the bounds may be wider than need be. An infinite bound is no
// bound. Pages vouch for each node by itself: keys and values fit together, sizes are within the capacities,
// no value is NaN, times and records are finite where docs/sql_reference.md#values wants them so.
//
// How long references live. read() hands out a share of the node: it stays as it was for as long as it is
// held, whatever happens to the pages. modify() hands out a reference that stays good until the call of the
// tree that asked for it returns; so pages may write out and drop nodes between two calls of the tree, in
// put() and in make_room(), but in no other call. Before its first change to a node in such a call the tree
// announces it by modify(), modify_record(), put() or free(): that is the moment to keep a copy for a
// savepoint. The tree does not look at a share of a node that it has announced a change of.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/error.h"
#include "shape/layout.h"

namespace foresee {

class FormSource;

/// Nodes contradict one another: a parent without its child, levels that do not count down. Thrown instead of
/// going astray, so hostile nodes cost no more than an error.
struct BrokenTree : Error {
  using Error::Error;
};

/// Positive; 0 stands for no node.
using NodeNumber = std::int64_t;

struct Node {
  int level = 0;  ///< 0: a leaf; one more than its children otherwise
  NodeNumber parent = 0;
  double epoch = 0;  ///< of an inner node's bounds
  std::vector<std::int64_t> keys;
  std::vector<double> values;

  bool is_leaf() const { return level == 0; }
  std::size_t size() const { return keys.size(); }
};

/// Doubles of an inner node's entry.
constexpr int entry_size(int axes) {
  return 3 + 6 * axes;
}

/// What walks need: nodes to read. A source may be the live tree or the tree as it was at some moment.
class NodeSource {
 public:
  virtual ~NodeSource() = default;

  virtual const Layout& layout() const = 0;
  /// 0: no objects.
  virtual NodeNumber find_root() = 0;
  virtual std::shared_ptr<const Node> read(NodeNumber number) = 0;
  /// Of the outlines or meshes that records name by number; null where their layout has none. Lives as long
  /// as this.
  virtual FormSource* forms() { return nullptr; }
};

/// What the tree needs to change itself. Any call may throw; the caller then undoes what was announced.
class Pages : public NodeSource {
 public:
  /// How many objects a leaf, and children an inner node, hold at most: at least 4 each.
  virtual std::size_t leaf_capacity() const = 0;
  virtual std::size_t inner_capacity() const = 0;

  virtual Node& modify(NodeNumber number) = 0;
  /// The same for one record of a leaf, and for nothing else of it: pages may note that record alone.
  virtual double* modify_record(NodeNumber leaf, std::size_t slot) = 0;
  /// A new number, with an empty node.
  virtual NodeNumber allocate() = 0;
  /// The first of so many new numbers in a row, without nodes: each is put() before it is asked for.
  virtual NodeNumber reserve(std::size_t count) = 0;
  /// Replaces a node whole; no reference to it is in use.
  virtual void put(NodeNumber number, Node node) = 0;
  /// In the middle of a large change: no reference is in use.
  virtual void make_room() {}
  virtual void free(NodeNumber number) = 0;
  virtual void set_root(NodeNumber number) = 0;

  /// The leaf that holds an object.
  virtual std::optional<NodeNumber> find_leaf(std::int64_t id) = 0;
  /// From now on these objects are in `leaf`, wherever they were.
  virtual void place(std::span<const std::int64_t> ids, NodeNumber leaf) = 0;
  virtual void forget(std::int64_t id) = 0;
};

}  // namespace foresee
