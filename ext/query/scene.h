// Snapshot of all objects of one table, as a query reads them.
//
// A scene is immutable once it is filled. All cursors that read it share it, so rows do not change under a
// loop that updates the table. Ids are unique; rows are in no particular order.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "index/pages.h"
#include "index/tpr_tree/search/tree_join.h"
#include "shape/bodies.h"
#include "shape/turned_forms.h"

namespace foresee {

struct SceneKinds;

struct Scene {
  std::string name;  ///< of the table, for messages
  Layout layout;
  std::vector<std::int64_t> ids;
  std::vector<double> rows;               ///< ids.size() rows of row_offsets(layout).size doubles
  std::optional<TreeLevels> levels = {};  ///< for joins by the tree: rows are in leaf order
  std::unique_ptr<RowForms> forms = {};   ///< if the layout has outlines or meshes
  /// Kept by the first join that needs it (join/pair_kinds.h). Requires: joins of a scene start one at a time.
  mutable std::shared_ptr<SceneKinds> kinds = {};

  std::size_t size() const { return ids.size(); }
  Bodies bodies() const {
    Bodies bodies{layout, rows.data(), ids.size()};
    if (forms) forms->attach_to(bodies);
    return bodies;
  }
  /// Appends an object; its outline or mesh is not read. Requires: FloatEnvironment, because an acceleration is
  /// computed from the record.
  void add(std::int64_t id, const double* record) {
    const auto row_size = static_cast<std::size_t>(row_offsets(layout).size);
    ids.push_back(id);
    rows.resize(rows.size() + row_size);
    row_from_record(layout, record, rows.data() + rows.size() - row_size);
  }
  /// Requires: all rows are in the scene. `source`: null for a layout without outlines and meshes.
  void take_forms(FormSource* source, Interrupt& interrupt) {
    if (!source) return;
    forms = std::make_unique<RowForms>();
    forms->assign(bodies(), *source, interrupt);
  }
};

// The objects that a query searches: all objects of a scene, or a snapshot of a tree.
//
//   SearchTarget ships{"ships", scene, nullptr};             // every object is tested
//   SearchTarget quays{"quays", nullptr, snapshot};          // nodes are read as the query needs them
//
// Both give the same rows. Exactly one of the two is set.

struct SearchTarget {
  std::string name;  ///< of the table, for messages
  std::shared_ptr<const Scene> scene;
  std::shared_ptr<NodeSource> tree;

  const Layout& layout() const { return scene ? scene->layout : tree->layout(); }
};

}  // namespace foresee
