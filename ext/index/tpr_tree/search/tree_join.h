// Join of two TPR-trees, or of one tree with itself, by synchronous traversal (SIJ-TPR): pairs that may
// touch.
//
//   TreeScene ships = read_tree(source, interrupt);           // rows in leaf order, and which leaf is where
//   auto candidates = make_tree_join<2>(ships.bodies(), ships.levels, horizon, margin, interrupt);
//
// Two nodes are opened together while their moving boxes can meet, and only for the times at which they can:
// the interval narrows on each level. The boxes bound the objects during this horizon, grown by `margin` on
// every side. They are computed from the leaves up before the first pair. So a join has tight bounds and a
// snapshot of the tree.
//
// Guarantee: every pair is reported exactly once whose grown moving boxes meet at a time of the horizon at
// which both objects exist. Other pairs may be reported too, none twice. (They are fewer than the pairs whose
// swept boxes meet, because both objects must be there at the same time.) Memory: one moving box per object,
// a stack of node pairs, one batch.
#pragma once

#include <optional>

#include "index/candidates.h"
#include "index/pages.h"

namespace foresee {

/// The structure of the tree without its numbers. starts[0][i] is the first row of leaf i; starts[k][i] is
/// the first child, one level down, of node i on level k. Each level ends with the size of the level below.
struct TreeLevels {
  std::vector<std::vector<std::uint32_t>> starts;
};

struct TreeScene {
  Layout layout;
  std::vector<std::int64_t> ids;
  std::vector<double> rows;  ///< row_offsets(layout).size doubles each
  TreeLevels levels;
  bool complete = true;  ///< it has every object of the tree

  Bodies bodies() const { return {layout, rows.data(), ids.size()}; }
};

/// With `wanted`, only the objects that it accepts; subtrees without one are not read. A node may have no child then.
TreeScene read_tree(NodeSource& source, Interrupt& interrupt, const std::optional<KindTest>& wanted = {});

/// Pairs within one tree. `interrupt` must outlive the join; the other arguments need not. `kinds`: of the rows;
/// only pairs that may meet are reported. Null: all may meet.
template <int D>
std::unique_ptr<Candidates> make_tree_join(const Bodies& bodies, const TreeLevels& levels,
                                           const Horizon& horizon, const Vec<D>& margin, Interrupt& interrupt,
                                           const Kinds* kinds = nullptr);

/// Pairs between two trees. The kinds are given for both or for none.
template <int D>
std::unique_ptr<Candidates> make_tree_join(const Bodies& bodies_a, const TreeLevels& levels_a,
                                           const Bodies& bodies_b, const TreeLevels& levels_b,
                                           const Horizon& horizon, const Vec<D>& margin, Interrupt& interrupt,
                                           const Kinds* kinds_a = nullptr, const Kinds* kinds_b = nullptr);

}  // namespace foresee
