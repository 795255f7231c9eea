// A table in memory with plans: its trees, its scenes, and the walks that leave out objects with plans.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "base/axes.h"
#include "base/float_environment.h"
#include "index/tpr_tree/search/nearest_walk.h"
#include "index/tpr_tree/search/window_walk.h"
#include "motion/position.h"
#include "query/plan_cases.h"
#include "query/sweep/sweep.h"

namespace foresee::testing {
namespace {

class MemoryPlansOf : public ::testing::TestWithParam<Layout> {};

std::map<std::int64_t, std::vector<double>> rows_by_id(const Scene& scene) {
  std::map<std::int64_t, std::vector<double>> rows;
  const auto size = static_cast<std::size_t>(row_offsets(scene.layout).size);
  for (std::size_t i = 0; i < scene.object_count(); ++i) {
    const auto range = scene.rows_of(i);
    const double* from = scene.rows.data() + range.first * size;
    EXPECT_TRUE(
        rows.emplace(scene.ids[range.first], std::vector<double>(from, from + range.size() * size)).second);
  }
  return rows;
}

/// The rows of the plain table that exist at some time of `times`.
std::map<std::int64_t, std::vector<double>> plain_rows_of(const Movers& movers, const LegTimes& times) {
  std::map<std::int64_t, std::vector<double>> rows;
  for (const Mover& mover : movers.all) {
    const Scene legs = legs_as_rows(movers.layout, mover);
    const Bodies bodies = legs.bodies();
    for (std::size_t i = 0; i < legs.size(); ++i)
      if (times.meet(bodies.row(i)[bodies.at.t], bodies.row(i)[bodies.at.until]))
        rows[mover.id].insert(rows[mover.id].end(), bodies.row(i), bodies.row(i) + bodies.at.size);
  }
  return rows;
}

TEST_P(MemoryPlansOf, HoldWhatWasPutLast) {
  PlanMaker maker(GetParam(), PlanNumbers::thirds, 1);
  MemoryTable table("robots", GetParam());
  std::map<std::int64_t, Mover> current;
  for (int i = 0; i < 400; ++i) {
    const auto id = static_cast<std::int64_t>(1 + maker.random.below(80));
    if (maker.random.below(4) == 0) {
      EXPECT_EQ(table.erase(id), current.erase(id) > 0);
      continue;
    }
    const Mover mover = maker.mover(id, maker.random.below(3) == 0);
    table.put(id, mover.record, mover.legs);
    current.insert_or_assign(id, mover);
  }
  Movers movers{GetParam(), {}};
  for (const auto& [id, mover] : current) movers.all.push_back(mover);
  EXPECT_EQ(rows_by_id(*table.all()), plain_rows_of(movers, {}));
  EXPECT_EQ(rows_by_id(*table.all({.times = {3, 5}})), plain_rows_of(movers, {3, 5}));
  double newest = -no_end;
  for (const Mover& mover : movers.all) newest = std::max(newest, mover.record[0]);
  EXPECT_EQ(table.newest_t(), newest);
  NeverInterrupt never;
  const Offsets at = record_offsets(GetParam());
  std::vector<std::int64_t> numbers;
  std::vector<double> records;
  collect_objects(table.chunks()->tree(), numbers, records, never);
  std::map<std::int64_t, double> left;  // chunks of an object that were not found yet
  Chunk chunk;
  for (const std::int64_t number : numbers) {
    table.chunks()->read_chunk(number, {}, chunk);
    --left.try_emplace(chunk.object, chunk.record[static_cast<std::size_t>(at.chunks)]).first->second;
  }
  for (const Mover& mover : movers.all) EXPECT_EQ(left.contains(mover.id), !mover.legs.empty());
  for (const auto& [id, chunks] : left) EXPECT_EQ(chunks, 0) << id;
}

template <int D>
std::set<std::int64_t> found_by_walks(NodeSource& tree, const Horizon& horizon) {
  NeverInterrupt never;
  const Vec<D> everywhere = Vec<D>::constant(no_end), zero = Vec<D>::zero();
  std::set<std::int64_t> by_window, by_distance, by_sweep;
  WindowWalk<D> window(tree, moving_window<D>(-everywhere, everywhere, zero, horizon), horizon, zero, never);
  NearestWalk<D> nearest(tree, zero, zero, horizon, never);
  LeafHits hits;
  while (window.next(hits))
    for (const auto slot : hits.slots) by_window.insert(hits.leaf->keys[slot]);
  while (nearest.next(no_end, hits))
    for (const auto slot : hits.slots) by_distance.insert(hits.leaf->keys[slot]);
  Sweep sweep({.tree = {std::shared_ptr<void>(), &tree}, .now = horizon.now, .h = horizon.h}, never);
  for (auto rows = sweep.next(); !rows.empty(); rows = sweep.next())
    for (const SweepRow& row : rows) by_sweep.insert(row.id);
  EXPECT_EQ(by_distance, by_window);
  EXPECT_EQ(by_sweep, by_window);
  return by_window;
}

TEST_P(MemoryPlansOf, AreLeftOutByWalksOfTheOtherTree) {
  const Movers movers = random_movers(GetParam(), PlanNumbers::halves, 300, 2);
  const auto table = table_of(movers);
  for (const Horizon horizon : {Horizon{1, 0}, Horizon{0, 5}, Horizon{-100, 1000}}) {
    std::set<std::int64_t> plain;
    for (const Mover& mover : movers.all) {
      const Bodies row(movers.layout, mover.record.data(), 1);
      if (mover.legs.empty() &&
          !life_of(mover.record[0], mover.record[static_cast<std::size_t>(row.at.until)], horizon).none)
        plain.insert(mover.id);
    }
    EXPECT_FALSE(plain.empty());
    with_axes(GetParam().axes,
              [&]<int D>(Axes<D>) { EXPECT_EQ(found_by_walks<D>(*table->tree(), horizon), plain); });
  }
}

/// At times of its life, every leg with the shape of its object is within the box of its chunk.
TEST_P(MemoryPlansOf, ChunksContainTheirLegs) {
  const Movers movers = random_movers(GetParam(), PlanNumbers::thirds, 200, 3);
  const auto table = table_of(movers);
  NeverInterrupt never;
  std::vector<std::int64_t> numbers;
  std::vector<double> items;
  collect_objects(table->chunks()->tree(), numbers, items, never);
  const Layout boxes = chunk_layout(GetParam());
  const Bodies all(boxes, items.data(), numbers.size());  // records of such a layout are rows
  Chunk chunk;
  std::size_t tested = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    table->chunks()->read_chunk(numbers[i], {}, chunk);
    Scene legs;
    legs.layout = GetParam();
    const FloatEnvironment environment;
    legs.add(chunk.object, chunk.record.data(), chunk.legs);
    const Bodies rows = legs.bodies();
    with_axes(boxes.axes, [&]<int D>(Axes<D>) {
      for (std::size_t row = 0; row < rows.count; ++row) {
        const Motion<D> leg = motion_of<D>(rows, row), item = motion_of<D>(all, i);
        EXPECT_TRUE(item.t <= leg.t && leg.until <= item.until);
        if (leg.until == no_end) continue;
        for (const double share : {0.0, 0.25, 0.5, 0.9375, 1.0}) {
          const double time = leg.t + share * (leg.until - leg.t);
          if (time > leg.until) continue;
          const Vec<D> x = state_at(leg, time).x, middle = state_at(item, time).x;
          const Extents<D> shape = extents_of<D>(rows, row), box = extents_of<D>(all, i);
          EXPECT_TRUE((middle + box.lower <= x + shape.lower + 1e-12).all() &&
                      (x + shape.upper <= middle + box.upper + 1e-12).all());
          ++tested;
        }
      }
    });
  }
  EXPECT_GT(tested, 1000u);
}

INSTANTIATE_TEST_SUITE_P(Layouts, MemoryPlansOf, ::testing::ValuesIn(layouts_with_plans()));

}  // namespace
}  // namespace foresee::testing
