#include "query/avoid/intruders.h"

#include "base/axes.h"
#include "index/tpr_tree/search/window_walk.h"
#include "query/join/question.h"
#include "shape/kinds.h"
#include "shape/swept_boxes.h"

namespace foresee {
namespace {

/// The extents of the object; if its outline rotates with its course, those of all rotations.
template <int D>
Extents<D> extents_of_changed(const AvoidQuestion& question, const Changes& changes, const Bodies& own) {
  Extents<D> extents = extents_of<D>(own, 0);
  if (!turns_with_course(question, changes)) return extents;
  const double far = reach_of(extents).template head<std::min(D, 2)>().sum();
  for (int axis = 0; axis < std::min(D, 2); ++axis) extents.lower[axis] = -far, extents.upper[axis] = far;
  return extents;
}

/// A box around all changed motions, and when any of them exists.
template <int D>
MovingBox<D> box_around(const AvoidQuestion& question, const Changes& changes, const MotionSet<D>& all,
                        const Vec<D>& margin) {
  const OwnMotion& base = changes.reference();
  const Bodies own = question.own->bodies();
  const Extents<D> extents = extents_of_changed<D>(question, changes, own);
  const Horizon horizon{question.now, question.h};
  Bounds<D> bounds;
  for (int axis = 0; axis < D; ++axis) {
    const double x = base.x[static_cast<std::size_t>(axis)];
    bounds.x_lower[axis] = x + (all.place.min(axis) + extents.lower[axis] - margin[axis]);
    bounds.x_upper[axis] = x + (all.place.max(axis) + extents.upper[axis] + margin[axis]);
    bounds.v_lower[axis] = all.velocity.min(axis), bounds.v_upper[axis] = all.velocity.max(axis);
    bounds.a_lower[axis] = all.acceleration.min(axis), bounds.a_upper[axis] = all.acceleration.max(axis);
  }
  const auto pad = [](const Vec<D>& value) { return Vec<D>(value.abs() * rounding_pad + smallest_pad); };
  Vec<D> size = pad(bounds.x_lower) + pad(bounds.x_upper) + pad(reach_of(extents) + margin);
  for (int axis = 0; axis < D; ++axis)
    size[axis] += rounding_pad * std::abs(base.x[static_cast<std::size_t>(axis)]);
  bounds.x_lower = lower_end<D>(bounds.x_lower, size), bounds.x_upper = upper_end<D>(bounds.x_upper, size);
  bounds.v_lower = lower_end<D>(bounds.v_lower, pad(bounds.v_lower));
  bounds.v_upper = upper_end<D>(bounds.v_upper, pad(bounds.v_upper));
  bounds.a_lower = lower_end<D>(bounds.a_lower, pad(bounds.a_lower));
  bounds.a_upper = upper_end<D>(bounds.a_upper, pad(bounds.a_upper));
  const auto time = [&](double after, double outward) {
    return base.t + after + outward * rounding_pad * (std::abs(base.t) + std::abs(after));
  };
  const double begin = time(all.begin, -1), end = std::isfinite(all.end) ? time(all.end, 1) : all.end;
  if (grows(own.layout)) {
    const Vec<D> growth = growth_of<D>(own.layout.shape, own.row(0), own.at);
    bounds = with_growth<D>(bounds, growth, base.t - value_or(own.row(0), own.at.t, 0));
  }
  if (!is_finite(base)) bounds = Bounds<D>::everything();
  return moving_box<D>(bounds, base.t, span_between(begin, end, horizon), horizon);
}

template <int D>
void walk_tree(NodeSource& tree, const MovingBox<D>& box, const Horizon& horizon,
               std::optional<std::int64_t> itself, const KindTest& partners, Interrupt& interrupt,
               Scene& near) {
  WindowWalk<D> walk(tree, box, horizon, Vec<D>::Zero(), interrupt, partners);
  const auto record_size = static_cast<std::size_t>(record_offsets(near.layout).size);
  for (LeafHits hits; walk.next(hits);)
    for (const std::uint32_t slot : hits.slots)
      if (const std::int64_t id = hits.leaf->keys[slot]; id != itself)
        near.add(id, hits.leaf->values.data() + slot * record_size);
}

/// The same objects as from a tree: those whose boxes meet the box.
template <int D>
void walk_scene(const Scene& all, MovingBox<D> box, const Horizon& horizon,
                std::optional<std::int64_t> itself, const KindTest& partners, Interrupt& interrupt,
                Scene& near) {
  box.lower = lower_end<D>(box.lower, box.lower.abs() * rounding_pad);
  box.upper = upper_end<D>(box.upper, box.upper.abs() * rounding_pad);
  const Bodies bodies = all.bodies();
  for (std::size_t i = 0; i < bodies.count; ++i) {
    if (i % 1024 == 0) interrupt.check();
    if (!partners.accepts(kinds_of(bodies.row(i), bodies.at))) continue;
    const MovingBox<D> other = moving_box<D>(bodies, i, horizon, Vec<D>::Zero());
    SharedInterval span = shared_span(other, box);
    if (all.ids[i] == itself || span.is_empty() || !narrow_to_contact(other, box, span)) continue;
    near.ids.push_back(all.ids[i]);
    near.rows.insert(near.rows.end(), bodies.row(i), bodies.row(i) + bodies.at.size);
  }
}

}  // namespace

std::shared_ptr<const Scene> intruders(const AvoidQuestion& question, const Changes& changes,
                                       const QueriedChanges& queried, const SearchTarget& others,
                                       std::optional<std::int64_t> itself, const Contact::Reach& reach,
                                       Interrupt& interrupt) {
  auto near = std::make_shared<Scene>();
  near->name = others.name, near->layout = others.layout();
  const Horizon horizon{question.now, question.h};
  const Bodies own = question.own->bodies();
  const KindTest partners = KindTest::of_partners(kinds_of(own.row(0), own.at));
  with_axes(near->layout.axes, [&]<int D>(Axes<D>) {
    const MotionSet<D> all = changes.between<D>(queried.lo, queried.hi);
    const Vec<D> margin = 2 * margin_of<D>(reach);  // of both together
    const MovingBox<D> box = box_around<D>(question, changes, all, margin);
    if (others.scene)
      walk_scene<D>(*others.scene, box, horizon, itself, partners, interrupt, *near);
    else
      walk_tree<D>(*others.tree, box, horizon, itself, partners, interrupt, *near);
  });
  if (others.tree) near->take_forms(others.tree->forms(), interrupt);
  return near;
}

}  // namespace foresee
