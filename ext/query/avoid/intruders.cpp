#include "query/avoid/intruders.h"

#include <unordered_map>
#include <utility>

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

/// Appends the rows of each object or leg that is found, once.
class Found {
 public:
  explicit Found(Scene& near, bool several_legs) : near_(near), several_legs_(several_legs) {}

  void start_leg() { rows_of_leg_.emplace_back(); }
  /// `add` appends the rows of what has this key.
  template <class Add>
  void take(std::int64_t key, std::unordered_map<std::int64_t, std::pair<std::size_t, std::size_t>>& known,
            const Add& add) {
    if (!several_legs_) return add();
    const auto [place, is_new] = known.try_emplace(key);
    if (is_new) {
      place->second.first = near_.size();
      add();
      place->second.second = near_.size();
    }
    for (std::size_t row = place->second.first; row < place->second.second; ++row)
      rows_of_leg_.back().push_back(static_cast<std::uint32_t>(row));
  }
  std::vector<std::vector<std::uint32_t>> rows_of_leg() {
    return several_legs_ ? std::move(rows_of_leg_) : std::vector<std::vector<std::uint32_t>>{};
  }

  std::unordered_map<std::int64_t, std::pair<std::size_t, std::size_t>> objects, chunks;

 private:
  Scene& near_;
  bool several_legs_;
  std::vector<std::vector<std::uint32_t>> rows_of_leg_;
};

template <int D>
void walk_tree(NodeSource& tree, const MovingBox<D>& box, const Horizon& horizon,
               std::optional<std::int64_t> itself, const KindTest& partners, Interrupt& interrupt,
               Scene& near, Found& found) {
  WindowWalk<D> walk(tree, box, horizon, Vec<D>::Zero(), interrupt, partners);
  const auto record_size = static_cast<std::size_t>(record_offsets(near.layout).size);
  for (LeafHits hits; walk.next(hits);)
    for (const std::uint32_t slot : hits.slots)
      if (const std::int64_t id = hits.leaf->keys[slot]; id != itself)
        found.take(id, found.objects, [&] { near.add(id, hits.leaf->values.data() + slot * record_size); });
}

/// The legs of plans near it.
template <int D>
void walk_chunks(ChunkSource& source, const MovingBox<D>& box, const Horizon& horizon,
                 std::optional<std::int64_t> itself, const KindTest& partners, Interrupt& interrupt,
                 Scene& near, Found& found) {
  std::vector<std::int64_t> numbers;
  WindowWalk<D> walk(source.tree(), box, horizon, Vec<D>::Zero(), interrupt, partners);
  for (LeafHits hits; walk.next(hits);)
    for (const std::uint32_t slot : hits.slots) numbers.push_back(hits.leaf->keys[slot]);
  Chunk chunk;
  for (const std::int64_t number : numbers)
    found.take(number, found.chunks, [&] {
      interrupt.check();
      source.read_chunk(number, chunk);
      if (chunk.object == itself) return;
      near.add(chunk.object, source.find_object(chunk.object).data(), chunk.legs);
    });
}

/// The same objects as from a tree: those whose boxes meet the box.
template <int D>
void walk_scene(const Scene& all, MovingBox<D> box, const Horizon& horizon,
                std::optional<std::int64_t> itself, const KindTest& partners, Interrupt& interrupt,
                Scene& near, Found& found) {
  box.lower = lower_end<D>(box.lower, box.lower.abs() * rounding_pad);
  box.upper = upper_end<D>(box.upper, box.upper.abs() * rounding_pad);
  const Bodies bodies = all.bodies();
  for (std::size_t i = 0; i < bodies.count; ++i) {
    if (i % 1024 == 0) interrupt.check();
    if (!partners.accepts(kinds_of(bodies.row(i), bodies.at))) continue;
    const MovingBox<D> other = moving_box<D>(bodies, i, horizon, Vec<D>::Zero());
    SharedInterval span = shared_span(other, box);
    if (all.ids[i] == itself || span.is_empty() || !narrow_to_contact(other, box, span)) continue;
    found.take(static_cast<std::int64_t>(i), found.objects, [&] {
      near.ids.push_back(all.ids[i]);
      near.rows.insert(near.rows.end(), bodies.row(i), bodies.row(i) + bodies.at.size);
    });
  }
}

}  // namespace

NearObjects intruders(const AvoidQuestion& question, const std::vector<std::unique_ptr<Changes>>& legs,
                      const QueriedChanges& queried, const SearchTarget& others,
                      std::optional<std::int64_t> itself, const Contact::Reach& reach, Interrupt& interrupt) {
  auto near = std::make_shared<Scene>();
  near->name = others.name, near->layout = others.layout();
  near->legs_during = {question.now, question.now + question.h};
  Found found(*near, legs.size() > 1);
  const Horizon horizon{question.now, question.h};
  const Bodies own = question.own->bodies();
  const KindTest partners = KindTest::of_partners(kinds_of(own.row(0), own.at));
  with_axes(near->layout.axes, [&]<int D>(Axes<D>) {
    const Vec<D> margin = 2 * margin_of<D>(reach);  // of both together
    for (const auto& leg : legs) {
      found.start_leg();
      const MotionSet<D> all = leg->between<D>(queried.lo, queried.hi);
      const MovingBox<D> box = box_around<D>(question, *leg, all, margin);
      if (others.scene) {
        walk_scene<D>(*others.scene, box, horizon, itself, partners, interrupt, *near, found);
        continue;
      }
      walk_tree<D>(*others.tree, box, horizon, itself, partners, interrupt, *near, found);
      if (others.chunks)
        walk_chunks<D>(*others.chunks, box, horizon, itself, partners, interrupt, *near, found);
    }
  });
  if (others.tree) near->take_forms(others.tree->forms(), interrupt);
  return {near, found.rows_of_leg()};
}

}  // namespace foresee
