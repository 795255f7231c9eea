// The cost of the grid in counts that are the same on every machine: entries, kernel steps, interrupt polls.
#include "index/candidate_pairs.h"
#include "index/gpcd_grid/grid.h"
#include "index/resting_bodies.h"
#include "stopping_interrupt.h"

namespace foresee::testing {
namespace {

template <int D>
std::vector<Box<D>> boxes_of(SceneKind kind, std::size_t count) {
  const Layout layout{D, Law::accelerated, Shape::box, false, false};
  const RandomScene scene = random_scene({layout, kind, count, 3});
  return swept_boxes<D>(scene.bodies(), scene.horizon(), Vec<D>::zero(), never);
}

struct Cost {
  std::size_t entries, giants, steps, candidates;
};

template <int D>
Cost cost_of(const std::vector<Box<D>>& boxes) {
  const RestingBodies<D> resting(boxes);
  const auto grid = std::make_shared<gpcd::Grid<D>>(resting.side(), nullptr, nullptr, 0, never);
  gpcd::GridVisit<D> visit(grid, never);
  const std::size_t candidates = drain(visit).size();
  return {grid->entry_count(), grid->giant_count(), visit.steps_taken(), candidates};
}

template <int D>
void expect_linear_in_objects() {
  const Cost small = cost_of<D>(boxes_of<D>(SceneKind::uniform, 5000));
  const Cost large = cost_of<D>(boxes_of<D>(SceneKind::uniform, 40000));
  EXPECT_LE(small.entries, 5000u * (D == 3 ? 4 : 2));
  EXPECT_LE(large.entries, 40000u * (D == 3 ? 4 : 2));
  EXPECT_LE(static_cast<double>(large.steps) / static_cast<double>(small.steps), 8 * 1.25);
}

TEST(GpcdGridCost, IsLinearInUniformScenes) {
  expect_linear_in_objects<1>();
  expect_linear_in_objects<2>();
  expect_linear_in_objects<3>();
}

/// One object that spans the space, or crosses it many times over, meets every other once; other counts
/// hardly change.
template <int D>
void expect_unmoved_by_one(SceneKind kind) {
  const Cost without = cost_of<D>(boxes_of<D>(SceneKind::uniform, 20000));
  const Cost with = cost_of<D>(boxes_of<D>(kind, 20000));
  EXPECT_EQ(with.giants, 1u);
  EXPECT_LE(with.entries, without.entries + without.entries / 20);
  EXPECT_LE(with.candidates, without.candidates + without.candidates / 20 + 20000);
  EXPECT_LE(with.steps, 2 * without.steps);
}

TEST(GpcdGridCost, HardlyGrowsWithOneGiant) {
  expect_unmoved_by_one<1>(SceneKind::one_giant);
  expect_unmoved_by_one<2>(SceneKind::one_giant);
  expect_unmoved_by_one<3>(SceneKind::one_giant);
}

TEST(GpcdGridCost, HardlyGrowsWithOneFastObject) {
  expect_unmoved_by_one<1>(SceneKind::one_fast);
  expect_unmoved_by_one<2>(SceneKind::one_fast);
  expect_unmoved_by_one<3>(SceneKind::one_fast);
}

TEST(GpcdGridCost, IsBoundedWhenAllAreAtOneSpot) {
  constexpr std::size_t count = 3000;
  const Cost cost = cost_of<2>(boxes_of<2>(SceneKind::one_spot, count));
  EXPECT_LE(cost.entries, 6 * count);
  // Each object shares a stripe with all others, so the steps are proportional to the number of pairs.
  EXPECT_LE(cost.steps * gpcd::lanes_max, 6 * count * (count - 1) / 2);
}

TEST(GpcdGridCost, IsMovedLittleByObjectsFarAway) {
  std::vector<Box<2>> boxes = boxes_of<2>(SceneKind::uniform, 20000);
  const Cost before = cost_of<2>(boxes);
  for (int i = 0; i < 5; ++i) {
    const auto far = static_cast<std::size_t>(i * 3000);
    const double offset = std::pow(10.0, 4 + 6 * i);
    boxes[far].lower += offset, boxes[far].upper += offset;
  }
  const Cost after = cost_of<2>(boxes);
  EXPECT_LE(after.entries, before.entries + before.entries / 10);
  EXPECT_LE(after.steps, before.steps + before.steps / 5);
}

/// Half of the objects are large: they are neither entered into all stripes nor compared with all objects.
TEST(GpcdGridCost, IsModerateWithTwoSizes) {
  Random random(5);
  std::vector<Box<2>> boxes;
  for (int i = 0; i < 40000; ++i) {
    Box<2> box;
    const double extent = i % 5 < 2 ? 40 : 0.5;
    box.lower = {random.in(0, 20000), random.in(0, 20000)};
    box.upper = box.lower + extent;
    boxes.push_back(box);
  }
  const Cost cost = cost_of<2>(boxes);
  EXPECT_LE(cost.entries, 3u * 40000);
  EXPECT_LE(cost.steps, 10u * 40000);
}

TEST(GpcdGridInterrupt, IsSeenDuringTheBuild) {
  const RestingBodies<2> resting(boxes_of<2>(SceneKind::uniform, 100000));
  const MovingBoxes<2> side = resting.side();
  for (int checks : {0, 1, 5, 20}) {
    StopAt stop(checks);
    EXPECT_THROW(gpcd::Grid<2>(side, nullptr, nullptr, 0, stop), Interrupted);
  }
}

TEST(GpcdGridInterrupt, IsSeenInEveryBatch) {
  const RestingBodies<2> resting(std::vector(20000, Box<2>{Vec<2>::zero(), Vec<2>::constant(1)}));
  const MovingBoxes<2> side = resting.side();
  StopAt stop(1000);
  gpcd::GridVisit<2> visit(std::make_shared<gpcd::Grid<2>>(side, nullptr, nullptr, 0, stop), stop);
  std::vector<Pair> batch;
  ASSERT_TRUE(visit.next(batch));
  stop.checks_left = 0;
  EXPECT_THROW(visit.next(batch), Interrupted);
}

/// Keys in any order, at few different places, with some far away.
TEST(GpcdGridKeys, AreSortedWhateverTheRange) {
  Random random(9);
  GridSpace::Visit::LaneMemory memory;
  const float inf = std::numeric_limits<float>::infinity(), max = std::numeric_limits<float>::max();
  for (std::size_t count : {0u, 1u, 5u, 12u, 13u, 100u, 3000u})
    for (const gpcd::Range& range : {gpcd::Range{-5, 5}, gpcd::Range{0, 0}, gpcd::Range{-max, max},
                                     gpcd::Range{1e-40F, 2e-40F}, gpcd::Range{7, 3}})
      for (double scale : {0.0, 1e-44, 3.0, 1e38}) {
        std::vector<gpcd::Key> keys;
        for (std::uint32_t i = 0; i < count; ++i) {
          const auto x = static_cast<float>(random.in(-1, 1) * scale);
          keys.push_back(gpcd::key_of(i % 50 == 7 ? max : i % 70 == 9 ? -max : i % 90 == 3 ? -inf : x, i));
        }
        const auto sorted = gpcd::sorted_along_x(keys, range, memory, never);
        std::sort(keys.begin(), keys.end());
        EXPECT_TRUE(std::equal(keys.begin(), keys.end(), sorted.begin(), sorted.end()));
      }
}

TEST(GpcdGridInterrupt, IsSeenWhileSortingWhatHasNoOrder) {
  Random random(8);
  std::vector<gpcd::Key> keys;
  for (int i = 0; i < 200000; ++i) keys.push_back(random.next());
  StopAt stop(3);
  EXPECT_THROW(gpcd::sort_keys(keys, stop), Interrupted);
  gpcd::sort_keys(keys, never);
  EXPECT_TRUE(std::is_sorted(keys.begin(), keys.end()));
}

}  // namespace
}  // namespace foresee::testing
