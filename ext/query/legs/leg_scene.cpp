#include "query/legs/leg_scene.h"

#include <algorithm>
#include <cmath>

#include "base/axes.h"
#include "base/float_environment.h"
#include "index/tpr_tree/search/window_walk.h"

namespace foresee {
namespace {

/// The first row of `rows` for which `is_past` holds. Requires: it holds for all rows from one on.
template <class IsPast>
std::size_t first_row(RowRange rows, IsPast is_past) {
  while (rows.first < rows.last) {
    const std::size_t middle = rows.first + rows.size() / 2;
    if (is_past(middle))
      rows.last = middle;
    else
      rows.first = middle + 1;
  }
  return rows.first;
}

}  // namespace

LegTimes leg_times_of(const Horizon& horizon) {
  return {horizon.now, std::nextafter(horizon.now + horizon.h, no_end)};
}

RowRange rows_during(const Bodies& bodies, RowRange rows, const Horizon& horizon) {
  const Offsets& at = bodies.at;
  rows.first = first_row(rows, [&](std::size_t row) { return bodies.row(row)[at.until] >= horizon.now; });
  rows.last =
      first_row(rows, [&](std::size_t row) { return bodies.row(row)[at.t] - horizon.now > horizon.h; });
  return rows;
}

std::optional<std::size_t> row_at(const Bodies& bodies, RowRange rows, double time) {
  const Offsets& at = bodies.at;
  const std::size_t later = first_row(rows, [&](std::size_t row) { return bodies.row(row)[at.t] > time; });
  if (later == rows.first || bodies.row(later - 1)[at.until] < time) return std::nullopt;
  return later - 1;
}

namespace {

using ChunkNumbers = std::vector<std::int64_t>;

/// The numbers of the chunks that meet one of the boxes, in ascending order: then those of an object are consecutive.
template <int D>
ChunkNumbers chunks_near(ChunkSource& chunks, std::span<const MovingBox<D>> boxes, const Horizon& horizon,
                         const Vec<D>& margin, Interrupt& interrupt, const std::optional<KindTest>& test) {
  ChunkNumbers numbers;
  for (const MovingBox<D>& box : boxes) {
    WindowWalk<D> walk(chunks.tree(), box, horizon, margin, interrupt, test);
    for (LeafHits hits; walk.next(hits);)
      for (const std::uint32_t slot : hits.slots) numbers.push_back(hits.leaf->keys[slot]);
  }
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

/// Calls use(id, record, legs) for each object of these chunks.
template <class Use>
void for_each_object(ChunkSource& chunks, const ChunkNumbers& numbers, const LegTimes& times,
                     Interrupt& interrupt, Use use) {
  Chunk chunk;
  std::vector<Leg> legs;
  const auto use_legs = [&](std::int64_t id) {
    const std::span<const double> record = chunks.find_object(id);
    if (record.empty()) throw BrokenTree("a chunk of a plan belongs to no object");
    use(id, record, legs);
    legs.clear();
  };
  std::int64_t last = 0;
  for (const std::int64_t number : numbers) {
    interrupt.check();
    chunks.read_chunk(number, chunk);
    if (!legs.empty() && chunk.object != last) use_legs(last);
    last = chunk.object;
    std::copy_if(chunk.legs.begin(), chunk.legs.end(), std::back_inserter(legs),
                 [&](const Leg& leg) { return times.meet(leg.t, leg.until); });
  }
  if (!legs.empty()) use_legs(last);
}

}  // namespace

void for_each_plan(ChunkSource& chunks, const Layout& layout, const Horizon& horizon, Interrupt& interrupt,
                   const std::function<void(const Scene& legs)>& use) {
  const FloatEnvironment environment;
  const ChunkNumbers numbers = with_axes(layout.axes, [&]<int D>(Axes<D>) {
    const Vec<D> everywhere = Vec<D>::Constant(no_end), zero = Vec<D>::Zero();
    const MovingBox<D> box = moving_window<D>(-everywhere, everywhere, zero, horizon);
    return chunks_near<D>(chunks, {&box, 1}, horizon, zero, interrupt, {});
  });
  Scene scene;
  scene.layout = layout, scene.legs_during = leg_times_of(horizon);
  for_each_object(chunks, numbers, scene.legs_during, interrupt,
                  [&](std::int64_t id, std::span<const double> record, std::span<const Leg> legs) {
                    scene.ids.clear(), scene.rows.clear(), scene.first_rows.clear();
                    scene.add(id, record.data(), legs);
                    if (scene.size() > 0) use(scene);
                  });
}

template <int D>
void add_legs_near(const SearchTarget& objects, std::span<const MovingBox<D>> boxes, const Horizon& horizon,
                   const Vec<D>& margin, Interrupt& interrupt, const std::optional<KindTest>& test,
                   const std::function<bool(std::int64_t id)>& keep, Scene& scene) {
  const FloatEnvironment environment;
  const ChunkNumbers numbers = chunks_near<D>(*objects.chunks, boxes, horizon, margin, interrupt, test);
  for_each_object(*objects.chunks, numbers, scene.legs_during, interrupt,
                  [&](std::int64_t id, std::span<const double> record, std::span<const Leg> legs) {
                    if (keep(id)) scene.add(id, record.data(), legs);
                  });
}

template <int D>
std::shared_ptr<const Scene> legs_near(const SearchTarget& objects, const MovingBox<D>& box,
                                       const Horizon& horizon, const Vec<D>& margin, Interrupt& interrupt,
                                       const std::optional<KindTest>& test) {
  auto scene = std::make_shared<Scene>();
  scene->name = objects.name, scene->layout = objects.layout(), scene->legs_during = leg_times_of(horizon);
  add_legs_near<D>(
      objects, {&box, 1}, horizon, margin, interrupt, test, [](std::int64_t) { return true; }, *scene);
  scene->take_forms(objects.tree->forms(), interrupt);
  return scene;
}

#define FORESEE_OF_AXES(D)                                                                           \
  template std::shared_ptr<const Scene> legs_near<D>(const SearchTarget&, const MovingBox<D>&,       \
                                                     const Horizon&, const Vec<D>&, Interrupt&,      \
                                                     const std::optional<KindTest>&);                \
  template void add_legs_near<D>(const SearchTarget&, std::span<const MovingBox<D>>, const Horizon&, \
                                 const Vec<D>&, Interrupt&, const std::optional<KindTest>&,          \
                                 const std::function<bool(std::int64_t)>&, Scene&)
FORESEE_OF_AXES(1);
FORESEE_OF_AXES(2);
FORESEE_OF_AXES(3);
#undef FORESEE_OF_AXES

}  // namespace foresee
