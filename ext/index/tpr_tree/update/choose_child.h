// Choice of the subtree for an insertion, of the sibling with which a node shares, and of the two halves of a split:
// the cost of visits increases least.
//
//   ChildChoice<2> choice(*inner, state.cost(inner->epoch));     // for as many objects as there are
//   const std::size_t slot = choice.choose(entry_of(object, inner->epoch));
//
// Ties go to the cheaper child, so an object that some children contain goes to the cheapest of them. Cost: the node's
// entries are read once. Then each object costs some comparisons per child, and about thirty multiplications per child
// if none contains it, in vector instructions.
#pragma once

#include <compare>
#include <optional>
#include <vector>

#include "index/tpr_tree/tree_state.h"

namespace foresee {

template <int D>
class ChildChoice {
 public:
  /// Requires: an inner node that is not empty; `cost` is for bounds at its epoch.
  ChildChoice(const Node& inner, const VisitCost<D>& cost);

  /// The slot of the best child for `added`, an entry at the node's epoch.
  std::size_t choose(const Entry<D>& added);

 private:
  enum Face { x_lower, x_upper, v_lower, v_upper, a_lower, a_upper, faces };
  const double* face(int which, int axis) const {
    return faces_.data() + static_cast<std::size_t>(which * D + axis) * children_;
  }
  void read(const Node& inner);
  std::optional<std::size_t> cheapest_containing(const Entry<D>& added);
  bool contains_otherwise(std::size_t child, const Entry<D>& added) const;
  void costs_with(const Entry<D>& added, std::vector<double>& costs);
  void set_widths(const Bounds<D>& added);
  void set_windows(const Times& added);

  std::size_t children_;
  VisitCost<D> cost_;
  bool any_ends_;
  TypicalQuery query_;
  std::vector<std::size_t> slots_;         ///< of the children, by ascending cost: the order of all columns
  std::vector<double> faces_;              ///< of all children in columns: by face, then by axis
  std::vector<double> times_;              ///< of all children in columns; empty if no child ends
  std::vector<double> widths_, product_;   ///< temporary
  std::vector<std::int64_t> outside_;      ///< temporary: not 0 if the child does not contain the position
  std::vector<double> elapsed_, weights_;  ///< temporary: the windows of the children, if any ends
  std::vector<double> before_, after_;     ///< the cost of each child
};

/// The slot of the sibling that a node overlaps most: a union with it increases the cost least. The node's
/// own slot if it has no sibling.
template <int D>
std::size_t closest_sibling(const TreeState<D>& state, const Node& above, NodeNumber number);

/// The cost that an addition adds to a child; the min is the best.
struct Growth {
  double cost;
  std::size_t slot;

  friend auto operator<=>(const Growth&, const Growth&) = default;
};

/// The growth of every child, by slot. `added` is an entry at the node's epoch.
template <int D>
std::vector<Growth> growths(const Node& inner, const Entry<D>& added, const VisitCost<D>& cost,
                            const TypicalQuery& query);

/// The slots of a child, first, and of the siblings that it overlaps most: at most `limit` in total.
template <int D>
std::vector<std::size_t> closest_children(const TreeState<D>& state, const Node& above, NodeNumber number,
                                          std::size_t limit);

// Split of an overfull node along an axis of position or velocity, or in time, so that the visit cost of both
// halves is minimal.
//
// The elements are sorted by their centres at half the look-ahead and by velocity, on every axis. If some
// have an end, they are sorted by their reference times, too. Every cut that leaves at least 40 % on both
// sides is evaluated. Cost: 2·D sorts of one node's elements, or one more.

/// The elements that move to the new node, by index, ascending. Requires: at least 4 elements.
template <int D>
std::vector<std::uint32_t> choose_split(std::span<const Entry<D>> elements, const VisitCost<D>& cost);

}  // namespace foresee
