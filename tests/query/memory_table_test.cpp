// A table in memory against a map: what was put last is what scenes, look-ups and trees have, whenever they are read.
#include "query/memory_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>
#include <type_traits>

#include "index/tpr_tree/tpr_tree.h"
#include "never_interrupt.h"
#include "query/plan_cases.h"

namespace foresee::testing {
namespace {

using Records = std::map<std::int64_t, std::vector<double>>;

static_assert(!std::is_move_constructible_v<MemoryTable>, "its tree refers to its pages");

constexpr Layout timed{.axes = 2, .law = Law::uniform, .shape = Shape::ball, .has_t = true};

Records records_of(const Scene& scene) {
  Records records;
  const auto size = static_cast<std::size_t>(row_offsets(scene.layout).size);
  for (std::size_t i = 0; i < scene.size(); ++i) {
    const double* row = scene.bodies().row(i);
    EXPECT_TRUE(records.emplace(scene.ids[i], std::vector<double>(row, row + size)).second);
  }
  return records;
}

Records records_in(NodeSource& tree) {
  std::vector<std::int64_t> ids;
  std::vector<double> numbers;
  collect_objects(tree, ids, numbers, never);
  Records records;
  const auto size = static_cast<std::ptrdiff_t>(record_offsets(tree.layout()).size);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const auto from = numbers.begin() + static_cast<std::ptrdiff_t>(i) * size;
    EXPECT_TRUE(records.emplace(ids[i], std::vector<double>(from, from + size)).second);
  }
  return records;
}

void expect_sound(MemoryTable& table) {
  auto* const pages = dynamic_cast<Pages*>(table.tree().get());
  ASSERT_TRUE(pages);
  const TreeReport report = check_tree(*pages, never);
  EXPECT_TRUE(report.problems.empty()) << report.problems.at(0);
}

std::vector<double> report_at(Random& random, double t) {
  return {t, random.in(0, 100), random.in(0, 100), random.in(-2, 2), random.in(-2, 2), random.in(0, 2)};
}

/// Read by one of several methods; each sees all changes.
void expect_contents(MemoryTable& table, const Records& current, std::uint64_t method) {
  if (method == 0) {
    EXPECT_EQ(records_of(*table.all()), current);
  } else if (method == 1) {
    EXPECT_EQ(records_in(*table.tree()), current);
    expect_sound(table);
  } else if (method == 2) {
    std::vector<std::int64_t> ids(121);
    std::iota(ids.begin(), ids.end(), 0);
    EXPECT_EQ(records_of(*table.objects(ids, {})), current);
  } else if (method == 3) {
    double newest = current.empty() ? 0 : -HUGE_VAL;
    for (const auto& [id, record] : current) newest = std::max(newest, record[0]);
    EXPECT_EQ(table.newest_t(), newest);
  }
}

TEST(MemoryTable, HoldsWhatWasPutLastWheneverItIsRead) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    MemoryTable table("ships", timed);
    Records current;
    const std::uint64_t ids = seed % 4 == 0 ? 8 : 120;
    for (int step = 0; step < 120; ++step) {
      const std::uint64_t many = random.below(random.below(8) == 0 ? 150 : 6);
      for (std::uint64_t i = 0; i < many; ++i) {
        const auto id = static_cast<std::int64_t>(1 + random.below(ids));
        if (random.below(step % 30 == 29 ? 2 : 5) == 0) {
          EXPECT_EQ(table.erase(id), current.erase(id) > 0);
        } else {
          const std::vector<double> record = report_at(random, step);
          table.put(id, record);
          current[id] = record;
        }
      }
      EXPECT_EQ(table.likely_objects(), static_cast<double>(current.size()));
      expect_contents(table, current, random.below(6));
      if (random.below(4) == 0) table.commit();
      if (HasFailure()) return;
    }
    for (const auto& [id, record] : Records(current)) EXPECT_TRUE(table.erase(id));
    EXPECT_TRUE(table.all()->ids.empty());
    EXPECT_EQ(table.tree()->find_root(), 0);
  }
}

/// Enough objects for a tree of several levels: few changes are merged, many load it again.
TEST(MemoryTable, MergesFewChangesAndLoadsMany) {
  Random random(1);
  MemoryTable table("ships", timed);
  Records current;
  for (const std::size_t changes : {5000u, 1u, 40u, 400u, 3000u, 31u, 600u}) {
    for (std::size_t i = 0; i < changes; ++i) {
      const auto id = static_cast<std::int64_t>(1 + random.below(8000));
      if (random.below(4) == 0) {
        EXPECT_EQ(table.erase(id), current.erase(id) > 0);
        continue;
      }
      current[id] = report_at(random, 1);
      table.put(id, current[id]);
    }
    EXPECT_EQ(records_in(*table.tree()), current);
    expect_sound(table);
  }
}

TEST(MemoryTable, PlansAreMergedToo) {
  const Layout layout = layouts_with_plans()[1];
  PlanMaker maker(layout, PlanNumbers::halves, 5);
  MemoryTable table("robots", layout);
  std::map<std::int64_t, Mover> current;
  for (int step = 0; step < 300; ++step) {
    const auto id = static_cast<std::int64_t>(1 + maker.random.below(60));
    if (maker.random.below(5) == 0) {
      EXPECT_EQ(table.erase(id), current.erase(id) > 0);
    } else {
      const Mover mover = maker.mover(id, maker.random.below(4) == 0);
      table.put(id, mover.record, mover.legs);
      current.insert_or_assign(id, mover);
    }
    if (step % 7 != 0) continue;
    std::size_t chunks = 0, stored = 0;
    for (const auto& [number, record] : records_in(*table.tree()))
      stored += static_cast<std::size_t>(record.back());
    for (const auto& [number, item] : records_in(table.chunks()->tree())) {
      Chunk chunk;
      table.chunks()->read_chunk(number, {}, chunk);
      EXPECT_TRUE(current.contains(chunk.object));
      ++chunks;
    }
    EXPECT_EQ(chunks, stored);
  }
}

TEST(MemoryTable, RefusesWrongRecordsAndKeepsItsContents) {
  MemoryTable ships("ships", timed);
  ships.put(1, std::vector<double>{0, 0, 0, 1, 0, 2});
  const auto stamp = ships.stamp();
  const auto refused = [&](std::vector<double> record, const char* message) {
    try {
      ships.put(1, record);
      ADD_FAILURE() << message;
    } catch (const Error& error) {
      EXPECT_STREQ(error.what(), message);
    }
  };
  const double nan = std::nan("");
  refused({}, "ships: row 1: a record has 6 numbers, not 0");
  refused({0, 0, 0, 1, 0}, "ships: row 1: a record has 6 numbers, not 5");
  refused({0, 0, 0, 1, 0, 2, 3}, "ships: row 1: a record has 6 numbers, not 7");
  refused({0, 0, nan, 1, 0, 2}, "ships: row 1: y is nan; write a finite number");
  refused({0, HUGE_VAL, 0, 1, 0, 2}, "ships: row 1: x is inf; write a finite number");
  refused({0, 0, 0, 1, 0, -2}, "ships: row 1: r is -2; write a finite number >= 0");
  const std::vector<Leg> legs(1);
  EXPECT_THROW(ships.put(1, std::vector<double>{0, 0, 0, 1, 0, 2}, legs), Error);
  EXPECT_EQ(ships.stamp(), stamp);
  EXPECT_EQ(records_of(*ships.all()), (Records{{1, {0, 0, 0, 1, 0, 2}}}));
}

TEST(MemoryTable, RefusesForcesThatOverflow) {
  MemoryTable rockets("rockets", {.axes = 1, .law = Law::forced});
  EXPECT_THROW(rockets.put(1, record_of(rockets.layout(), {{"fx", 1e300}, {"m", 1e-300}})), Error);
  EXPECT_THROW(rockets.put(1, record_of(rockets.layout(), {{"fx", 1}, {"m", 0}})), Error);
  rockets.put(1, record_of(rockets.layout(), {{"fx", 6}, {"m", 2}}));
  EXPECT_EQ(rockets.all()->rows, (std::vector<double>{0, 0, 3}));
}

TEST(MemoryTable, RefusesWrongLegs) {
  const Layout layout{.axes = 2, .law = Law::uniform, .has_t = true, .has_until = true, .has_plan = true};
  MemoryTable robots("robots", layout);
  const std::vector<double> record = record_of(layout, {});
  const Leg first{.t = 0, .until = 5}, second{.t = 5, .until = 9}, early{.t = 4, .until = 9},
      reversed{.t = 9, .until = 8}, wrong{.t = 5, .until = 9, .x = {std::nan("")}};
  const auto put = [&](std::vector<Leg> legs) { robots.put(1, record, legs); };
  for (const Leg& bad : {early, reversed, wrong}) EXPECT_THROW(put({first, bad}), Error);
  EXPECT_TRUE(robots.all()->ids.empty());
  put({first, second});
  EXPECT_EQ(robots.all()->size(), 2u);
}

TEST(MemoryTable, RefusesLayoutsThatItCannotHave) {
  EXPECT_THROW(MemoryTable("ships", {.axes = 0}), Error);
  EXPECT_THROW(MemoryTable("ships", {.axes = 4}), Error);
  EXPECT_THROW(MemoryTable("ships", {.axes = 2, .shape = Shape::cylinder}), Error);
  EXPECT_THROW(MemoryTable("ships", {.axes = 2, .shape = Shape::outline}), Error);
  EXPECT_THROW(MemoryTable("ships", timed, -1), Error);
  EXPECT_THROW(MemoryTable("ships", timed, std::nan("")), Error);
}

TEST(RecordOf, SetsNumbersByName) {
  const Layout layout{.axes = 3,
                      .law = Law::forced,
                      .shape = Shape::cylinder,
                      .has_t = true,
                      .has_until = true,
                      .has_category = true,
                      .has_mask = true};
  EXPECT_EQ(record_of(layout, {}),
            (std::vector<double>{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, HUGE_VAL, 1, 4294967295}));
  EXPECT_EQ(
      record_of(layout, {{"hz", 12}, {"t", 1}, {"z", 4}, {"vy", 6}, {"fx", 8}, {"m", 11}, {"mask", 15}}),
      (std::vector<double>{1, 0, 0, 4, 0, 6, 0, 8, 0, 0, 11, 0, 12, HUGE_VAL, 1, 15}));
  EXPECT_THROW(record_of(layout, {{"ax", 1}}), Error);
  EXPECT_THROW(record_of({.axes = 2}, {{"z", 1}}), Error);
}

}  // namespace
}  // namespace foresee::testing
