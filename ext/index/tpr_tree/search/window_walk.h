// Search in a TPR-tree for objects that may meet a moving box during a horizon (a window query), leaf by
// leaf.
//
//   WindowWalk<2> walk(source, moving_window<2>(lower, upper, velocity, horizon), horizon, Vec<2>::zero(),
//                      interrupt);
//   for (LeafHits hits; walk.next(hits);)
//     for (auto slot : hits.slots) decide(hits.leaf->keys[slot]);          // the contact module decides
//
// The same walk finds the partners of one object: its moving_box() is the query box, and `margin` is the
// distance that `within` adds for both together.
//
// Guarantee: every object is returned exactly once whose box, grown by `margin`, meets the query box at a
// time of the horizon at which the object exists. Others may be returned too, but none that `test` rejects, and no
// object with a plan.
// The walk reads nodes on demand; between calls it holds only the numbers of unread nodes. So if the tree
// changes between calls, the source must be a snapshot (pages.h).
#pragma once

#include "base/error.h"
#include "index/tpr_tree/leaf_hits.h"

namespace foresee {

template <int D>
class WindowWalk {
 public:
  WindowWalk(NodeSource& source, const MovingBox<D>& query, const Horizon& horizon, const Vec<D>& margin,
             Interrupt& interrupt, const std::optional<KindTest>& test = {});

  /// Returns the next leaf with at least one object that may meet the query box; false once no such leaf is
  /// left.
  bool next(LeafHits& hits);

 private:
  bool exists(const Times& lives) const;
  /// Plain: all pass the test, and none has a plan.
  template <bool plain>
  void find_in_leaf(const Node& leaf, std::vector<std::uint32_t>& slots) const;
  void open_children(NodeNumber number, const Node& inner);

  NodeSource& source_;
  Interrupt& interrupt_;
  LeafReader<D> reader_;
  Horizon horizon_;
  MovingBox<D> query_;            ///< grown by the margin
  std::optional<KindTest> test_;  ///< of the objects that are returned
  std::vector<Unread> open_;
};

}  // namespace foresee
