// Boxes of movers with plans: the hull of the boxes of their legs, by which every tiling gives each pair one owner.
#include <gtest/gtest.h>

#include <map>

#include "base/axes.h"
#include "base/float_environment.h"
#include "never_interrupt.h"
#include "query/join/join_scenes.h"
#include "query/join/tilings.h"
#include "query/plan_cases.h"
#include "query/tile/tile.h"

namespace foresee::testing {
namespace {

using MoverBoxes = std::map<std::int64_t, FlatBox>;

/// The plain answer: the hull of the swept boxes of all legs, one by one.
template <int D>
MoverBoxes plain_boxes(const Movers& movers, const Horizon& horizon, double within) {
  const FloatEnvironment environment;
  MoverBoxes boxes;
  for (const Mover& mover : movers.all) {
    const Scene legs = legs_as_rows(movers.layout, mover);
    for (const FlatBox& box : flat_boxes<D>(legs.bodies(), horizon, within)) {
      if (box.lower[0] > box.upper[0]) continue;  // it does not exist
      const auto [known, is_new] = boxes.emplace(mover.id, box);
      for (const int axis : {0, 1}) {
        known->second.lower[axis] = std::min(known->second.lower[axis], box.lower[axis]);
        known->second.upper[axis] = std::max(known->second.upper[axis], box.upper[axis]);
      }
    }
  }
  return boxes;
}

MoverBoxes plain_boxes(const Movers& movers, const Horizon& horizon, double within) {
  return with_axes(movers.layout.axes,
                   [&]<int D>(Axes<D>) { return plain_boxes<D>(movers, horizon, within); });
}

bool meet(const FlatBox& a, const FlatBox& b) {
  for (const int axis : {0, 1})
    if (a.upper[axis] < b.lower[axis] || b.upper[axis] < a.lower[axis]) return false;
  return true;
}

class BoxesOfMovers : public ::testing::TestWithParam<Layout> {};

TEST_P(BoxesOfMovers, AreTheHullOfTheLegs) {
  const int axes = std::min(GetParam().axes, 2);
  std::size_t found = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Movers movers = random_movers(GetParam(), PlanNumbers::thirds, 60, seed);
    const auto table = table_of(movers);
    for (const Horizon horizon : {Horizon{2, 0}, Horizon{-1, 6}, Horizon{5, 100}}) {
      const MoverBoxes wanted = plain_boxes(movers, horizon, 0.5);
      for (const bool queried : {false, true}) {
        SweepQuestion question{.tree = table->tree(), .now = horizon.now, .h = horizon.h, .within = 0.5};
        question.chunks = table->chunks();
        if (queried) question.queried = {{-no_end, 1, 2, no_end}};
        NeverInterrupt never;
        Sweep sweep(question, never);
        std::map<std::int64_t, SweepRow> rows;
        for (auto next = sweep.next(); !next.empty(); next = sweep.next())
          for (const SweepRow& row : next) ASSERT_TRUE(rows.emplace(row.id, row).second) << row.id;
        for (const auto& [id, box] : wanted) {
          if (queried && !(box.lower[0] <= 1 && box.upper[0] >= 2)) continue;
          ASSERT_TRUE(rows.contains(id)) << id;
          for (int axis = 0; axis < axes; ++axis) {
            EXPECT_EQ(rows[id].lower[static_cast<std::size_t>(axis)], box.lower[axis]);
            EXPECT_EQ(rows[id].upper[static_cast<std::size_t>(axis)], box.upper[axis]);
          }
        }
        for (const auto& [id, row] : rows) EXPECT_TRUE(wanted.contains(id)) << id;
        found += rows.size();
      }
    }
  }
  EXPECT_GT(found, 500u);
}

TEST_P(BoxesOfMovers, GiveEachPairOneOwner) {
  Random random(3);
  std::size_t owned = 0;
  for (std::uint64_t seed = 1; seed <= (sanitized ? 2 : 6); ++seed) {
    const Movers movers = random_movers(GetParam(), PlanNumbers::halves, 30, seed);
    const auto table = table_of(movers);
    const JoinQuestion whole{.a = table->all(), .now = 2, .h = 7, .within = 0.5};
    const MoverBoxes boxes = plain_boxes(movers, {whole.now, whole.h}, whole.within);
    std::vector<FlatBox> corners;
    for (const auto& [id, box] : boxes) corners.push_back(box);
    for (int i = 0; i < 4; ++i) {
      std::map<std::pair<std::int64_t, std::int64_t>, int> owners;
      for (const Tile& tile : random_tiling(corners, GetParam().axes, 6, random)) {
        NeverInterrupt never;
        JoinQuestion question = whole;
        question.tile = tile;
        question = in_tile(question, never);
        const Scene& scene = *question.a;
        for (std::size_t a = 0; a < scene.object_count(); ++a) {
          const auto rows = scene.rows_of(a);
          for (std::size_t row = rows.first; question.own && row < rows.last; ++row)
            ASSERT_EQ(question.own->a[row], question.own->a[rows.first]);
          for (std::size_t b = a + 1; b < scene.object_count(); ++b) {
            const Pair pair{static_cast<std::uint32_t>(rows.first),
                            static_cast<std::uint32_t>(scene.rows_of(b).first)};
            if (question.own && (question.own->a[pair.a] | question.own->a[pair.b]) != Tile::owned) continue;
            ++owners[std::minmax({scene.ids[pair.a], scene.ids[pair.b]})];
          }
        }
      }
      for (const auto& [a, box_a] : boxes)
        for (const auto& [b, box_b] : boxes)
          if (a < b && meet(box_a, box_b)) {
            ASSERT_EQ((owners[{a, b}]), 1) << a << ' ' << b;
            ++owned;
          }
    }
  }
  EXPECT_GT(owned, 100u);
}

INSTANTIATE_TEST_SUITE_P(Layouts, BoxesOfMovers, ::testing::ValuesIn(layouts_with_plans()));

}  // namespace
}  // namespace foresee::testing
