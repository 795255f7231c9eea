// Larger joins of plans: many slabs, helper threads, limits, tiles, inert kinds and the counts of explain.
#include <gtest/gtest.h>

#include <set>

#include "query/join/explain.h"
#include "query/join/join_plan.h"
#include "query/join/pair_kinds.h"
#include "query/join/tilings.h"
#include "query/legs/leg_scenes.h"
#include "stopping_interrupt.h"

namespace foresee {
namespace {

using testing::LegWorld;
using testing::numbers_of;
using testing::random_movers;
using testing::rows_in_order;
using testing::sorted_rows;

NeverInterrupt leg_slabs_never;

/// A crowd with plans of some hundred seconds in a wide world.
JoinQuestion crowd(int movers, int legs, double side, std::uint64_t seed) {
  judge::Inputs inputs(seed);
  LegWorld world{.movers = movers, .max_legs = legs, .thirds = true, .side = side};
  world.layout.has_category = world.layout.has_mask = true;
  return {.a = random_movers(world, inputs), .now = 1, .h = 100, .wants = {.approach = false}};
}

std::size_t slabs_of_grid(JoinQuestion question) {
  question.method = JoinMethod::grid;
  const JoinQuestion prepared = with_kinds(question);
  return plan_join(prepared).slabs;
}

TEST(LegSlabs, OfManyLegsGiveTheRowsOfAScan) {
  JoinQuestion question = crowd(300, 60, 60, 71);
  EXPECT_GT(slabs_of_grid(question), 3u);
  for (const bool all : {false, true})
    for (const double min : {-HUGE_VAL, 20.0}) {
      question.all_contacts = all, question.queried_t.min = min;
      question.method = JoinMethod::scan;
      const std::vector<double> expected = numbers_of(sorted_rows(question));
      EXPECT_GT(expected.size(), 1000u);
      for (const JoinMethod method : {JoinMethod::grid, JoinMethod::tree, JoinMethod::gpcd})
        for (const JoinOrder order : {JoinOrder::any, JoinOrder::by_t_and_ids}) {
          question.method = method, question.order = order;
          EXPECT_TRUE(numbers_of(sorted_rows(question)) == expected) << name_of(method) << all << min;
        }
    }
}

/// Movers that go to and fro by a metre, a leg per second, in a square of this side.
std::shared_ptr<const Scene> shuttles(int movers, int legs, double side) {
  judge::Inputs inputs(76);
  auto scene = std::make_shared<Scene>();
  scene->layout = LegWorld().layout;
  const Offsets at = record_offsets(scene->layout);
  for (int mover = 0; mover < movers; ++mover) {
    std::vector<double> record(static_cast<std::size_t>(at.size));
    record[static_cast<std::size_t>(at.until)] = no_end, record[static_cast<std::size_t>(at.r)] = 0.25;
    std::vector<Leg> plan;
    const double x = inputs.between(0, 1000) * side / 1000, y = inputs.between(0, 1000) * side / 1000;
    for (int i = 0; i < legs; ++i)
      plan.push_back({.t = 1.0 * i,
                      .until = i + 1.0,
                      .x = {x + i % 2, y, 0},
                      .v = {i % 2 == 0 ? 1.0 : -1.0, 0, 0},
                      .a = {}});
    scene->add(mover, record.data(), plan);
  }
  return scene;
}

// Of many legs few exist in a slab: a sample of all legs would not say how many pairs of them meet.
TEST(LegSlabs, AreAsLongForALongHorizonAsForAShortOne) {
  JoinQuestion question{.a = shuttles(100, 4000, 80), .h = 300};
  const std::size_t few = slabs_of_grid(question);
  question.h = 4000;
  EXPECT_GT(few, 8u);
  EXPECT_GE(slabs_of_grid(question), 8 * few);
}

TEST(LegSlabs, WithHelpersGiveTheSameRowsInTheSameOrder) {
  JoinQuestion question = crowd(9000, 12, 500, 72);
  question.method = JoinMethod::grid, question.h = 4;
  for (const bool all : {false, true})
    for (const JoinOrder order : {JoinOrder::any, JoinOrder::by_t}) {
      question.all_contacts = all, question.order = order, question.helpers = 0;
      std::vector<JoinRow> alone = rows_in_order(question);
      for (JoinRow& row : alone) row.approach = {};
      EXPECT_GT(alone.size(), 1000u);
      question.helpers = 2;
      const JoinQuestion prepared = with_kinds(question);
      EXPECT_TRUE(plan_join(prepared).with_helpers);
      std::vector<JoinRow> together = rows_in_order(question);
      for (JoinRow& row : together) row.approach = {};
      EXPECT_TRUE(numbers_of(together) == numbers_of(alone));
    }
}

TEST(LegSlabs, InOrderOfTimeAReaderThatStopsGetsTheFirstRows) {
  JoinQuestion question = crowd(800, 40, 30, 73);
  question.method = JoinMethod::grid, question.order = JoinOrder::by_t_and_ids;
  std::vector<JoinRow> all = rows_in_order(question);
  ASSERT_GT(all.size(), 5000u);
  question.likely_rows = 10;
  std::vector<JoinRow> limited = rows_in_order(question);
  for (auto* rows : {&all, &limited})
    for (JoinRow& row : *rows) row.approach = {};
  EXPECT_TRUE(numbers_of(limited) == numbers_of(all));
}

TEST(LegSlabs, StopAtAnInterrupt) {
  JoinQuestion question = crowd(300, 60, 60, 74);
  for (const JoinMethod method : {JoinMethod::scan, JoinMethod::grid, JoinMethod::tree}) {
    question.method = method;
    testing::StopAt stop(20);
    Join join(question, stop);
    EXPECT_ANY_THROW({
      while (!join.next().empty()) {
      }
    }) << name_of(method);
  }
}

/// The boxes of movers, all legs together.
std::vector<testing::FlatBox> mover_boxes(const JoinQuestion& question) {
  std::vector<testing::FlatBox> boxes;
  const Scene& scene = *question.a;
  const auto legs = testing::flat_boxes<2>(scene.bodies(), {question.now, question.h}, question.within);
  for (const testing::RowRange& mover : testing::movers_of(scene)) {
    testing::FlatBox& box = boxes.emplace_back(legs[mover.first]);
    for (std::uint32_t row = mover.first; row < mover.last; ++row)
      for (int axis = 0; axis < 2; ++axis) {
        box.lower[axis] = std::min(box.lower[axis], legs[row].lower[axis]);
        box.upper[axis] = std::max(box.upper[axis], legs[row].upper[axis]);
      }
  }
  return boxes;
}

TEST(LegSlabs, TilesTogetherAreTheWholeJoin) {
  testing::Random random(75);
  for (int i = 0; i < 40; ++i) {
    JoinQuestion question = crowd(30, 12, 12, 76 + static_cast<std::uint64_t>(i));
    question.h = 8, question.all_contacts = i % 2 == 0;
    if (i % 3 == 0) question.b = question.a;
    const std::vector<double> whole = numbers_of(sorted_rows(question));
    const auto tiles = testing::random_tiling(mover_boxes(question), 2, 6, random);
    for (const JoinMethod method : {JoinMethod::scan, JoinMethod::grid, JoinMethod::tree}) {
      std::vector<JoinRow> rows;
      for (const Tile& tile : tiles) {
        question.tile = tile, question.method = method;
        const std::vector<JoinRow> some = sorted_rows(question);
        rows.insert(rows.end(), some.begin(), some.end());
      }
      question.tile.reset();
      std::sort(rows.begin(), rows.end(), [](const JoinRow& l, const JoinRow& r) {
        return std::tie(l.a, l.b, l.contact.t, l.contact.t_end) <
               std::tie(r.a, r.b, r.contact.t, r.contact.t_end);
      });
      EXPECT_TRUE(numbers_of(rows) == whole) << i << ' ' << name_of(method);
    }
  }
}

TEST(LegSlabs, InertMoversAreLeftOut) {
  judge::Inputs inputs(77);
  LegWorld world{.movers = 40, .side = 4};
  world.layout.has_category = world.layout.has_mask = true;
  JoinQuestion question{.a = random_movers(world, inputs), .h = 20, .wants = {.approach = false}};
  auto half = std::make_shared<Scene>();
  half->name = question.a->name, half->layout = question.a->layout, half->ids = question.a->ids;
  half->rows = question.a->rows, half->first_rows = question.a->first_rows;
  const Offsets at = row_offsets(half->layout);
  for (std::size_t row = 0; row < half->size(); ++row) {
    double* const numbers = half->rows.data() + row * static_cast<std::size_t>(at.size);
    const bool is_inert = half->ids[row] % 2 == 0;
    numbers[at.category] = is_inert ? 4 : 1, numbers[at.mask] = is_inert ? 0 : 1;
  }
  std::vector<JoinRow> expected = testing::plain_rows({.a = half, .h = 20, .wants = {.approach = false}});
  std::erase_if(expected, [](const JoinRow& row) { return row.a % 2 == 0 || row.b % 2 == 0; });
  ASSERT_FALSE(expected.empty());
  question.a = half;
  for (const JoinMethod method : {JoinMethod::scan, JoinMethod::grid, JoinMethod::tree, JoinMethod::gpcd}) {
    question.method = method;
    EXPECT_TRUE(numbers_of(sorted_rows(question)) == numbers_of(expected)) << name_of(method);
  }
}

TEST(LegSlabs, ExplainCountsLegsAndAtLastMovers) {
  for (int i = 0; i < 12; ++i) {
    JoinQuestion question = crowd(40, 12, 10, 90 + static_cast<std::uint64_t>(i));
    question.h = 10;
    if (i % 3 == 1) question.b = question.a;
    if (i % 3 == 2) question.b = crowd(20, 9, 10, 190 + static_cast<std::uint64_t>(i)).a;
    std::set<std::pair<std::int64_t, std::int64_t>> movers;
    for (const JoinRow& row : sorted_rows(question)) movers.emplace(row.a, row.b);
    for (const JoinMethod method : {JoinMethod::scan, JoinMethod::grid, JoinMethod::tree, JoinMethod::gpcd}) {
      question.method = method;
      const std::vector<ExplainRow> rows = explain_join(question, leg_slabs_never);
      ASSERT_EQ(rows.size(), 9u) << "kinds, seven stages and movers";
      EXPECT_STREQ(rows[8].stage, "movers");
      EXPECT_EQ(rows[8].after, movers.size()) << name_of(method);
      for (std::size_t stage = 1; stage < rows.size(); ++stage)
        EXPECT_EQ(rows[stage].before, rows[stage - 1].after) << stage;
      std::uint64_t pairs = 0;
      const Scene &a = *question.a, &b = question.b ? *question.b : a;
      for (std::size_t k = 0; k < a.size(); ++k)
        for (std::size_t l = question.b ? 0 : k + 1; l < b.size(); ++l)
          pairs += &a != &b || a.ids[k] != b.ids[l];
      EXPECT_EQ(rows[0].before, pairs);
    }
  }
}

}  // namespace
}  // namespace foresee
