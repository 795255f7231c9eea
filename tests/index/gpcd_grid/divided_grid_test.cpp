// A grid visited by several threads has the candidates of the grid, in its order.
#include <gtest/gtest.h>

#include <thread>

#include "base/parallel.h"
#include "index/candidate_pairs.h"
#include "index/gpcd_grid/gpcd_grid.h"
#include "index/gpcd_grid/grid.h"

namespace foresee::testing {
namespace {

/// The concatenated candidates of all partitions, from threads that take every third partition.
std::vector<Pair> from_three_threads(DividedCandidates& grid) {
  std::vector<std::vector<Pair>> parts(grid.parts());
  run_together(2, never, [&](std::size_t mine, std::size_t threads, Interrupt& interrupt) {
    for (std::size_t i = mine; i < parts.size(); i += threads) parts[i] = drain(*grid.part(i, interrupt));
  });
  std::vector<Pair> all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

template <int D>
void expect_same(SceneKind kind, std::size_t count) {
  const auto scene_of_seed = [&](std::uint64_t seed) {
    return random_scene({.layout = {.axes = D, .law = Law::accelerated, .shape = Shape::box, .has_t = true},
                         .kind = kind,
                         .count = count,
                         .seed = seed});
  };
  const RandomScene one = scene_of_seed(1), other = scene_of_seed(2);
  const MovingBoxes<D> a{one.bodies(), one.horizon(), Vec<D>::zero()};
  const MovingBoxes<D> b{other.bodies(), one.horizon(), Vec<D>::zero()};
  for (const MovingBoxes<D>* second : {static_cast<const MovingBoxes<D>*>(nullptr), &b}) {
    const auto divided = make_divided_grid<D>(a, second, 2, never, nullptr);
    EXPECT_GE(divided->parts(), D > 1 ? 3u : 1u) << name_of(kind);
    EXPECT_EQ(from_three_threads(*divided), drain(*make_gpcd_grid<D>(a, second, never))) << name_of(kind);
  }
}

TEST(DividedGrid, HasTheCandidatesOfTheGridInItsOrder) {
  for (SceneKind kind : {SceneKind::uniform, SceneKind::one_giant, SceneKind::one_fast}) {
    expect_same<1>(kind, 20000);
    expect_same<2>(kind, 30000);
    expect_same<3>(kind, 20000);
  }
}

/// Compares the counts computed at once with those of a visit, stripe by stripe.
template <int D>
void expect_crossings_counted() {
  const RandomScene scene = random_scene(
      {.layout = {.axes = D, .law = Law::uniform, .shape = Shape::box}, .count = 3000, .seed = 5});
  std::vector<double> rows = scene.rows;
  const Offsets at = row_offsets(scene.layout);
  for (std::size_t i = 0; i < 3000; i += 50)
    for (int axis = 0; axis < D; ++axis)
      rows[i * static_cast<std::size_t>(at.size) + static_cast<std::size_t>(at.half + axis)] *=
          axis == static_cast<int>(i) % D ? 300 : 10;
  const MovingBoxes<D> boxes{Bodies(scene.layout, rows.data(), 3000), scene.horizon(), Vec<D>::zero()};
  gpcd::Grid<D> grid(boxes, nullptr, nullptr, 0, never);
  const gpcd::Partition<D>& partition = grid.partition();
  const std::vector<std::size_t> counts = grid.side(0).giants.crossing_counts(partition);
  ASSERT_EQ(counts.size(), partition.stripes());
  gpcd::Giants<D> giants = grid.side(0).giants;
  EXPECT_GE(grid.giant_count(), 30u);
  std::size_t all = 0, number = 0;
  const int rows_of_stripes = D > 1 ? partition.axis[D > 1].count : 1;
  const int across = D > 2 ? partition.axis[D - 1].count : 1;
  for (int y = 0; y < rows_of_stripes; ++y)
    for (int z = 0; z < across; ++z, ++number) {
      int stripe[D] = {};
      if (D > 1) stripe[D > 1] = y;
      if (D > 2) stripe[D - 1] = z;
      EXPECT_EQ(counts[number], giants.crossing(stripe).size()) << number;
      all += counts[number];
    }
  EXPECT_GE(all, grid.giant_count());
}

TEST(DividedGrid, CountsTheGiantsThatCrossEachStripe) {
  expect_crossings_counted<1>();
  expect_crossings_counted<2>();
  expect_crossings_counted<3>();
}

TEST(DividedGrid, HasNoCandidatesWithoutObjects) {
  const Bodies none{Layout{.axes = 2}, nullptr, 0};
  const auto divided = make_divided_grid<2>({none, {0, 1}, Vec<2>::zero()}, nullptr, 2, never, nullptr);
  EXPECT_TRUE(from_three_threads(*divided).empty());
}

TEST(Together, DoesEveryPartOnceAndThrowsWhatAPartThrows) {
  for (std::size_t helpers : {0u, 1u, 3u}) {
    std::vector<int> done(helpers + 1);
    run_together(helpers, never, [&](std::size_t part, std::size_t parts, Interrupt&) {
      EXPECT_EQ(parts, helpers + 1);
      ++done[part];
    });
    EXPECT_EQ(done, std::vector<int>(helpers + 1, 1));
    for (std::size_t bad = 0; bad <= helpers; ++bad)
      EXPECT_THROW(run_together(helpers, never,
                                [bad](std::size_t part, std::size_t, Interrupt& interrupt) {
                                  if (part == bad) throw std::bad_alloc();
                                  if (bad == 0 && part > 0)
                                    for (;;) interrupt.check();  // stopped because another part failed
                                }),
                   std::bad_alloc);
  }
}

}  // namespace
}  // namespace foresee::testing
