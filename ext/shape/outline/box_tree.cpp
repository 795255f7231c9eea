#include "shape/outline/box_tree.h"

#include <algorithm>
#include <numeric>

namespace foresee {

template <int D>
BoxTree<D>::BoxTree(std::span<const Box<D>> boxes)
    : nodes_(2 * boxes.size() - 1), first_leaf_(static_cast<Node>(nodes_.size() / 2)) {
  std::copy(boxes.begin(), boxes.end(), nodes_.begin() + static_cast<std::ptrdiff_t>(first_leaf()));
  for (std::size_t node = first_leaf(); node-- > 0;) {
    const Box<D>&one = nodes_[2 * node + 1], &other = nodes_[2 * node + 2];
    nodes_[node] = {one.lower.min(other.lower), one.upper.max(other.upper)};
  }
}

namespace {

/// Assigns boxes to leaves, from the root downwards.
template <int D>
class LeafAssignment {
 public:
  explicit LeafAssignment(std::span<const Box<D>> boxes)
      : boxes_(boxes), assigned_(boxes.size()), order_(boxes.size()), leaves_(2 * boxes.size() - 1, 1) {
    std::iota(assigned_.begin(), assigned_.end(), 0);
    for (std::size_t node = boxes.size() - 1; node-- > 0;)
      leaves_[node] = leaves_[2 * node + 1] + leaves_[2 * node + 2];
  }

  std::vector<std::uint32_t> order() && {
    assign(0, assigned_.begin());
    return std::move(order_);
  }

 private:
  using Place = std::vector<std::uint32_t>::iterator;

  /// Assigns the boxes from `first` on, as many as the node has leaves. Recursive, as deep as the tree.
  void assign(std::size_t node, Place first) {
    const std::size_t first_leaf = boxes_.size() - 1;
    if (node >= first_leaf) {
      order_[node - first_leaf] = *first;
      return;
    }
    const Place middle = first + leaves_[2 * node + 1], last = first + leaves_[node];
    const int axis = widest_axis(first, last);
    std::nth_element(first, middle, last, [&](std::uint32_t a, std::uint32_t b) {
      const double at_a = middle_of(a)[axis], at_b = middle_of(b)[axis];
      return at_a < at_b || (at_a == at_b && a < b);
    });
    assign(2 * node + 1, first);
    assign(2 * node + 2, middle);
  }

  int widest_axis(Place first, Place last) const {
    Vec<D> lower = middle_of(*first), upper = lower;
    for (; first != last; ++first) lower = lower.min(middle_of(*first)), upper = upper.max(middle_of(*first));
    return (upper - lower).largest_axis();
  }

  Vec<D> middle_of(std::uint32_t box) const { return boxes_[box].lower / 2 + boxes_[box].upper / 2; }

  std::span<const Box<D>> boxes_;
  std::vector<std::uint32_t> assigned_;  ///< indices of boxes, those of each node adjacent
  std::vector<std::uint32_t> order_;
  std::vector<std::uint32_t> leaves_;  ///< number of leaves below each node
};

}  // namespace

template <int D>
std::vector<std::uint32_t> tree_order(std::span<const Box<D>> boxes) {
  return LeafAssignment<D>(boxes).order();
}

template class BoxTree<2>;
template class BoxTree<3>;
template std::vector<std::uint32_t> tree_order<2>(std::span<const Box<2>>);
template std::vector<std::uint32_t> tree_order<3>(std::span<const Box<3>>);

}  // namespace foresee
