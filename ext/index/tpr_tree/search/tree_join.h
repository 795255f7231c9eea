// Which pairs may touch, by synchronous traversal of two trees, or of one tree with itself (SIJ-TPR)?
//
//   TreeScene ships = read_tree(source, interrupt);           // rows in leaf order, and which leaf is where
//   auto candidates = make_tree_join<2>(ships.bodies(), ships.levels, horizon, margin, interrupt);
//
// Two nodes are opened together while their moving boxes can meet, and only for the moments at which they
// can: the time interval narrows on the way down. Boxes are those of the objects during this horizon, grown
// by `margin` on every side, and are gathered from the leaves up before the first pair, so a join sees tight
// bounds and the tree as it was.
//
// Guarantee: every pair whose grown moving boxes meet at one moment of the horizon at which both exist comes
// exactly once; other pairs may come too, none twice. (Fewer than those whose swept boxes meet: both have to
// be there at the same time.) Memory: one moving box an object, a stack of node pairs, one batch.
#pragma once

#include "index/candidates.h"
#include "index/pages.h"

namespace foresee {

/// The tree without its numbers. starts[0][i] is the first row of leaf i, starts[k][i] the first child, one
/// level down, of node i on level k; each level ends with the size of the one below.
struct TreeLevels {
  std::vector<std::vector<std::uint32_t>> starts;
};

struct TreeScene {
  Layout layout;
  std::vector<std::int64_t> ids;
  std::vector<double> rows;  ///< row_offsets(layout).size doubles each
  TreeLevels levels;

  Bodies bodies() const { return {layout, rows.data(), ids.size()}; }
};

TreeScene read_tree(NodeSource& source, Interrupt& interrupt);

/// Pairs within one tree. `interrupt` must outlive the join; nothing else is kept.
template <int D>
std::unique_ptr<Candidates> make_tree_join(const Bodies& bodies, const TreeLevels& levels,
                                           const Horizon& horizon, const Vec<D>& margin,
                                           Interrupt& interrupt);

/// Pairs between two trees.
template <int D>
std::unique_ptr<Candidates> make_tree_join(const Bodies& bodies_a, const TreeLevels& levels_a,
                                           const Bodies& bodies_b, const TreeLevels& levels_b,
                                           const Horizon& horizon, const Vec<D>& margin,
                                           Interrupt& interrupt);

}  // namespace foresee
