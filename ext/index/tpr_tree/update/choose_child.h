// Into which child does an object go, and with which sibling does a node share? Where the cost of being
// visited grows least.
//
//   ChildChoice<2> choice(*inner, state.cost(inner->epoch));     // for as many objects as there are
//   const std::size_t slot = choice.choose(entry_of(object, inner->epoch).bounds);
//
// Ties go to the cheaper child. Cost: reading the node's entries once; then, an object, some thirty
// multiplications for each child, side by side.
#pragma once

#include <compare>
#include <vector>

#include "index/tpr_tree/tree_state.h"

namespace foresee {

template <int D>
class ChildChoice {
 public:
  /// Requires: an inner node that is not empty; `cost` for bounds at its epoch.
  ChildChoice(const Node& inner, const VisitCost<D>& cost);

  /// The slot of the best child for something with `added` as its bounds at the node's epoch.
  std::size_t choose(const Bounds<D>& added);

 private:
  enum Face { x_lower, x_upper, v_lower, v_upper, a_lower, a_upper, faces };
  const double* face(int which, int axis) const {
    return faces_.data() + static_cast<std::size_t>(which * D + axis) * children_;
  }
  void costs_with(const Bounds<D>& added, std::vector<double>& costs);

  std::size_t children_;
  VisitCost<D> cost_;
  double query_;
  std::vector<double> faces_;             ///< of all children side by side, face after face, axis by axis
  std::vector<double> widths_, product_;  ///< room
  std::vector<double> before_, after_;    ///< what children cost
};

/// The slot of the sibling that a node overlaps most: together they would cost least more than apart. Its own
/// if it has no sibling.
template <int D>
std::size_t closest_sibling(const TreeState<D>& state, const Node& above, NodeNumber number);

/// How much more a child would cost with something in it; the least is the best one.
struct Growth {
  double cost;
  std::size_t slot;

  friend auto operator<=>(const Growth&, const Growth&) = default;
};

/// Of every child, by slot. `added` as bounds at the node's epoch.
template <int D>
std::vector<Growth> growths(const Node& inner, const Bounds<D>& added, const VisitCost<D>& cost,
                            double query);

/// The slots of a child and its siblings that it overlaps most, itself first: so many, or all.
template <int D>
std::vector<std::size_t> closest_children(const TreeState<D>& state, const Node& above, NodeNumber number,
                                          std::size_t limit);

}  // namespace foresee
