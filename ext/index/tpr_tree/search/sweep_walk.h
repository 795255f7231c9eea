// Whose swept boxes may meet a box? Leaf by leaf, every leaf that has such an object.
//
//   SweepWalk<2> walk(source, tile, horizon, margin, interrupt);
//   while (auto leaf = walk.next()) decide(*leaf);               // each object's own box has the last word
//
// A swept box is wider than the object's way: its corners may be where the object never is. So this is not a
// window's question (window_walk.h), which asks who is there at one moment.
//
// Guarantee: every object whose swept box, as swept_box() rounds it with `margin`, meets the question is in
// exactly one of the leaves; others are too. An object that does not exist during the horizon may be left
// out. Cost: the nodes whose swept bounds meet the question. Between calls numbers of nodes are held, as
// in a WindowWalk.
#pragma once

#include "base/error.h"
#include "index/tpr_tree/leaf_hits.h"

namespace foresee {

template <int D>
class SweepWalk {
 public:
  SweepWalk(NodeSource& source, const Box<D>& question, const Horizon& horizon, const Vec<D>& margin,
            Interrupt& interrupt);

  /// The next leaf, some of whose objects may meet the question; null once there is none.
  std::shared_ptr<const Node> next();

  /// About which part of all objects is in the leaves, from some nodes below the root: 1 where the tree is
  /// small. To be asked before next().
  double likely_share();

 private:
  bool meets(const Node& inner, std::size_t slot) const;
  void open_children(NodeNumber number, const Node& inner, std::vector<Unread>& open) const;

  NodeSource& source_;
  Interrupt& interrupt_;
  Box<D> question_;
  Horizon horizon_;
  Vec<D> margin_;
  std::vector<Unread> open_;
};

}  // namespace foresee
