// One side of a tree join: the moving boxes of its objects and nodes during this horizon.
#pragma once

#include <vector>

#include "index/tpr_tree/near_objects.h"
#include "index/tpr_tree/tree_join.h"
#include "shape/swept_boxes.h"

namespace foresee {

template <int D>
class JoinSide {
 public:
  JoinSide(const Bodies& bodies, const TreeLevels& levels, const Horizon& horizon, const Vec<D>& margin,
           Interrupt& interrupt)
      : starts_(levels.starts) {
    boxes_.resize(starts_.size() + 1);
    boxes_[0].reserve(bodies.count);
    for (std::size_t i = 0; i < bodies.count; ++i) {
      if (i % 1024 == 0) interrupt.check();
      boxes_[0].push_back(moving_box<D>(bodies, i, horizon, margin));
    }
    for (std::size_t level = 0; level < starts_.size(); ++level)
      for (std::size_t i = 0; i + 1 < starts_[level].size(); ++i)
        boxes_[level + 1].push_back(around(level, i));
    for (std::size_t kind = 0; kind < std::min<std::size_t>(2, boxes_.size()); ++kind)
      for (std::uint32_t i = 0; i < boxes_[kind].size(); ++i)
        swept_[kind].add(i, boxes_[kind][i], boxes_[kind][i].span);
  }

  /// Level 0: leaves.
  std::size_t levels() const { return starts_.size(); }
  const MovingBox<D>& node(std::size_t level, std::uint32_t i) const { return boxes_[level + 1][i]; }
  const MovingBox<D>& object(std::uint32_t row) const { return boxes_[0][row]; }
  /// Where objects, and leaves, are during the whole horizon.
  const NearObjects<D>& swept_objects() const { return swept_[0]; }
  const NearObjects<D>& swept_leaves() const { return swept_[1]; }
  /// What node i holds: rows if it is a leaf, else nodes one level down.
  std::uint32_t first(std::size_t level, std::uint32_t i) const { return starts_[level][i]; }
  std::uint32_t last(std::size_t level, std::uint32_t i) const { return starts_[level][i + 1]; }
  /// The boxes of what a node of this level holds.
  const std::vector<MovingBox<D>>& held(std::size_t level) const { return boxes_[level]; }

 private:
  MovingBox<D> around(std::size_t level, std::size_t i) const {
    const Vec<D> most = Vec<D>::Constant(std::numeric_limits<double>::infinity());
    MovingBox<D> all{most, -most, most, -most, {most[0], -most[0]}};
    for (std::uint32_t child = starts_[level][i]; child < starts_[level][i + 1]; ++child) {
      const MovingBox<D>& box = boxes_[level][child];
      if (box.span.is_empty()) continue;
      all.lower = all.lower.min(box.lower), all.upper = all.upper.max(box.upper);
      all.v_lower = all.v_lower.min(box.v_lower), all.v_upper = all.v_upper.max(box.v_upper);
      all.span = {std::min(all.span.begin, box.span.begin), std::max(all.span.end, box.span.end)};
    }
    return all;
  }

  std::vector<std::vector<std::uint32_t>> starts_;
  NearObjects<D> swept_[2];
  std::vector<std::vector<MovingBox<D>>> boxes_;  ///< [0]: objects, [k + 1]: nodes of level k
};

}  // namespace foresee
