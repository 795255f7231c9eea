#include "query/legs/leg_scene.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "base/axes.h"
#include "base/float_environment.h"
#include "base/interrupt_steps.h"
#include "index/tpr_tree/search/window_walk.h"
#include "query/legs/movers.h"
#include "shape/shapes.h"

namespace foresee {
LegTimes leg_times_of(const Horizon& horizon) {
  return {horizon.now, std::nextafter(horizon.now + horizon.h, no_end)};
}

RowRange rows_during(const Bodies& bodies, RowRange rows, const Horizon& horizon) {
  const Offsets& at = bodies.at;
  rows.first = first_row(rows.first, rows.last,
                         [&](std::size_t row) { return bodies.row(row)[at.until] >= horizon.now; });
  rows.last = first_row(rows.first, rows.last,
                        [&](std::size_t row) { return bodies.row(row)[at.t] - horizon.now > horizon.h; });
  return rows;
}

std::optional<std::size_t> row_at(const Bodies& bodies, RowRange rows, double time) {
  const Offsets& at = bodies.at;
  const std::size_t later =
      first_row(rows.first, rows.last, [&](std::size_t row) { return bodies.row(row)[at.t] > time; });
  if (later == rows.first || bodies.row(later - 1)[at.until] < time) return std::nullopt;
  return later - 1;
}

namespace {

/// The chunks that meet one of the boxes, by number: then those of an object are consecutive.
template <int D>
std::vector<std::int64_t> chunks_near(ChunkSource& chunks, std::span<const MovingBox<D>> boxes,
                                      const Horizon& horizon, const Vec<D>& margin, Interrupt& interrupt,
                                      const std::optional<KindTest>& test) {
  std::vector<std::int64_t> found;
  for (const MovingBox<D>& box : boxes) {
    WindowWalk<D> walk(chunks.tree(), box, horizon, margin, interrupt, test);
    for (LeafHits hits; walk.next(hits);)
      for (const std::uint32_t slot : hits.slots) found.push_back(hits.leaf->keys[slot]);
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

/// Selects the legs that may meet one of some boxes.
template <int D>
class LegFilter {
 public:
  LegFilter(std::span<const MovingBox<D>> boxes, const Layout& layout, const Horizon& horizon,
            const Vec<D>& margin)
      : layout_(layout),
        at_(record_offsets(layout)),
        horizon_(horizon),
        boxes_(boxes.begin(), boxes.end()),
        spans_(spans_of<D>(boxes)) {
    for (MovingBox<D>& box : boxes_) {  // as WindowWalk does
      const Vec<D> lower = box.lower - margin, upper = box.upper + margin;
      box.lower = lower_end<D>(lower, (box.lower.abs() + margin) * rounding_pad);
      box.upper = upper_end<D>(upper, (box.upper.abs() + margin) * rounding_pad);
    }
  }

  void keep_near(Chunk& chunk) const {
    const Extents<D> shape = extents_of<D>(layout_.shape, chunk.record.data(), at_);
    std::erase_if(chunk.legs, [&](const Leg& leg) {
      if (life_of(leg.t, leg.until, horizon_).none) return true;
      const MovingBox<D> box = moving_box<D>(motion_of<D>(leg), shape, horizon_, Vec<D>::zero());
      return !may_meet_one(box);
    });
  }

 private:
  /// A mover of many legs has many boxes, of which few exist while this one does.
  bool may_meet_one(const MovingBox<D>& box) const {
    return !spans_.find(box.span.begin, box.span.end, [&](std::size_t i) {
      SharedInterval span = shared_span(box, boxes_[i]);
      return span.is_empty() || !narrow_to_contact(box, boxes_[i], span);
    });
  }

  Layout layout_;
  Offsets at_;
  Horizon horizon_;
  std::vector<MovingBox<D>> boxes_;
  IntervalTree spans_;  ///< of the boxes
};

/// Calls use(id, record, legs) for each object of these chunks, with its legs that exist during `times` and that
/// `filter` keeps; null: all. Objects without such a leg are left out.
template <int D, class Use>
void for_each_object(ChunkSource& chunks, std::span<const std::int64_t> numbers, const LegTimes& times,
                     const LegFilter<D>* filter, Interrupt& interrupt, Use use) {
  Chunk chunk;
  std::int64_t object = 0;
  std::vector<double> record;
  std::vector<Leg> legs;
  const auto use_legs = [&] {
    if (!legs.empty()) use(object, record, legs);
    legs.clear();
  };
  Steps steps(interrupt);
  for (const std::int64_t number : numbers.first(std::min(chunks_ahead, numbers.size())))
    chunks.prefetch_chunk(number);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    steps.costly(256);
    if (i + chunks_ahead < numbers.size()) chunks.prefetch_chunk(numbers[i + chunks_ahead]);
    chunks.read_chunk(numbers[i], times, chunk);
    if (filter) filter->keep_near(chunk);
    if (chunk.legs.empty()) continue;
    if (chunk.object != object) use_legs();
    if (legs.empty()) {
      object = chunk.object;
      record.assign(chunk.record.begin(), chunk.record.end());
    }
    legs.insert(legs.end(), chunk.legs.begin(), chunk.legs.end());
  }
  use_legs();
}

/// Appends the legs of the chunks that meet one of `boxes` and whose objects `keep` accepts.
template <int D>
void add_legs_near(const SearchTarget& objects, std::span<const MovingBox<D>> boxes, const Horizon& horizon,
                   const Vec<D>& margin, Interrupt& interrupt, const std::optional<KindTest>& test,
                   const std::function<bool(std::int64_t id)>& keep, Scene& scene) {
  const FloatEnvironment environment;
  const auto found = chunks_near<D>(*objects.chunks, boxes, horizon, margin, interrupt, test);
  const LegFilter<D> filter(boxes, scene.layout, horizon, margin);
  for_each_object<D>(*objects.chunks, found, scene.legs_during, &filter, interrupt,
                     [&](std::int64_t id, std::span<const double> record, std::span<const Leg> legs) {
                       if (keep(id)) scene.add(id, record.data(), legs);
                     });
}

}  // namespace

void for_each_plan(ChunkSource& chunks, const Layout& layout, const Horizon& horizon, Interrupt& interrupt,
                   const std::function<void(const Scene& legs)>& use) {
  const FloatEnvironment environment;
  Scene scene;
  scene.layout = layout, scene.legs_during = leg_times_of(horizon);
  with_axes(layout.axes, [&]<int D>(Axes<D>) {
    const Vec<D> everywhere = Vec<D>::constant(no_end), zero = Vec<D>::zero();
    const MovingBox<D> box = moving_window<D>(-everywhere, everywhere, zero, horizon);
    const auto found = chunks_near<D>(chunks, {&box, 1}, horizon, zero, interrupt, {});
    for_each_object<D>(chunks, found, scene.legs_during, nullptr, interrupt,
                       [&](std::int64_t id, std::span<const double> record, std::span<const Leg> legs) {
                         scene.ids.clear();
                         scene.rows.clear();
                         scene.first_rows.clear();
                         scene.add(id, record.data(), legs);
                         if (scene.size() > 0) use(scene);
                       });
  });
}

template <int D>
void add_objects_near(const SearchTarget& objects, std::span<const MovingBox<D>> boxes,
                      const Horizon& horizon, const Vec<D>& margin, Interrupt& interrupt,
                      const std::optional<KindTest>& test, const std::function<bool(std::int64_t id)>& keep,
                      Scene& scene) {
  const auto record_size = static_cast<std::size_t>(record_offsets(scene.layout).size);
  std::unordered_set<std::int64_t> found;  // by several boxes
  for (const MovingBox<D>& box : boxes) {
    WindowWalk<D> walk(*objects.tree, box, horizon, margin, interrupt, test);
    for (LeafHits hits; walk.next(hits);)
      for (const std::uint32_t slot : hits.slots) {
        const std::int64_t id = hits.leaf->keys[slot];
        if (keep(id) && (boxes.size() == 1 || found.insert(id).second))
          scene.add(id, hits.leaf->values.data() + slot * record_size);
      }
  }
  if (objects.chunks) add_legs_near<D>(objects, boxes, horizon, margin, interrupt, test, keep, scene);
}

template <int D>
std::shared_ptr<const Scene> legs_near(const SearchTarget& objects, const MovingBox<D>& box,
                                       const Horizon& horizon, const Vec<D>& margin, Interrupt& interrupt,
                                       const std::optional<KindTest>& test) {
  auto scene = std::make_shared<Scene>();
  scene->name = objects.name;
  scene->layout = objects.layout();
  scene->legs_during = leg_times_of(horizon);
  add_legs_near<D>(
      objects, {&box, 1}, horizon, margin, interrupt, test, [](std::int64_t) { return true; }, *scene);
  scene->take_forms(objects.tree->forms(), interrupt);
  return scene;
}

#define FORESEE_OF_AXES(D)                                                                              \
  template std::shared_ptr<const Scene> legs_near<D>(const SearchTarget&, const MovingBox<D>&,          \
                                                     const Horizon&, const Vec<D>&, Interrupt&,         \
                                                     const std::optional<KindTest>&);                   \
  template void add_objects_near<D>(const SearchTarget&, std::span<const MovingBox<D>>, const Horizon&, \
                                    const Vec<D>&, Interrupt&, const std::optional<KindTest>&,          \
                                    const std::function<bool(std::int64_t)>&, Scene&)
FORESEE_OF_AXES(1);
FORESEE_OF_AXES(2);
FORESEE_OF_AXES(3);
#undef FORESEE_OF_AXES

}  // namespace foresee
