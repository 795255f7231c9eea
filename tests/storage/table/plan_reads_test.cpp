// Plans in a store: reads during some time, items and heads in the trees, and changes that keep or refuse a plan.
#include "index/tpr_tree/search/window_walk.h"
#include "storage/plan_cases.h"

namespace foresee {
namespace {

TEST_F(ThreePlans, LegsDuringATimeAreThoseThatLast) {
  for (const auto& [id, robot] : robots) {
    if (!robot.plan) continue;
    const std::vector<Leg> legs = legs_of(*robot.plan);
    for (double from = -60; from < 500; from += 7) {
      const double until = from + (from > 100 ? 0 : 11);
      std::vector<Leg> live, read;
      for (const Leg& leg : legs)
        if (leg.t <= until && from <= leg.until) live.push_back(leg);
      StatementReadState statement_state;
      store->read_legs(id, record(id), {from, until}, statement_state, read);
      EXPECT_EQ(read, live) << from;
    }
  }
}

TEST_F(ThreePlans, ObjectsDuringATimeHaveTheirLiveLegs) {
  for (double from = -60; from < 500; from += 7) {
    const double until = from + (from > 100 ? 0 : 11);
    std::map<std::int64_t, std::vector<Leg>> found;
    store->read_objects(
        from, until,
        [&](std::int64_t id, std::span<const double>, std::span<const Leg> legs) {
          found.emplace(id, std::vector(legs.begin(), legs.end()));
        },
        never);
    EXPECT_TRUE(found.contains(4)) << "the plain row";
    for (const auto& [id, robot] : robots) {
      if (!robot.plan) continue;
      const auto lives = [&](const Leg& leg) { return leg.t <= until && from <= leg.until; };
      std::vector<Leg> expected, read;
      for (const Leg& leg : legs_of(*robot.plan))
        if (lives(leg)) expected.push_back(leg);
      for (const Leg& leg : found[id])
        if (lives(leg)) read.push_back(leg);
      EXPECT_EQ(read, expected) << from;
    }
  }
}

TEST_F(ThreePlans, HeadsAreNotFoundAndWidenNoBounds) {
  const FloatEnvironment environment;
  const auto snapshot = store->take_snapshot();
  const auto root = snapshot->read(snapshot->find_root());
  ASSERT_TRUE(root->is_leaf());
  EXPECT_EQ(root->size(), 4u);
  const Horizon horizon{-1000, 5000};
  const auto all = moving_window<2>(Vec<2>(-1e9, -1e9), Vec<2>(1e9, 1e9), Vec<2>(0, 0), horizon);
  WindowWalk<2> walk(*snapshot, all, horizon, Vec<2>(0, 0), never);
  LeafHits hits;
  std::vector<std::int64_t> ids;
  while (walk.next(hits))
    for (const std::uint32_t slot : hits.slots) ids.push_back(hits.leaf->keys[slot]);
  EXPECT_EQ(ids, std::vector<std::int64_t>{4});
  double newest = 0;
  for (const auto& [id, robot] : robots) newest = std::max(newest, record(id)[0]);
  EXPECT_EQ(store->read_newest_t(), newest);
}

TEST_F(ThreePlans, ItemsContainTheLegsWithTheShapeUntilTheEnd) {
  const FloatEnvironment environment;
  begin(db, *store);
  std::vector<double> changed = record(2);
  until_of(changed) = changed[0] + 40;
  changed[static_cast<std::size_t>(fleet_at.r)] = 3.25;
  changed[static_cast<std::size_t>(fleet_at.category)] = 6;
  store->update(2, 2, changed, {});
  commit(db, *store);
  const auto source = store->chunks();
  std::vector<std::int64_t> numbers;
  std::vector<double> items;
  collect_objects(source->tree(), numbers, items, never);
  const Offsets of_item = record_offsets(chunk_layout(fleet().layout));
  Chunk chunk;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const double* const item = items.data() + i * static_cast<std::size_t>(of_item.size);
    source->read_chunk(numbers[i], {}, chunk);
    const double r = record(chunk.object)[static_cast<std::size_t>(fleet_at.r)],
                 end = record(chunk.object)[static_cast<std::size_t>(fleet_at.until)];
    EXPECT_EQ(item[of_item.category], chunk.object == 2 ? 6 : 1);
    for (const Leg& leg : chunk.legs)
      for (const double s : {leg.t, std::min({leg.until, end, leg.t + 1000})}) {
        if (s < leg.t || s > end) continue;
        EXPECT_LE(item[of_item.t], s);
        EXPECT_LE(s, item[of_item.until]);
        for (int axis = 0; axis < 2; ++axis) {
          const auto j = static_cast<std::size_t>(axis);
          const double middle = item[of_item.x + axis] + item[of_item.v + axis] * (s - item[of_item.t]);
          const double x = leg.x[j] + leg.v[j] * (s - leg.t);
          EXPECT_LE(std::abs(x - middle) + r, item[of_item.half + axis] + 1e-9);
        }
      }
    EXPECT_LE(item[of_item.until], std::max(end, item[of_item.t]));
  }
}

TEST_F(ThreePlans, NumbersAreNotUsedTwiceEvenAfterADelete) {
  const double first = plan_number(record(3));
  begin(db, *store);
  store->erase(3);
  store->insert(3, robots[3].record, {}, {}, &*robots[3].plan);
  EXPECT_GT(plan_number(record(3)), first);
  commit(db, *store);
  expect_robots(*store, robots, "inserted again");
  EXPECT_EQ(faults(*store), std::vector<std::string>{});
}

TEST_F(ThreePlans, AKeptPlanKeepsItsRowsAndItsFirstLeg) {
  const std::int64_t rows = db.number("SELECT total(crc) FROM (SELECT length(data) AS crc FROM ships_leg)");
  begin(db, *store);
  std::vector<double> changed = record(1);
  const double x = changed[static_cast<std::size_t>(fleet_at.x)];
  changed[static_cast<std::size_t>(fleet_at.x)] = 12345;
  changed[static_cast<std::size_t>(fleet_at.r)] = 9;
  const std::int64_t before = sqlite3_total_changes(db);
  store->update(1, 1, changed, {});
  EXPECT_EQ(sqlite3_total_changes(db), before + 1) << "only the stamp";
  commit(db, *store);
  EXPECT_EQ(record(1)[static_cast<std::size_t>(fleet_at.x)], x);
  EXPECT_EQ(db.number("SELECT total(crc) FROM (SELECT length(data) AS crc FROM ships_leg)"), rows);
  robots[1].record = record(1);
  expect_robots(*store, robots, "with another r");
  EXPECT_EQ(faults(*store), std::vector<std::string>{});
}

TEST_F(ThreePlans, PlansThatDoNotFitAreRefusedBeforeAnyChange) {
  begin(db, *store);
  const auto refuse = [&](const std::string& words, const std::vector<double>& with, const Plan& plan) {
    try {
      store->insert(9, with, {}, {}, &plan);
      ADD_FAILURE() << words;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  };
  Plan plan = plan_of_knots({{0, {0, 0}}, {1, {1, 0}}});
  plan.axes = 3;
  refuse("3 axes", robot_record(1), plan);
  refuse("t is 1 after 1", robot_record(1), plan_of_knots({{1, {0, 0}}, {1, {1, 0}}}));
  refuse("no double holds its velocity", robot_record(1), plan_of_knots({{0, {-1e308, 0}}, {1, {1e308, 0}}}));
  refuse("ends before it starts", robot_record(1, 1, 0.5), plan_of_knots({{1, {0, 0}}, {2, {1, 0}}}));
  std::vector<Knot> many;
  for (std::size_t i = 0; i < max_plan_legs + 2; ++i) many.push_back({static_cast<double>(i), {0, 0}});
  refuse("at most 1048576", robot_record(1), plan_of_knots(many));
  std::vector<double> other = record(1);
  other[static_cast<std::size_t>(fleet_at.plan)] += 1;
  EXPECT_THROW(store->update(1, 1, other, {}), Error);
  expect_robots(*store, robots, "after refusals");
  commit(db, *store);
  EXPECT_EQ(faults(*store), std::vector<std::string>{});
}

TEST_F(ThreePlans, AnEndlessAcceleratedLegIsFoundEverywhere) {
  Database other;
  auto bent = make_store(other, fleet(Law::accelerated));
  std::vector<double> record = {0, 0, 0, 0, 0, 0, 0, 1, no_end, 1, 0, 0};
  Plan plan{.kind = PlanKind::accelerated, .axes = 2};
  plan.legs = {{0, no_end, {0, 0}, {1e200, 1}, {1e100, 2}}};
  begin(other, *bent);
  bent->insert(1, record, {}, {}, &plan);
  commit(other, *bent);
  EXPECT_TRUE(same_plan(bent->read_plan(1, *bent->read(1)), plan));
  EXPECT_EQ(faults(*bent), std::vector<std::string>{});
  const FloatEnvironment environment;
  const Horizon horizon{0, 1e6};
  const auto here = moving_window<2>(Vec<2>(9e200, 0), Vec<2>(9e200, 0), Vec<2>(0, 0), horizon);
  WindowWalk<2> walk(bent->chunks()->tree(), here, horizon, Vec<2>(0, 0), never);
  LeafHits hits;
  EXPECT_TRUE(walk.next(hits));
}

}  // namespace
}  // namespace foresee
