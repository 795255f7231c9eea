#include "query/avoid/intruders.h"

#include "base/axes.h"
#include "query/join/question.h"
#include "query/legs/leg_scene.h"
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

/// The rows of a scene whose boxes meet one of the boxes.
template <int D>
class RowsNear {
 public:
  RowsNear(const Scene& scene, const Horizon& horizon, const std::vector<MovingBox<D>>& boxes)
      : bodies_(scene.bodies()), horizon_(horizon), boxes_(boxes) {
    for (MovingBox<D>& box : boxes_) {
      box.lower = lower_end<D>(box.lower, box.lower.abs() * rounding_pad);
      box.upper = upper_end<D>(box.upper, box.upper.abs() * rounding_pad);
    }
  }

  bool has(std::size_t row, std::size_t box) const {
    const MovingBox<D> other = moving_box<D>(bodies_, row, horizon_, Vec<D>::Zero());
    SharedInterval span = shared_span(other, boxes_[box]);
    return !span.is_empty() && narrow_to_contact(other, boxes_[box], span);
  }
  bool has(std::size_t row) const {
    for (std::size_t box = 0; box < boxes_.size(); ++box)
      if (has(row, box)) return true;
    return false;
  }

 private:
  Bodies bodies_;
  Horizon horizon_;
  std::vector<MovingBox<D>> boxes_;
};

/// The same objects as from a tree: those whose boxes meet one of the boxes.
template <int D>
void walk_scene(const Scene& all, const RowsNear<D>& rows, std::optional<std::int64_t> itself,
                const KindTest& partners, Interrupt& interrupt, Scene& near) {
  const Bodies bodies = all.bodies();
  for (std::size_t i = 0; i < bodies.count; ++i) {
    if (i % 1024 == 0) interrupt.check();
    if (!partners.accepts(kinds_of(bodies.row(i), bodies.at)) || all.ids[i] == itself || !rows.has(i))
      continue;
    near.ids.push_back(all.ids[i]);
    near.rows.insert(near.rows.end(), bodies.row(i), bodies.row(i) + bodies.at.size);
  }
}

}  // namespace

NearObjects intruders(const AvoidQuestion& question, const ChangedLegs& changed,
                      const QueriedChanges& queried, const SearchTarget& others,
                      std::optional<std::int64_t> itself, const Contact::Reach& reach, Interrupt& interrupt) {
  const auto& legs = changed.legs;
  auto near = std::make_shared<Scene>();
  NearObjects found;
  near->name = others.name, near->layout = others.layout();
  const Horizon horizon{question.now, question.h};
  near->legs_during = leg_times_of(horizon);
  const Bodies own = question.own->bodies();
  const KindTest partners = KindTest::of_partners(kinds_of(own.row(0), own.at));
  with_axes(near->layout.axes, [&]<int D>(Axes<D>) {
    const Vec<D> margin = 2 * margin_of<D>(reach), zero = Vec<D>::Zero();  // of both together
    std::vector<MovingBox<D>> boxes;
    for (const auto& leg : legs)
      boxes.push_back(box_around<D>(question, *leg, leg->between<D>(queried.lo, queried.hi), margin));
    // A delay spares the objects that it touches at its stored start, with all legs: one may be near there alone.
    if (near->layout.has_plan && legs[0]->starts_vary()) {
      for (const OwnMotion& motion : changed.at_stored_start()) {
        const auto stored = no_changes_of(motion);
        boxes.push_back(box_around<D>(question, *stored, stored->between<D>(0, 0), margin));
      }
    }
    if (others.scene) {
      walk_scene<D>(*others.scene, {*others.scene, horizon, boxes}, itself, partners, interrupt, *near);
    } else {
      const auto is_other = [&](std::int64_t id) { return id != itself; };
      add_objects_near<D>(others, boxes, horizon, zero, interrupt, partners, is_other, *near);
    }
    if (legs.size() == 1) return;
    const RowsNear<D> rows(*near, horizon, boxes);
    found.of_leg.resize(legs.size());
    for (std::size_t box = 0; box < legs.size(); ++box) {
      interrupt.check();
      for (std::uint32_t row = 0; row < near->size(); ++row)
        if (rows.has(row, box)) found.of_leg[box].push_back(row);
    }
  });
  if (others.tree) near->take_forms(others.tree->forms(), interrupt);
  found.scene = std::move(near);
  return found;
}

}  // namespace foresee
