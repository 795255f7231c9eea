// Results of a walk over a TPR-tree: the objects of one leaf that may match, and the moving box of a child
// node.
#pragma once

#include <memory>
#include <vector>

#include "index/tpr_tree/moving_box.h"
#include "index/tpr_tree/node.h"

namespace foresee {

/// Objects of one leaf that may be results. The leaf does not change while this holds it. leaf->keys[slot] is
/// an object's id; its record starts at leaf->values[slot * record size].
struct LeafHits {
  std::shared_ptr<const Node> leaf;
  std::vector<std::uint32_t> slots;
  std::vector<double> distances;  ///< set by NearestWalk only: a lower bound for each object, ascending
};

/// Requires: an inner node.
template <int D>
MovingBox<D> child_box(const Node& inner, std::size_t slot, const Horizon& horizon) {
  const Times times = times_at<D>(inner, slot);
  return moving_box<D>(bounds_at<D>(inner, slot), inner.epoch,
                       span_between(times.t_min, times.until_max, horizon), horizon);
}

}  // namespace foresee
