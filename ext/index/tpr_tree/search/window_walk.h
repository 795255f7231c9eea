// Who may meet a moving box during a horizon? Every object of the tree that does, leaf by leaf.
//
//   WindowWalk<2> walk(source, moving_window<2>(lower, upper, velocity, horizon), horizon, Vec<2>::Zero(),
//                      interrupt);
//   for (LeafHits hits; walk.next(hits);)
//     for (auto slot : hits.slots) decide(hits.leaf->keys[slot]);          // contact has the last word
//
// The same walk probes the tree with one object: its moving_box() is the question, `margin` what `within`
// adds to both together.
//
// Guarantee: every object whose box, grown by `margin`, meets the question's at a moment of the horizon at
// which it exists comes exactly once; others may come too. The walk reads nodes as it goes; between calls it
// holds only the numbers of nodes that are still to be read, so a source that changes meanwhile must be one
// that keeps the moment (pages.h).
#pragma once

#include "base/error.h"
#include "index/tpr_tree/leaf_hits.h"

namespace foresee {

template <int D>
class WindowWalk {
 public:
  WindowWalk(NodeSource& source, const MovingBox<D>& question, const Horizon& horizon, const Vec<D>& margin,
             Interrupt& interrupt);

  /// The next leaf with objects that may meet the question, at least one; false once there is none.
  bool next(LeafHits& hits);

 private:
  void find_in_leaf(const Node& leaf, std::vector<std::uint32_t>& slots) const;
  void open_children(NodeNumber number, const Node& inner);

  NodeSource& source_;
  Interrupt& interrupt_;
  LeafReader<D> reader_;
  Horizon horizon_;
  MovingBox<D> question_;  ///< grown by the margin
  std::vector<Unread> open_;
};

}  // namespace foresee
