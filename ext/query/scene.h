// Snapshot of all objects of one table, as a query reads them.
//
//   Scene fleet{.name = "ships", .layout = layout, .ids = {7}, .rows = {0, 0, 6, 0, 30}};        // x, y, vx, vy, r
//   check_numbers(fleet);                                       // once per fill, unless the numbers are known
//
// A scene is immutable once it is filled and a query has read it. All cursors that read it share it, so rows do not
// change under a loop that updates the table. Fill another scene for other numbers. A change in place needs a reset of
// `kinds`. Ids are unique; rows are in no particular order. With plans ids repeat: the legs of an object are rows with
// its id, adjacent and in order of time.
//
// Requires: numbers as check_numbers() has them. A query does not look at them: with NaN, with an infinity or with a
// negative radius its pairs are wrong. It does compare the sizes of `ids` and `rows`.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "index/chunk_source.h"
#include "index/pages.h"
#include "index/tpr_tree/search/tree_join.h"
#include "motion/plan/plan.h"
#include "shape/bodies.h"
#include "shape/kinds.h"
#include "shape/turned_forms.h"

namespace foresee {

struct SceneKinds;

/// Rows `first` to `last` - 1 of a scene.
struct RowRange {
  std::size_t first, last;

  std::size_t size() const { return last - first; }
};

/// What a query needs of a table's objects; by default all of them, without the tree.
struct SceneNeeds {
  /// The levels of the tree; not of a layout with plans, which has none in a scene.
  bool with_levels = false;
  LegTimes times = {};  ///< of a layout with plans: legs that exist at no time of these may be missing
  std::optional<Kinds> partner_kinds = {};  ///< objects that may meet none of these, or-ed, may be missing
};

struct Scene {
  std::string name = {};  ///< of the table, for messages
  Layout layout = {};
  std::vector<std::int64_t> ids = {};
  /// ids.size() rows of row_offsets(layout).size doubles, each finite. At most 2^32 - 1 rows.
  std::vector<double> rows = {};
  std::optional<TreeLevels> levels = {};  ///< for joins by the tree: rows are in leaf order
  std::unique_ptr<RowForms> forms = {};   ///< if the layout has outlines or meshes
  /// Cache of category and mask of all rows, kept by the first join that needs it (join/pair_kinds.h). It does not see
  /// a later change of them in `rows` unless this is reset. Requires: joins of a scene start one at a time.
  mutable std::shared_ptr<SceneKinds> kinds = {};
  /// Of a layout with plans: the first row of each object, ascending, then size(). Legs that do not exist during
  /// `legs_during` may be missing.
  std::vector<std::uint32_t> first_rows = {};
  LegTimes legs_during = {};

  std::size_t size() const { return ids.size(); }
  /// Objects are numbered in the order of their rows.
  std::size_t object_count() const {
    return !layout.has_plan ? size() : first_rows.empty() ? 0 : first_rows.size() - 1;
  }
  /// The legs of an object, in order of time; the one row of an object without a plan.
  RowRange rows_of(std::size_t object) const {
    if (!layout.has_plan) return {object, object + 1};
    return {first_rows[object], first_rows[object + 1]};
  }
  /// The legs of the object that has this row.
  RowRange legs_beside(std::size_t row) const {
    if (!layout.has_plan) return {row, row + 1};
    const auto next = std::upper_bound(first_rows.begin(), first_rows.end(), row);
    return {next[-1], *next};
  }
  Bodies bodies() const {
    Bodies bodies{layout, rows.data(), ids.size()};
    if (forms) forms->attach_to(bodies);
    return bodies;
  }
  /// Appends an object; its outline or mesh is not read. Requires: FloatEnvironment, because an acceleration is
  /// computed from the record, and an object without a plan.
  void add(std::int64_t id, const double* record) {
    if (layout.has_plan) return add(id, record, {});
    const auto row_size = static_cast<std::size_t>(row_offsets(layout).size);
    ids.push_back(id);
    rows.resize(rows.size() + row_size);
    row_from_record(layout, record, rows.data() + rows.size() - row_size);
  }
  /// Appends an object of a layout with plans; `legs`: of its plan, empty: it has none. A row for each leg that exists
  /// at some time of `legs_during`, up to `until` of the record, where the leg that lasts ends. Objects without such
  /// a leg are left out. Requires: as above.
  void add(std::int64_t id, const double* record, std::span<const Leg> legs);
  /// Sets `first_rows`, where the layout has plans, from ids that follow each other.
  void find_movers();
  /// Requires: all rows are in the scene. `source`: null for a layout without outlines and meshes.
  void take_forms(FormSource* source, Interrupt& interrupt) {
    if (!source) return;
    forms = std::make_unique<RowForms>();
    forms->assign(bodies(), *source, interrupt);
  }
};

/// Throws Error for the first number that a table would refuse, as "ships: row 7: r is -3; write a finite number >= 0".
/// Numbers must be finite (`until` may be +infinity), sizes not negative, kinds whole numbers below 2^32, and `until`
/// not before `t`. Cost: some nanoseconds per number.
void check_numbers(const Scene& scene);

// The objects that a query searches: all objects of a scene, or a snapshot of a tree.
//
//   SearchTarget ships{"ships", scene, nullptr};             // every object is tested
//   SearchTarget quays{"quays", nullptr, snapshot};          // nodes are read as the query needs them
//
// Both give the same rows. Exactly one of the two is set; a tree of a layout with plans has chunks beside it.

struct SearchTarget {
  std::string name = {};  ///< of the table, for messages
  std::shared_ptr<const Scene> scene = nullptr;
  std::shared_ptr<NodeSource> tree = nullptr;     ///< its walks find no object with a plan
  std::shared_ptr<ChunkSource> chunks = nullptr;  ///< the plans

  /// Requires: either is set.
  const Layout& layout() const { return scene ? scene->layout : tree->layout(); }
};

}  // namespace foresee
