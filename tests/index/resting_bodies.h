// Boxes as bodies at rest: input of the grid without motion.
//
//   RestingBodies<2> resting(boxes);
//   drain(*make_gpcd_grid<2>(resting.side(), nullptr, never));
//
// A body has a centre and half extents, so its box may differ from the given box by rounding; boxes() returns
// the bodies' boxes. An empty box becomes a body whose life has already ended.
#pragma once

#include <vector>

#include "index/gpcd_grid/gpcd_grid.h"
#include "shape/swept_boxes.h"

namespace foresee::testing {

template <int D>
class RestingBodies {
 public:
  explicit RestingBodies(const std::vector<Box<D>>& boxes) : count_(boxes.size()) {
    rows_.reserve(count_ * static_cast<std::size_t>(row_offsets(layout).size));
    for (const Box<D>& box : boxes) {
      const bool empty = box.is_empty();
      for (int k = 0; k < D; ++k) rows_.push_back(empty ? 0 : box.upper[k] / 2 + box.lower[k] / 2);
      for (int k = 0; k < D; ++k) rows_.push_back(empty ? 0 : box.upper[k] / 2 - box.lower[k] / 2);
      rows_.push_back(empty ? -1 : std::numeric_limits<double>::infinity());
    }
  }

  MovingBoxes<D> side() const { return {Bodies(layout, rows_.data(), count_), {0, 0}, Vec<D>::zero()}; }
  std::vector<Box<D>> boxes(Interrupt& interrupt) const {
    return swept_boxes<D>(side().bodies, {0, 0}, Vec<D>::zero(), interrupt);
  }

 private:
  static constexpr Layout layout{.axes = D, .law = Law::rest, .shape = Shape::box, .has_until = true};

  std::vector<double> rows_;  // centre, half extents, until
  std::size_t count_;
};

}  // namespace foresee::testing
