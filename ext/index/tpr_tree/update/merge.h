// Batch insertion and update of many objects: each affected node is read and changed once, however many
// objects affect it.
//
//   merge_objects(state, ids, records, interrupt);
//
// Objects that the tree already has are position reports. Each overwrites its record if its leaf's entry remains true,
// as in bottom-up updates (Lee et al., "Supporting Frequent Updates in R-Trees: A Bottom-Up Approach", VLDB 2003).
// Other objects move up, level by level, to the lowest node that contains them; new objects start at the root. From
// there each moves down to the leaf whose visit cost increases least. Then nodes are settled from the leaves up.
// Overfull and underfull nodes share with a sibling before they are split (B*-trees, Knuth, The Art of Computer
// Programming 3, 6.2.4). Every entry above a changed node is recomputed once.
//
// As objects move, those of a leaf are no longer neighbours, and a window visits more leaves. So all leaves of a parent
// are packed together once some 40 % of their objects have changed, if that makes them better.
//
// Cost per object: one read of its leaf, and if it leaves that leaf, a choice among the children of one to a
// few nodes. All objects of a leaf share the cost of writing it.
#pragma once

#include "index/tpr_tree/tree_state.h"

namespace foresee {

/// Inserts or updates each object. Ids are unique. Requires: the root is an inner node.
template <int D>
void merge_objects(TreeState<D>& state, std::span<const std::int64_t> ids, std::span<const double> records,
                   Interrupt& interrupt);

/// Erases these objects. Requires: as TprTree::erase_all().
template <int D>
void erase_objects(TreeState<D>& state, std::span<const std::int64_t> ids, std::size_t max_leaves,
                   Interrupt& interrupt);

// Batch insertion of many new objects as loose leaves, packed beside the leaves that are there.
//
//   const Remainder rest = merge_runs(state, ids, records, interrupt);
//   merge_objects(state, rest.ids, rest.records, interrupt);       // too few for a leaf
//
// A batch that puts an object or two into every leaf would write the whole tree, batch after batch. Here a node is a
// partition: most of its children are its main run, packed together, and others are loose, which came later. The new
// objects of a partition are packed together with the newest of its loose children, so that these form runs of one,
// two, four … batches. Once the loose objects would be a quarter of the others, the whole partition is packed: a
// log-structured merge (P. O'Neil, E. Cheng, D. Gawlick, E. O'Neil, "The Log-Structured Merge-Tree", Acta Informatica
// 33, 1996). The fraction differs between partitions, so that they are not packed in the same batch.
//
// Partitions are the nodes of level 1 if a batch brings each a leaf or more. A smaller batch would write one leaf of a
// few objects into each: its partitions are nodes of level 2 or higher. Their loose children are subtrees, of one run.
//
// A child is loose if its number is larger than that of its parent: packing numbers nodes from the leaves up. Of loose
// children the newest have the largest numbers. So nothing is stored about runs, and a wrong guess costs a little time,
// never an answer.
//
// Cost: per object a choice of a child per level, and some five writes if a table grows to twenty batches, ten to a
// hundred. A window visits about one loose leaf per run and partition besides the others.

/// Objects, for example those that remain to be inserted.
struct Remainder {
  std::vector<std::int64_t> ids;
  std::vector<double> records;

  void clear() {
    ids.clear();
    records.clear();
  }
  template <class Batch>
  void add(const Batch& batch, std::span<const std::uint32_t> objects) {
    for (const std::uint32_t i : objects) {
      const auto added = batch.object(i);
      ids.push_back(added.id);
      records.insert(records.end(), added.record.begin(), added.record.end());
    }
  }
};

/// Whether most of these objects are in the node of the object before them and remain in it, among nodes that have
/// about an eighth of so many. Then merge_objects() changes few nodes per object. A sample decides. Requires: the tree
/// has a root.
template <int D>
bool arrive_in_place(TreeState<D>& state, std::span<const std::int64_t> ids, std::span<const double> records,
                     Interrupt& interrupt);

/// Whether a batch of so many objects is worth loose leaves: else merge_objects() is faster.
template <int D>
bool takes_runs(const TreeState<D>& state, std::size_t objects);

/// Inserts all objects but the remainder. Requires: takes_runs(); the tree has none of the objects; their ids are
/// unique.
template <int D>
Remainder merge_runs(TreeState<D>& state, std::span<const std::int64_t> ids, std::span<const double> records,
                     Interrupt& interrupt);

}  // namespace foresee
