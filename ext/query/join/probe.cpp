#include "query/join/probe.h"

#include "base/axes.h"
#include "base/float_environment.h"
#include "index/tpr_tree/search/window_walk.h"
#include "query/join/question.h"
#include "query/join/tile_scenes.h"
#include "shape/swept_boxes.h"

namespace foresee {
namespace {

/// Accepts what may meet the object; nothing if all may.
std::optional<KindTest> partners_of(const Scene& one, const Layout& others) {
  if (!has_kinds(one.layout) && !has_kinds(others)) return {};
  const Bodies body = one.bodies();
  return KindTest::of_partners(kinds_of(body.row(0), body.at));
}

template <int D>
void walk(const Scene& one, NodeSource& tree, const Horizon& horizon, const Contact::Reach& reach,
          Interrupt& interrupt, const std::function<bool(std::int64_t)>& keep, Scene& near) {
  const Bodies body = one.bodies();
  // The object's box is inflated by one half of the reach, those in the tree by the other.
  const Vec<D> margin = margin_of<D>(reach);
  WindowWalk<D> found(tree, moving_box<D>(body, 0, horizon, margin), horizon, margin, interrupt,
                      partners_of(one, tree.layout()));
  const auto record_size = static_cast<std::size_t>(record_offsets(near.layout).size);
  for (LeafHits hits; found.next(hits);)
    for (const std::uint32_t slot : hits.slots)
      if (const std::int64_t id = hits.leaf->keys[slot]; keep(id))
        near.add(id, hits.leaf->values.data() + slot * record_size);
}

}  // namespace

std::shared_ptr<const Scene> objects_near(const Scene& one, NodeSource& tree, const std::string& name,
                                          const Horizon& horizon, const Contact::Reach& reach,
                                          Interrupt& interrupt,
                                          const std::function<bool(std::int64_t)>& keep) {
  const FloatEnvironment environment;
  auto near = std::make_shared<Scene>();
  near->name = name, near->layout = tree.layout();
  if (one.size() == 0) return near;
  with_axes(near->layout.axes,
            [&]<int D>(Axes<D>) { walk<D>(one, tree, horizon, reach, interrupt, keep, *near); });
  near->take_forms(tree.forms(), interrupt);
  return near;
}

void take_object_and_near(const JoinedTables& tables, const QueriedIds& ids, JoinQuestion& question,
                          Interrupt& interrupt) {
  const bool by_a = ids.a.has_value();
  if (tables.a->layout().has_plan || tables.last().layout().has_plan) {
    question.only_a = ids.a, question.only_b = ids.b;
    take_scenes(tables, question, interrupt);
    return require_valid(question);
  }
  const std::int64_t id = by_a ? *ids.a : *ids.b;
  TableSource &one = by_a ? *tables.a : tables.last(), &others = by_a ? tables.last() : *tables.a;
  std::shared_ptr<const Scene>&object = by_a ? question.a : question.b,
                        &near = by_a ? question.b : question.a;
  object = one.objects(std::span(&id, 1));
  near = empty_scene(others);
  require_valid(question);
  const auto keep = [&](std::int64_t other) {
    if (tables.are_one()) return other != id;
    return tables.b != nullptr || (by_a ? id < other : other < id);
  };
  near = objects_near(*object, *others.tree(), others.name(), {question.now, question.h},
                      contact_of(question)->reach(), interrupt, keep);
  question.method = JoinMethod::scan;
  if (by_a) question.only_b = ids.b;
}

}  // namespace foresee
