// What a question is asked about: all objects of one table as they were at one moment of the database.
//
// A scene is immutable once it is filled and shared by every cursor that reads it, so that rows do not change
// under a loop that updates the table. Ids are unique; rows are in no particular order.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "index/tpr_tree/tree_join.h"
#include "shape/bodies.h"
#include "shape/outline/turned_outlines.h"

namespace foresee::query {

struct Scene {
  std::string name;  ///< what messages call it
  Layout layout;
  std::vector<std::int64_t> ids;
  std::vector<double> rows;               ///< ids.size() rows of row_offsets(layout).size doubles
  std::optional<TreeLevels> levels = {};  ///< where a join by the tree is asked: rows are in leaf order
  std::unique_ptr<const TurnedOutlines> outlines = {};  ///< where the layout has any

  std::size_t size() const { return ids.size(); }
  Bodies bodies() const {
    Bodies bodies{layout, rows.data(), ids.size()};
    bodies.outlines = outlines.get();
    return bodies;
  }
  /// Once all rows are there. `source`: null for a layout without outlines.
  void take_outlines(OutlineSource* source, Interrupt& interrupt) {
    if (source) outlines = std::make_unique<const TurnedOutlines>(bodies(), *source, interrupt);
  }
};

}  // namespace foresee::query
