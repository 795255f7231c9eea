// The shape of trees of objects that exist for a limited time: they are separated in time, so a query reads few
// nodes of other times. Counted in nodes read.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "index/tpr_tree/reference_times.h"
#include "motion/plan/chunks.h"
#include "shape/chunk_item.h"
#include "tests/index/tpr_tree/schedule.h"
#include "tests/index/tpr_tree/tree_model.h"

namespace foresee {
namespace {

using testing::legs;
using testing::nodes_of_windows;
using testing::Random;
using testing::Schedule;
using testing::TreeModel;

enum class Writing { load, one_by_one, by_time, merged };

double nodes_of_schedule(const Schedule& schedule, Writing writing) {
  MemoryPages pages(legs);
  const auto tree = make_tpr_tree(pages, 60);
  NeverInterrupt never;
  if (writing == Writing::load) tree->bulk_load(schedule.ids, schedule.records, never);
  const std::vector<std::size_t> order = schedule.order(writing == Writing::by_time);
  if (writing == Writing::one_by_one || writing == Writing::by_time)
    for (const std::size_t i : order) tree->insert(schedule.ids[i], schedule.record(i));
  constexpr std::size_t together = 1500;
  for (std::size_t first = 0; writing == Writing::merged && first < order.size(); first += together) {
    std::vector<std::int64_t> ids;
    std::vector<double> records;
    for (std::size_t i = first; i < std::min(order.size(), first + together); ++i) {
      ids.push_back(schedule.ids[order[i]]);
      const auto record = schedule.record(order[i]);
      records.insert(records.end(), record.begin(), record.end());
    }
    tree->merge(ids, records, never);
  }
  EXPECT_TRUE(check_tree(pages, never).problems.empty());
  return nodes_of_windows(pages, schedule.side, 250);
}

TEST(TprTreeSchedules, AWindowOfAScheduleReadsLittleMoreThanOneOfThatMinute) {
  const Schedule all(600, 50, 10), minute(600, 50, 10, 220, 280);
  ASSERT_GT(all.ids.size(), 6 * minute.ids.size());
  for (const Writing writing : {Writing::load, Writing::one_by_one, Writing::by_time, Writing::merged}) {
    SCOPED_TRACE(static_cast<int>(writing));
    const double nodes = nodes_of_schedule(all, writing),
                 of_minute = nodes_of_schedule(minute, Writing::load);
    // Ordered by place and velocity alone, windows read 10 to 50 times as many nodes.
    EXPECT_LT(nodes, (writing == Writing::load ? 1.5 : 3) * of_minute) << of_minute;
  }
}

TEST(TprTreeSchedules, LivesThatNeverMeetHaveLeavesOfTheirOwn) {
  constexpr int generations = 7;
  constexpr double life = 160;
  Schedule schedule(450, generations, 10);
  Random random(2);
  const auto generation = [&](std::size_t i) { return static_cast<int>(i % generations); };
  for (std::size_t i = 0; i < schedule.ids.size(); ++i) {
    double* record = schedule.records.data() + 7 * i;
    record[0] = generation(i) * life - random.in(0, 10), record[6] = record[0] + 0.6 * life;
  }
  TreeModel model(legs, 60, 20);
  model.tree->bulk_load(schedule.ids, schedule.records, model.never);
  std::map<NodeNumber, std::set<int>> lives;  // by leaf
  for (std::size_t i = 0; i < schedule.ids.size(); ++i)
    lives[*model.pages.find_leaf(schedule.ids[i])].insert(generation(i));
  const auto mixed =
      std::count_if(lives.begin(), lives.end(), [](const auto& leaf) { return leaf.second.size() > 1; });
  EXPECT_GT(lives.size(), 20 * generations);
  EXPECT_LE(mixed, generations - 1);
}

/// Nodes that a window reads among the chunks of movers that wander, each with 100 legs of 10 s.
double nodes_of_plans(double starts_within) {
  constexpr Layout robots{.axes = 2,
                          .law = Law::uniform,
                          .shape = Shape::ball,
                          .has_t = true,
                          .has_until = true,
                          .has_plan = true};
  constexpr std::size_t movers = 5000;
  const double side = std::sqrt(100.0 * movers);
  const Layout layout = chunk_layout(robots);
  const Offsets at = record_offsets(robots);
  std::vector<double> record(static_cast<std::size_t>(at.size), 1);
  record[static_cast<std::size_t>(at.until)] = no_end;
  std::vector<double> item(static_cast<std::size_t>(record_offsets(layout).size)), items;
  std::vector<std::int64_t> numbers;
  Random random(6);
  for (std::size_t mover = 0; mover < movers; ++mover) {
    std::vector<Leg> legs;
    Leg leg{.x = {random.in(0, side), random.in(0, side)}};
    leg.t = -random.in(0, starts_within);
    for (int i = 0; i < 100; ++i) {
      leg.until = leg.t + 10;
      for (std::size_t j = 0; j < 2; ++j)
        leg.v[j] = (std::clamp(leg.x[j] + random.in(-12, 12), 0.0, side) - leg.x[j]) / 10;
      legs.push_back(leg);
      for (std::size_t j = 0; j < 2; ++j) leg.x[j] += 10 * leg.v[j];
      leg.t = leg.until;
    }
    for (const ChunkRange& range : cut_into_chunks(legs)) {
      write_chunk_item(robots, record.data(), std::span(legs).subspan(range.first, range.count), item.data());
      numbers.push_back(static_cast<std::int64_t>(numbers.size() + 1));
      items.insert(items.end(), item.begin(), item.end());
    }
  }
  MemoryPages pages(layout);
  NeverInterrupt never;
  make_tpr_tree(pages, 60)->bulk_load(numbers, items, never);
  return nodes_of_windows(pages, side, 530);
}

TEST(TprTreeSchedules, AWindowReadsFewChunksOfOtherTimes) {
  // Cut at the median time and with boxes that follow their chords, both are 16.3.
  EXPECT_LT(nodes_of_plans(10), 10);
  EXPECT_LT(nodes_of_plans(400), 16);
}

TEST(TprTreeSchedules, SchedulesOfRestingObjectsAreSeparatedInTimeToo) {
  Schedule zones(300, 100, 10);
  for (std::size_t i = 0; i < zones.ids.size(); ++i) zones.records[7 * i + 3] = zones.records[7 * i + 4] = 0;
  MemoryPages pages(legs);
  NeverInterrupt never;
  make_tpr_tree(pages, 60)->bulk_load(zones.ids, zones.records, never);
  // Ordered by place alone they read 26.
  EXPECT_LT(nodes_of_windows(pages, zones.side, 500), 12);
}

TEST(TprTreeSchedules, ReportsThatExpireLaterAreStoredAsIfTheyHadNoEnd) {
  const auto nodes_with = [](double life, bool grown) {
    constexpr std::size_t count = 5000;
    MemoryPages pages(legs);
    const auto tree = make_tpr_tree(pages, 60);
    NeverInterrupt never;
    Random random(8);
    std::vector<std::int64_t> ids;
    std::vector<double> records;
    for (std::size_t i = 0; i < count; ++i) {
      const double t = 1000 + 60 * static_cast<double>(i) / count;
      ids.push_back(static_cast<std::int64_t>(i + 1));
      records.insert(records.end(), {t, random.in(0, 700), random.in(0, 700), random.in(-1, 1),
                                     random.in(-1, 1), 1, t + life});
      if (grown) tree->insert(ids.back(), std::span(records).last(7));
    }
    if (!grown) tree->bulk_load(ids, records, never);
    return nodes_of_windows(pages, 700, 1060, 10);
  };
  for (const bool grown : {false, true})
    for (const double life : {100.0, 900.0, 28800.0, 1e12})
      EXPECT_LT(nodes_with(life, grown), 1.1 * nodes_with(no_end, grown)) << life << grown;
}

TEST(TprTreeSchedules, ObjectsWithoutAnEndHaveLeavesOfTheirOwn) {
  Schedule schedule(300, 30, 10);
  std::size_t endless = 0;
  for (std::size_t i = 0; i < schedule.ids.size(); ++i)
    if (i % 50 == 7) schedule.records[7 * i + 6] = no_end, ++endless;
  TreeModel model(legs, 60, 20);
  model.tree->bulk_load(schedule.ids, schedule.records, model.never);
  std::set<NodeNumber> leaves;
  for (std::size_t i = 0; i < schedule.ids.size(); ++i)
    if (schedule.record(i)[6] == no_end) leaves.insert(*model.pages.find_leaf(schedule.ids[i]));
  EXPECT_LE(leaves.size(), endless / 18 + 2);
}

TEST(TprTreeSchedules, TheReferenceTimeIsTheMiddleOfALifeOrTheClock) {
  const ReferenceTimes at_100(100);
  EXPECT_EQ(at_100.of({500, 500, 510}), 505);
  EXPECT_EQ(at_100.of({500, 500, no_end}), 100);
  EXPECT_EQ(at_100.of({95, 95, 105}), 100);  // current
  EXPECT_EQ(at_100.of({90, 90, 1e12}), 100);
  EXPECT_EQ(at_100.of({-1000, 900, 910}), -45);  // a whole schedule
  EXPECT_EQ(at_100.of({-1.7e308, -1.7e308, 1.7e308}), 100);
  EXPECT_EQ(at_100.of({1.7e308, 1.7e308, 1.7e308}), 1.7e308);
  EXPECT_TRUE(std::isfinite(at_100.of(Times())));
}

TEST(TprTreeSchedules, AChildOfAnotherTimeHardlyMovesTheReferenceTime) {
  const ReferenceTimes at_100(100);
  Lives lives;
  for (int i = 0; i < 39; ++i) lives.include({500, 505, 520});
  lives.include({90, 90, 110});
  EXPECT_EQ(at_100.mean_of(lives), (39 * 510 + 100) / 40.0);
  lives.include({90, 90, no_end});
  EXPECT_EQ(at_100.mean_of(lives), 100);
}

}  // namespace
}  // namespace foresee
