#include "query/join/join_scenes.h"

#include <algorithm>

#include "base/axes.h"
#include "base/float_environment.h"
#include "base/interrupt_steps.h"
#include "motion/plan/chunks.h"
#include "query/legs/leg_scene.h"
#include "shape/swept_boxes.h"

namespace foresee {
namespace {

/// Accepts what may meet the object; nothing if all may.
std::optional<KindTest> partners_of(const Scene& one, const Layout& others) {
  if (!has_kinds(one.layout) && !has_kinds(others)) return {};
  const Bodies body = one.bodies();
  return KindTest::of_partners(kinds_of(body.row(0), body.at));
}

/// The ids of a scene's objects, ascending.
std::vector<std::int64_t> objects_in(const Scene& scene) {
  std::vector<std::int64_t> ids = scene.ids;
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

/// The leg of a row.
Leg leg_of(const Bodies& bodies, std::size_t i) {
  const double* const row = bodies.row(i);
  const Offsets& at = bodies.at;
  Leg leg{.t = row[at.t], .until = row[at.until], .x = {}, .v = {}, .a = {}};
  std::copy_n(row + at.x, bodies.layout.axes, leg.x.begin());
  std::copy_n(row + at.v, bodies.layout.axes, leg.v.begin());
  if (at.a != Offsets::absent) std::copy_n(row + at.a, bodies.layout.axes, leg.a.begin());
  return leg;
}

/// The moving boxes of an object during the horizon: of one row, or of chunks of its legs.
template <int D>
std::vector<MovingBox<D>> boxes_of(const Scene& one, const Horizon& horizon, const Vec<D>& margin,
                                   Interrupt& interrupt) {
  const Bodies bodies = one.bodies();
  if (bodies.count == 1) return {moving_box<D>(bodies, 0, horizon, margin)};
  std::vector<Leg> legs;
  const RowRange rows = rows_during(bodies, one.rows_of(0), horizon);
  Steps steps(interrupt);
  for (std::size_t row = rows.first; row < rows.last; ++row) {
    steps();
    legs.push_back(leg_of(bodies, row));
  }
  const Vec<D> reach = reach_of(extents_of<D>(bodies, 0));
  std::vector<MovingBox<D>> boxes;
  for (const ChunkRange& range : cut_into_chunks(legs)) {
    steps.costly(1000);
    const ChunkBox box = chunk_box(std::span(legs).subspan(range.first, range.count), D);
    Motion<D> chord{box.t, Vec<D>::zero(), Vec<D>::zero(), Vec<D>::zero(), box.until};
    Vec<D> half;
    for (int axis = 0; axis < D; ++axis) {
      const auto j = static_cast<std::size_t>(axis);
      chord.x[axis] = box.x[j];
      chord.v[axis] = box.v[j];
      half[axis] = sum_outward(box.half[j], reach[axis]);
    }
    boxes.push_back(moving_box<D>(chord, symmetric<D>(half), horizon, margin));
  }
  return boxes;
}

/// Adds to `near` the objects near `one`, by the tree of `others`.
template <int D>
void add_near(const Scene& one, const SearchTarget& others, const Horizon& horizon,
              const PairRule::Reach& reach, Interrupt& interrupt,
              const std::function<bool(std::int64_t)>& keep, Scene& near) {
  // The object's box is inflated by one half of the reach, those in the tree by the other.
  const Vec<D> margin = margin_of<D>(reach);
  const std::vector<MovingBox<D>> boxes = boxes_of<D>(one, horizon, margin, interrupt);
  add_objects_near<D>(others, boxes, horizon, margin, interrupt, partners_of(one, near.layout), keep, near);
}

/// Throws Error for a query that is invalid whatever objects the tables have, so that no tree is searched by an invalid
/// tile. The join checks the query again, with its scenes.
void require_valid_between(const JoinedTables& tables, JoinQuestion question) {
  question.a = empty_scene(*tables.a);
  if (tables.b) question.b = empty_scene(*tables.b);
  require_valid(question);
}

// Shares of all objects: above them the whole scene costs less than the nodes of a tile, read one by one.
constexpr double max_share = 0.5, max_share_if_cached = 0.1;

/// A scene of at least the objects that the tile needs, read through the tree. Null if the tile covers most
/// of the table: the caller then loads the whole scene, which stays cached for the next query.
std::shared_ptr<const Scene> scene_by_tree(TableSource& table, const JoinQuestion& question,
                                           Interrupt& interrupt) {
  const auto tree = table.tree();
  const double share = share_in_tile(*tree, question, interrupt);
  if (share > (table.is_loaded() ? max_share_if_cached : max_share)) return nullptr;
  return scene_of_tile(*tree, table.name(), question, interrupt);
}

/// Sets one side to the object of `only_a`, or else of `only_b`, and the other to the objects near it. Requires: one of
/// the two ids.
void load_object_and_near(const JoinedTables& tables, JoinQuestion& question, Interrupt& interrupt) {
  const bool by_a = question.only_a.has_value();
  std::optional<std::int64_t>& queried = by_a ? question.only_a : question.only_b;
  const std::int64_t id = queried.value();
  queried.reset();
  question.method = JoinMethod::scan;
  TableSource& one = by_a ? *tables.a : tables.side_b();
  TableSource& others = by_a ? tables.side_b() : *tables.a;
  std::shared_ptr<const Scene>& object = by_a ? question.a : question.b;
  std::shared_ptr<const Scene>& near = by_a ? question.b : question.a;
  const LegTimes times = leg_times_of({question.now, question.h});
  object = one.objects(std::span(&id, 1), times);
  near = empty_scene(others);
  require_valid(question);
  const auto keep = [&](std::int64_t other) {
    if (tables.are_one()) return other != id;
    return tables.b != nullptr || (by_a ? id < other : other < id);
  };
  near = objects_near(*object, trees_of(others), {question.now, question.h}, reach_of(question), interrupt,
                      keep);
  // The closest approach is that of all legs.
  if (near->layout.has_plan && question.wants.approach) near = others.objects(objects_in(*near), times);
  question.space = nullptr;  // a scan would only trim the memory of the last grid
}

}  // namespace

std::shared_ptr<const Scene> objects_near(const Scene& one, const SearchTarget& others,
                                          const Horizon& horizon, const PairRule::Reach& reach,
                                          Interrupt& interrupt,
                                          const std::function<bool(std::int64_t)>& keep) {
  const FloatEnvironment environment;
  auto near = std::make_shared<Scene>();
  near->name = others.name;
  near->layout = others.layout();
  near->legs_during = leg_times_of(horizon);
  if (one.size() == 0) return near;
  with_axes(near->layout.axes,
            [&]<int D>(Axes<D>) { add_near<D>(one, others, horizon, reach, interrupt, keep, *near); });
  near->take_forms(others.tree->forms(), interrupt);
  return near;
}

void load_scenes(const JoinedTables& tables, JoinQuestion& question, Interrupt& interrupt,
                 InertObjects inert) {
  const bool by_tree = question.method == JoinMethod::tree;
  if ((question.only_a || question.only_b) && (by_tree || question.method == JoinMethod::automatic))
    return load_object_and_near(tables, question, interrupt);
  if (question.tile) require_valid_between(tables, question);
  const SceneNeeds needs{.with_levels = by_tree, .times = leg_times_of({question.now, question.h})};
  const auto load_side = [&](TableSource& table, TableSource& others) {
    if (question.tile && !by_tree && !table.layout().has_plan)
      if (auto in_tile = scene_by_tree(table, question, interrupt)) return in_tile;
    return inert == InertObjects::counted ? table.all(needs) : scene_without_inert(table, others, needs);
  };
  question.a = load_side(*tables.a, tables.side_b());
  if (tables.b) question.b = tables.are_one() ? question.a : load_side(*tables.b, *tables.a);
}

}  // namespace foresee
