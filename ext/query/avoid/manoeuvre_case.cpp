#include "query/avoid/manoeuvre_case.h"

#include "base/axes.h"
#include "contact/pair_rule.h"
#include "query/join/question.h"
#include "query/legs/leg_scene.h"
#include "query/margin.h"
#include "shape/kinds.h"
#include "shape/swept_boxes.h"

namespace foresee {
namespace {

template <int D>
Vec<D> pad_of(const Vec<D>& value) {
  return value.abs() * rounding_pad + smallest_pad;
}

/// Moves all bounds outward by rounding errors: by these of x, and by those of v and a.
template <int D>
void pad_bounds(Bounds<D>& bounds, const Vec<D>& pad_of_x) {
  bounds.x_lower = lower_end<D>(bounds.x_lower, pad_of_x);
  bounds.x_upper = upper_end<D>(bounds.x_upper, pad_of_x);
  bounds.v_lower = lower_end<D>(bounds.v_lower, pad_of<D>(bounds.v_lower));
  bounds.v_upper = upper_end<D>(bounds.v_upper, pad_of<D>(bounds.v_upper));
  bounds.a_lower = lower_end<D>(bounds.a_lower, pad_of<D>(bounds.a_lower));
  bounds.a_upper = upper_end<D>(bounds.a_upper, pad_of<D>(bounds.a_upper));
}

/// A box around all changed motions from lo to hi, and when any of them exists.
template <int D>
MovingBox<D> box_around(const ManoeuvreCase& manoeuvre, const Changes& changes, double lo, double hi,
                        const Vec<D>& margin) {
  const MotionSet<D> all = changes.between<D>(lo, hi);
  const OwnMotion& base = changes.reference();
  const Bodies own = manoeuvre.question.own_scene->bodies();
  Extents<D> extents = extents_of<D>(own, 0);
  if (turns_with_course(manoeuvre.question, changes)) {  // those of all rotations
    const double far = reach_of(extents).template first<std::min(D, 2)>().sum();
    for (int axis = 0; axis < std::min(D, 2); ++axis) extents.lower[axis] = -far, extents.upper[axis] = far;
  }
  const Horizon horizon{manoeuvre.question.now, manoeuvre.question.h};
  Bounds<D> bounds;
  for (int axis = 0; axis < D; ++axis) {
    const double x = base.x[static_cast<std::size_t>(axis)];
    bounds.x_lower[axis] = x + (all.place.min(axis) + extents.lower[axis] - margin[axis]);
    bounds.x_upper[axis] = x + (all.place.max(axis) + extents.upper[axis] + margin[axis]);
    bounds.v_lower[axis] = all.velocity.min(axis), bounds.v_upper[axis] = all.velocity.max(axis);
    bounds.a_lower[axis] = all.acceleration.min(axis), bounds.a_upper[axis] = all.acceleration.max(axis);
  }
  Vec<D> pad_of_x =
      pad_of<D>(bounds.x_lower) + pad_of<D>(bounds.x_upper) + pad_of<D>(reach_of(extents) + margin);
  for (int axis = 0; axis < D; ++axis)
    pad_of_x[axis] += rounding_pad * std::abs(base.x[static_cast<std::size_t>(axis)]);
  pad_bounds<D>(bounds, pad_of_x);
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
      : bodies_(scene.bodies()), horizon_(horizon), boxes_(boxes), spans_(spans_of<D>(boxes)) {
    for (MovingBox<D>& box : boxes_) {
      box.lower = lower_end<D>(box.lower, box.lower.abs() * rounding_pad);
      box.upper = upper_end<D>(box.upper, box.upper.abs() * rounding_pad);
    }
  }

  /// Calls use(number) for each box that the row meets, until it returns false. Returns false then.
  template <class Use>
  bool find_boxes(std::size_t row, Use use) const {
    const MovingBox<D> other = moving_box<D>(bodies_, row, horizon_, Vec<D>::zero());
    return spans_.find(other.span.begin, other.span.end, [&](std::size_t box) {
      SharedInterval span = shared_span(other, boxes_[box]);
      return span.is_empty() || !narrow_to_contact(other, boxes_[box], span) || use(box);
    });
  }
  bool has(std::size_t row) const {
    return !find_boxes(row, [](std::size_t) { return false; });
  }

 private:
  Bodies bodies_;
  Horizon horizon_;
  std::vector<MovingBox<D>> boxes_;
  IntervalTree spans_;
};

/// Reads a scene as a tree is searched: the objects whose boxes meet one of the boxes. For applications that have no
/// tree; SQL always gives one.
template <int D>
void walk_scene(const Scene& all, const RowsNear<D>& rows, std::optional<std::int64_t> itself,
                const KindTest& partners, Interrupt& interrupt, Scene& found) {
  const Bodies bodies = all.bodies();
  for (std::size_t i = 0; i < bodies.count; ++i) {
    if (i % 1024 == 0) interrupt.check();
    if (!partners.accepts(kinds_of(bodies.row(i), bodies.at)) || all.ids[i] == itself || !rows.has(i))
      continue;
    found.ids.push_back(all.ids[i]);
    found.rows.insert(found.rows.end(), bodies.row(i), bodies.row(i) + bodies.at.size);
  }
}

/// The distances at which the object touches another one.
PairRule::Reach reach_to(const AvoidQuestion& question, const SearchTarget& others) {
  return PairRule(question.own_scene->layout, others.layout(), question.within, question.within_z).reach();
}

/// `itself`: the object of this id is left out.
NearObjects find_near_objects(const ManoeuvreCase& manoeuvre, const SearchTarget& others,
                              std::optional<std::int64_t> itself, Interrupt& interrupt) {
  const AvoidQuestion& question = manoeuvre.question;
  const auto& legs = manoeuvre.changed.legs;
  NearObjects found;
  const auto scene = std::make_shared<Scene>();
  scene->name = others.name;
  scene->layout = others.layout();
  const Horizon horizon{question.now, question.h};
  scene->legs_during = leg_times_of(horizon);
  const Bodies own = question.own_scene->bodies();
  const KindTest partners = KindTest::of_partners(kinds_of(own.row(0), own.at));
  with_axes(scene->layout.axes, [&]<int D>(Axes<D>) {
    // Our boxes have the whole reach, so the tree adds none: margin_of() is half of it.
    const Vec<D> margin = 2 * margin_of<D>(reach_to(question, others)), none = Vec<D>::zero();
    const QueriedChanges& queried = manoeuvre.queried;
    std::vector<MovingBox<D>> boxes;
    for (const auto& leg : legs)
      boxes.push_back(box_around<D>(manoeuvre, *leg, queried.lo, queried.hi, margin));
    // A delay spares the objects that it touches at its stored start, with all legs: one may be near there alone.
    if (scene->layout.has_plan && legs[0]->starts_vary())
      for (const OwnMotion& motion : manoeuvre.changed.motions_at_start())
        boxes.push_back(box_around<D>(manoeuvre, *no_changes_of(motion), 0, 0, margin));
    if (others.scene) {
      walk_scene<D>(*others.scene, {*others.scene, horizon, boxes}, itself, partners, interrupt, *scene);
    } else {
      const auto is_other = [&](std::int64_t id) { return id != itself; };
      add_objects_near<D>(others, boxes, horizon, none, interrupt, partners, is_other, *scene);
    }
    if (legs.size() == 1) return;
    const RowsNear<D> rows(*scene, horizon, boxes);
    found.of_leg.resize(legs.size());
    for (std::uint32_t row = 0; row < scene->size(); ++row) {
      if (row % 1024 == 0) interrupt.check();
      rows.find_boxes(row, [&](std::size_t box) {
        if (box < legs.size()) found.of_leg[box].push_back(row);
        return true;
      });
    }
  });
  if (others.tree) scene->take_forms(others.tree->forms(), interrupt);
  found.scene = scene;
  return found;
}

}  // namespace

ManoeuvreCase manoeuvre_case(const AvoidQuestion& question, const OwnState& own,
                             const QueriedChanges& queried, Interrupt& interrupt) {
  ManoeuvreCase manoeuvre{question, own, queried, changed_legs(question, own, queried), false};
  manoeuvre.rotates_outline = turns_with_course(question, manoeuvre.first_leg());
  manoeuvre.near_objects.push_back(
      find_near_objects(manoeuvre, question.others, question.own_scene->ids[0], interrupt));
  if (question.also)
    manoeuvre.near_objects.push_back(find_near_objects(manoeuvre, *question.also, {}, interrupt));
  return manoeuvre;
}

}  // namespace foresee
