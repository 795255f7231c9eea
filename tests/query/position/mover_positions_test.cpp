// Positions and tracks of movers with plans: those of the leg that exists, at a joint of the later one.
#include <gtest/gtest.h>

#include <map>

#include "query/plan_cases.h"
#include "query/position/tracks.h"

namespace foresee::testing {
namespace {

/// By id: the later of the legs that exist at `time`.
std::map<std::int64_t, PositionRow> plain_positions(const Movers& movers, double time) {
  std::map<std::int64_t, PositionRow> all;
  for (const Mover& mover : movers.all) {
    auto rows = std::make_shared<Scene>(legs_as_rows(movers.layout, mover));
    Positions legs(rows, time);
    while (const auto row = legs.next()) all.insert_or_assign(mover.id, *row);
  }
  return all;
}

bool equal_rows(const PositionRow& a, const PositionRow& b) {
  return a.id == b.id && a.x == b.x && a.v == b.v;
}

class PositionsOfMovers : public ::testing::TestWithParam<Layout> {};

TEST_P(PositionsOfMovers, AreThoseOfTheLaterLeg) {
  std::size_t found = 0;
  for (const PlanNumbers numbers : {PlanNumbers::halves, PlanNumbers::thirds}) {
    const Movers movers = random_movers(GetParam(), numbers, 60, 5);
    const auto table = table_of(movers);
    for (int i = -10; i < 60; ++i) {
      const double time = i / (numbers == PlanNumbers::halves ? 4.0 : 3.0);
      const auto wanted = plain_positions(movers, time);
      for (const auto& scene : {table->all(), table->all({.times = {time, time}})}) {
        std::size_t rows = 0;
        Positions positions(scene, time);
        while (const auto row = positions.next()) {
          ASSERT_TRUE(wanted.contains(row->id) && equal_rows(*row, wanted.at(row->id)))
              << row->id << ' ' << time;
          ++rows;
        }
        ASSERT_EQ(rows, wanted.size()) << time;
        found += rows;
      }
    }
  }
  EXPECT_GT(found, 500u);
}

TEST_P(PositionsOfMovers, AtRegularTimesAreTracks) {
  const Movers movers = random_movers(GetParam(), PlanNumbers::thirds, 40, 6);
  const auto table = table_of(movers);
  NeverInterrupt never;
  Tracks tracks(table->all({.times = {0, 12}}), {.t0 = 0, .t1 = 12, .step = 1.0 / 3}, never);
  std::optional<TrackRow> row = tracks.next();
  std::size_t found = 0;
  while (row) {
    const double time = row->t;
    for (const auto& [id, wanted] : plain_positions(movers, time)) {
      ASSERT_TRUE(row && row->t == time && equal_rows(row->at, wanted)) << id << ' ' << time;
      row = tracks.next(), ++found;
    }
    ASSERT_TRUE(!row || row->t > time);
  }
  EXPECT_GT(found, 100u);
}

INSTANTIATE_TEST_SUITE_P(Layouts, PositionsOfMovers, ::testing::ValuesIn(layouts_with_plans()));

}  // namespace
}  // namespace foresee::testing
