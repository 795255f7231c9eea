// What does a question see of a node? Children and objects as moving boxes, and what passed of one leaf.
#pragma once

#include <memory>
#include <vector>

#include "index/tpr_tree/moving_box.h"
#include "index/tpr_tree/node.h"

namespace foresee {

/// Objects of one leaf that may be part of the answer. The leaf stays as it was for as long as this is held:
/// leaf->keys[slot] is an object's id, its record stands at leaf->values[slot * record size].
struct LeafHits {
  std::shared_ptr<const Node> leaf;
  std::vector<std::uint32_t> slots;
  std::vector<double> distances;  ///< by NearestWalk only: the least possible one of each, ascending
};

/// Requires: an inner node.
template <int D>
MovingBox<D> child_box(const Node& inner, std::size_t slot, const Horizon& horizon) {
  const Times times = times_at<D>(inner, slot);
  return moving_box<D>(bounds_at<D>(inner, slot), inner.epoch,
                       span_between(times.t_min, times.until_greatest, horizon), horizon);
}

}  // namespace foresee
