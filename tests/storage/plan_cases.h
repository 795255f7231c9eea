// Plans for tests of storage: of every kind, with parts, jumps, gaps, stops and ends without limit; and tables of them.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>

#include "base/float_environment.h"
#include "index/tpr_tree/tpr_tree.h"
#include "motion/plan/plan_legs.h"
#include "scenes.h"
#include "storage/database.h"

namespace foresee {

/// t x y vx vy r until category plan chunks; id, x, y, plan, r, until, category in SQL.
inline Declaration fleet(Law law = Law::uniform) {
  return {.layout = {.axes = 2,
                     .law = law,
                     .shape = Shape::ball,
                     .has_t = true,
                     .has_until = true,
                     .has_category = true,
                     .has_plan = true}};
}

inline const Offsets fleet_at = record_offsets(fleet().layout);

inline Plan plan_of_knots(std::vector<Knot> knots, std::vector<std::size_t> part_starts = {0}) {
  return {.kind = PlanKind::knots, .knots = std::move(knots), .part_starts = std::move(part_starts)};
}

/// Any plan that check_plan() accepts. Numbers have all bits; times meet often.
inline Plan random_stored_plan(testing::Random& random, int axes, PlanKind kind, int max_legs = 70) {
  Plan plan{.kind = kind, .axes = axes, .part_starts = {}};
  double t = random.in(-50, 50);
  const auto place = [&] {
    std::array<double, 3> x{};
    for (std::size_t j = 0; j < static_cast<std::size_t>(axes); ++j)
      x[j] = random.below(10) == 0 ? -0.0 : random.in(-100, 100);
    return x;
  };
  const auto later = [&] { return t += random.below(20) == 0 ? 1e-9 : random.in(0.1, 9); };
  const auto up_to = [&](int limit) {
    return 1 + static_cast<int>(random.below(static_cast<unsigned>(limit)));
  };
  const int legs = up_to(max_legs);
  const bool rests = random.below(4) == 0;
  if (kind != PlanKind::knots) {
    for (int i = 0; i < legs; ++i) {
      if (random.below(10) == 0) later();
      Leg leg{.t = t, .x = place(), .v = place()};
      if (kind == PlanKind::accelerated) leg.a = place();
      leg.until = random.below(20) == 0 ? t : later();
      if (rests && i + 1 == legs) leg.until = no_end;
      plan.legs.push_back(leg);
    }
    plan.part_starts = {0};
    return plan;
  }
  for (int left = legs; left > 0;) {
    if (!plan.knots.empty() && random.below(2) == 0) later();
    plan.part_starts.push_back(plan.knots.size());
    int in_part = std::min(left, up_to(30));
    left -= in_part;
    plan.knots.push_back({t, place()});
    for (; in_part > 0; --in_part) {
      const bool stops = random.below(5) == 0, last = left == 0 && in_part == 1;
      const auto x = stops || (last && rests) ? plan.knots.back().x : place();
      const double until = later();
      plan.knots.push_back({last && rests ? no_end : until, x});
    }
  }
  return plan;
}

inline Plan random_stored_plan(testing::Random& random, int axes = 2) {
  return random_stored_plan(random, axes, random.below(2) == 0 ? PlanKind::knots : PlanKind::uniform);
}

/// True if every number has the same bits, -0 unlike 0.
inline bool same_plan(const Plan& a, const Plan& b) {
  const auto bits = [](double x, double y) { return x == y && std::signbit(x) == std::signbit(y); };
  const auto all = [&](const std::array<double, 3>& x, const std::array<double, 3>& y) {
    return bits(x[0], y[0]) && bits(x[1], y[1]) && bits(x[2], y[2]);
  };
  if (!(a == b)) return false;
  for (std::size_t i = 0; i < a.knots.size(); ++i)
    if (!bits(a.knots[i].t, b.knots[i].t) || !all(a.knots[i].x, b.knots[i].x)) return false;
  for (std::size_t i = 0; i < a.legs.size(); ++i) {
    const Leg &x = a.legs[i], &y = b.legs[i];
    if (!bits(x.t, y.t) || !bits(x.until, y.until) || !all(x.x, y.x) || !all(x.v, y.v) || !all(x.a, y.a))
      return false;
  }
  return true;
}

/// A record of fleet(): a plain row at x = mark, or what a plan completes.
inline std::vector<double> robot_record(double mark, double r = 1, double until = no_end,
                                        double category = 1) {
  return {0, mark, -mark, 0, 0, r, until, category, 0, 0};
}

struct Robot {
  std::vector<double> record;
  std::optional<Plan> plan = {};
};
using Robots = std::map<std::int64_t, Robot>;

inline double& until_of(std::vector<double>& record) {
  return record[static_cast<std::size_t>(fleet_at.until)];
}
inline double plan_number(const std::vector<double>& record) {
  return record[static_cast<std::size_t>(fleet_at.plan)];
}

inline std::vector<double> stored_record(Store& store, std::int64_t id) {
  return store.read(id).value_or(std::vector<double>());
}

/// Expects the chunks of a store to be those of these objects, found by a walk of the whole tree; twice, because the
/// second time they may come from memory.
inline void expect_chunks(Store& store, const Robots& robots, std::size_t chunks, const std::string& when) {
  NeverInterrupt never;
  const auto source = store.chunks();
  const FloatEnvironment environment;
  std::vector<std::int64_t> numbers;
  std::vector<double> items;
  collect_objects(source->tree(), numbers, items, never);
  EXPECT_EQ(numbers.size(), chunks) << when;
  std::sort(numbers.begin(), numbers.end());
  for (int reads = 0; reads < 2; ++reads) {
    Chunk chunk;
    std::map<std::int64_t, std::vector<Leg>> legs;
    for (const std::int64_t number : numbers) {
      source->read_chunk(number, {}, chunk);
      ASSERT_TRUE(robots.contains(chunk.object)) << when;
      legs[chunk.object].insert(legs[chunk.object].end(), chunk.legs.begin(), chunk.legs.end());
      EXPECT_FALSE(chunk.record.empty()) << when;
    }
    for (const auto& [id, robot] : robots)
      EXPECT_EQ(legs[id], robot.plan ? legs_of(*robot.plan) : std::vector<Leg>()) << when;
  }
}

/// Expects the store to hold exactly these objects, in all ways of reading.
inline void expect_robots(Store& store, const Robots& robots, const std::string& when) {
  NeverInterrupt never;
  std::map<std::int64_t, std::vector<Leg>> found;
  store.read_objects(
      -no_end, no_end,
      [&](std::int64_t id, std::span<const double> record, std::span<const Leg> legs) {
        EXPECT_TRUE(found.emplace(id, std::vector(legs.begin(), legs.end())).second) << when;
        EXPECT_EQ(has_plan(fleet_at, record.data()), !legs.empty()) << when;
      },
      never);
  ASSERT_EQ(found.size(), robots.size()) << when;
  std::size_t chunks = 0;
  for (const auto& [id, robot] : robots) {
    const std::vector<double> record = stored_record(store, id);
    ASSERT_EQ(record.size(), static_cast<std::size_t>(fleet_at.size)) << when << ": object " << id;
    ASSERT_EQ(has_plan(fleet_at, record.data()), robot.plan.has_value()) << when << ": object " << id;
    const auto r = static_cast<std::size_t>(fleet_at.r);
    EXPECT_EQ(record[r], robot.record[r]) << when;
    if (!robot.plan) {
      EXPECT_TRUE(found[id].empty()) << when;
      continue;
    }
    const std::vector<Leg> legs = legs_of(*robot.plan);
    EXPECT_TRUE(same_plan(store.read_plan(id, record), *robot.plan)) << when << ": object " << id;
    EXPECT_EQ(found[id], legs) << when << ": object " << id;
    EXPECT_EQ(record[0], legs[0].t);
    chunks += static_cast<std::size_t>(record[static_cast<std::size_t>(fleet_at.chunks)]);
  }
  expect_chunks(store, robots, chunks, when);
}

/// Three robots with plans and one plain row, committed.
class ThreePlans : public ::testing::Test {
 protected:
  ThreePlans() : store(make_store(db, fleet())) {
    testing::Random random(7);
    begin(db, *store);
    for (std::int64_t id = 1; id <= 4; ++id) {
      Robot& robot = robots[id];
      robot.record = robot_record(static_cast<double>(id));
      while (id < 4 && (!robot.plan || leg_count(*robot.plan) < 60))  // several chunks each
        robot.plan = random_stored_plan(random, 2, PlanKind::knots, 200);
      store->insert(id, robot.record, {}, {}, robot.plan ? &*robot.plan : nullptr);
    }
    commit(db, *store);
  }
  void open_again() {
    store = nullptr;
    store = Store::open(db, "main", "ships", fleet());
  }
  std::vector<double> record(std::int64_t id) { return stored_record(*store, id); }

  NeverInterrupt never;
  Database db;
  std::shared_ptr<Store> store;
  Robots robots;
};

}  // namespace foresee
