// The objects of a leaf as bodies, one leaf after another.
//
//   LeafBodies bodies(tree.layout());
//   while (auto leaf = walk.next()) swept_box<2>(bodies.of(*leaf), i, horizon, margin);
#pragma once

#include <vector>

#include "index/pages.h"
#include "shape/bodies.h"

namespace foresee {

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

}  // namespace foresee
