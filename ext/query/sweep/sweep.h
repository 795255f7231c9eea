// Swept bounding boxes of all objects during a horizon. predictive_sweep as a library call; tiles own pairs
// by these boxes (query/tile).
//
//   Sweep sweep({.tree = ships, .now = 600, .h = 600, .within = 926}, interrupt);
//   for (auto rows = sweep.next(); !rows.empty(); rows = sweep.next())
//     for (const SweepRow& row : rows) use(row.id, row.lower[0], row.upper[0]);
//
// Guarantee: every object that exists during [now, now + h] comes exactly once, with the box of swept_box()
// for sweep_margin(): where two objects touch, their closed boxes intersect. A box depends on the object's
// row and the query alone, whatever else the table holds. No corner is NaN; a corner that no double bounds is
// infinite. Bounds on the corners exclude some or all of the objects outside them, and no other. The box of an object
// with a plan is the hull of the boxes of its legs. Cost: the nodes that can hold such objects, and every chunk of a
// plan that exists during the horizon. Memory: one leaf, and the rows of objects with plans.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/error.h"
#include "index/pages.h"
#include "query/margin.h"
#include "query/scene.h"
#include "shape/bodies.h"

namespace foresee {

// Decoder of leaves into bodies, one leaf after another.
//
//   LeafBodies bodies(tree.layout());
//   while (auto leaf = walk.next()) swept_box<2>(bodies.of(*leaf), i, horizon, margin);
class LeafBodies {
 public:
  explicit LeafBodies(const Layout& layout)
      : layout_(layout),
        record_size_(static_cast<std::size_t>(record_offsets(layout).size)),
        row_size_(static_cast<std::size_t>(row_offsets(layout).size)) {}

  /// Rows in the order of the leaf's keys; without forms. Valid until the next call, and while the leaf is
  /// held.
  Bodies of(const Node& leaf) {
    if (record_size_ == row_size_) return {layout_, leaf.values.data(), leaf.size()};  // rows are records
    rows_.resize(leaf.size() * row_size_);
    for (std::size_t slot = 0; slot < leaf.size(); ++slot)
      row_from_record(layout_, leaf.values.data() + slot * record_size_, rows_.data() + slot * row_size_);
    return {layout_, rows_.data(), leaf.size()};
  }

 private:
  Layout layout_;
  std::size_t record_size_, row_size_;
  std::vector<double> rows_;
};

/// The distance by which a box is inflated on each side of every axis.
template <int D>
Vec<D> sweep_margin(double within, std::optional<double> within_z) {
  return margin_of<D>({within, std::max(within, within_z.value_or(0))});
}

/// Closed ranges of the queried corners of a box on one axis.
struct QueriedCorners {
  double lower_min, lower_max, upper_min, upper_max;
};

/// The hull of the swept boxes of an object's rows: of one row, or of the legs of a plan. Empty if the object does not
/// exist during the horizon.
template <int D>
Box<D> swept_box_of(const Bodies& bodies, RowRange rows, const Horizon& horizon, const Vec<D>& margin) {
  Box<D> hull = Box<D>::empty();
  for (std::size_t row = rows.first; row < rows.last; ++row) {
    const Box<D> box = swept_box<D>(bodies, row, horizon, margin);
    hull.lower = hull.lower.min(box.lower), hull.upper = hull.upper.max(box.upper);
  }
  return hull;
}

struct SweepQuestion {
  std::shared_ptr<NodeSource> tree = nullptr;  ///< must be set
  double now = 0;
  double h = 0;
  double within = 0;
  std::optional<double> within_z = {};
  std::vector<QueriedCorners> queried = {};       ///< for the first axes, in order
  std::shared_ptr<ChunkSource> chunks = nullptr;  ///< the plans, for a tree of a layout with plans
};

struct SweepRow {
  std::int64_t id;
  std::array<double, 3> lower, upper;  ///< unspecified on axes that are not declared
};

class Sweep {
 public:
  /// Throws Error if h, within or within_z is negative or not finite, if now is not finite, and for within_z
  /// without an axis z. Also without a tree. `interrupt` must outlive the sweep.
  Sweep(SweepQuestion question, Interrupt& interrupt);
  ~Sweep();

  /// The rows of the next leaf that has any; empty at the end. Valid until the next call. If it throws, as `interrupt`
  /// may, each later call throws Error.
  std::span<const SweepRow> next();

 private:
  class Leaves;
  template <int D>
  class LeavesOfAxes;

  std::unique_ptr<Leaves> leaves_;
  std::vector<SweepRow> rows_, plans_;  ///< of the last leaf; of the objects with plans, until they are given
  UnbrokenCalls unbroken_;
};

}  // namespace foresee
