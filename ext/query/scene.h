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

namespace foresee::query {

struct Scene {
  std::string name;  ///< what messages call it
  Layout layout;
  std::vector<std::int64_t> ids;
  std::vector<double> rows;               ///< ids.size() rows of row_offsets(layout).size doubles
  std::optional<TreeLevels> levels = {};  ///< where a join by the tree is asked: rows are in leaf order

  std::size_t size() const { return ids.size(); }
  Bodies bodies() const { return {layout, rows.data(), ids.size()}; }
};

}  // namespace foresee::query
