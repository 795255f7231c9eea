// Search in a TPR-tree for objects whose swept boxes meet a box, leaf by leaf.
//
//   SweepWalk<2> walk(source, tile, horizon, margin, interrupt);
//   while (auto leaf = walk.next()) decide(*leaf);               // each object's own box decides
//
// A swept box is wider than the object's trajectory: its corners may be where the object never is. So this
// differs from a window query (window_walk.h), which finds the objects inside at one time.
//
// Guarantee: every object whose swept box, as swept_box() rounds it with `margin`, meets the query box is in
// exactly one of the leaves; the leaves may also contain other objects. An object that does not exist during
// the horizon may be omitted. Cost: the nodes whose swept bounds meet the query box. Between calls it holds
// node numbers, like a WindowWalk.
#pragma once

#include "base/error.h"
#include "index/tpr_tree/leaf_hits.h"

namespace foresee {

template <int D>
class SweepWalk {
 public:
  SweepWalk(NodeSource& source, const Box<D>& query, const Horizon& horizon, const Vec<D>& margin,
            Interrupt& interrupt);

  /// The next leaf, some of whose objects may meet the query box; null once no such leaf is left.
  std::shared_ptr<const Node> next();

  /// An estimate of the fraction of all objects that is in the leaves, from some nodes below the root; 1 for
  /// a small tree. Call it before next().
  double likely_share();

 private:
  bool meets(const Node& inner, std::size_t slot) const;
  void open_children(NodeNumber number, const Node& inner, std::vector<Unread>& open) const;

  NodeSource& source_;
  Interrupt& interrupt_;
  Box<D> query_;
  Horizon horizon_;
  Vec<D> margin_;
  std::vector<Unread> open_;
};

}  // namespace foresee
