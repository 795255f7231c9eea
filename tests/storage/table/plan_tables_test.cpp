// Tables with plans as a whole: renamed, dropped, rolled back without a callback, of two connections.
#include <cstdio>
#include <filesystem>

#include "storage/plan_cases.h"

namespace foresee {
namespace {

TEST_F(ThreePlans, RenameDropAndCreateAgain) {
  begin(db, *store);
  store->rename("boats");
  store->insert(9, robots[1].record, {}, {}, &*robots[1].plan);
  commit(db, *store);
  robots[9] = robots[1];
  expect_robots(*store, robots, "renamed");
  EXPECT_EQ(db.number("SELECT count(*) FROM sqlite_schema WHERE name LIKE 'boats\\_%' ESCAPE '\\'"), 6);
  EXPECT_EQ(db.number("SELECT count(*) FROM sqlite_schema WHERE name LIKE 'ships\\_%' ESCAPE '\\'"), 0);
  begin(db, *store);
  store->drop();
  db.run("COMMIT");
  EXPECT_EQ(db.number("SELECT count(*) FROM sqlite_schema WHERE type = 'table'"), 0);
  auto again = make_store(db, fleet(), "boats");
  expect_robots(*again, {}, "created again");
}

TEST_F(ThreePlans, ARollbackWithoutACallbackIsNoticed) {
  db.run("BEGIN IMMEDIATE");
  db.run("SAVEPOINT s0");
  store->begin();
  store->insert(9, robots[1].record, {}, {}, &*robots[1].plan);
  store->sync();
  db.run("ROLLBACK TO s0");  // without a callback: the store joined later
  store->sync();
  commit(db, *store);
  expect_robots(*store, robots, "rolled back");
  EXPECT_EQ(faults(*store), std::vector<std::string>{});
}

TEST_F(ThreePlans, AnOlderLibraryRefusesByName) {
  EXPECT_EQ(db.text("SELECT value FROM ships_meta WHERE key = 'features'"), "blocks,kinds,plans");
  EXPECT_EQ(db.text("SELECT value FROM ships_meta WHERE key = 'columns'"),
            "id, t, x, y, vx, vy, r, until, category, plan");
}

TEST(StorePlans, ATableWithoutPlansHasNothingOfThem) {
  Database db;
  auto store = make_store(db);
  EXPECT_EQ(store->chunks(), nullptr);
  EXPECT_EQ(db.text("SELECT group_concat(name) FROM (SELECT name FROM sqlite_schema WHERE type = 'table' "
                    "ORDER BY name)"),
            "ships_map,ships_meta,ships_node");
  EXPECT_EQ(db.number("SELECT count(*) FROM ships_meta"), 8);
  begin(db, *store);
  store->insert(1, ship(1), {});
  std::size_t objects = 0;
  NeverInterrupt never;
  store->read_objects(
      -no_end, no_end,
      [&](std::int64_t id, std::span<const double> record, std::span<const Leg> legs) {
        EXPECT_EQ(id, 1);
        EXPECT_EQ(record[1], 1);
        EXPECT_TRUE(legs.empty());
        ++objects;
      },
      never);
  EXPECT_EQ(objects, 1u);
  commit(db, *store);
}

TEST(StorePlans, ASecondConnectionSeesNewPlans) {
  const std::string file = FORESEE_BINARY_DIR "/storage_plans.db";
  std::filesystem::remove(file);
  {
    Database db(file), other_db(file);
    auto store = make_store(db, fleet());
    auto other = Store::open(other_db, "main", "ships", fleet());
    testing::Random random(3);
    Robots robots;
    for (int round = 0; round < 20; ++round) {
      const std::int64_t id = 1 + round % 7;
      Robot& robot = robots[id];
      robot.plan = random_stored_plan(random);
      Store& writer = round % 3 == 0 ? *other : *store;
      Database& on = round % 3 == 0 ? other_db : db;
      begin(on, writer);
      if (robot.record.empty())
        writer.insert(id, robot.record = robot_record(1), {}, {}, &*robot.plan);
      else
        writer.update(id, id, *writer.read(id), {}, &*robot.plan);
      commit(on, writer);
      expect_robots(*store, robots, "first, round " + std::to_string(round));
      expect_robots(*other, robots, "second, round " + std::to_string(round));
    }
    EXPECT_EQ(faults(*other), std::vector<std::string>{});
  }
  std::filesystem::remove(file);
}

// Numbers of chunks that memory knows get other contents: by another id, and by another plan.
TEST(StorePlans, ASecondConnectionSeesOtherContentsUnderKnownNumbers) {
  const std::string file = FORESEE_BINARY_DIR "/storage_plans.db";
  std::filesystem::remove(file);
  {
    Database db(file), other_db(file), third_db(file);
    auto store = make_store(db, fleet());
    auto other = Store::open(other_db, "main", "ships", fleet());
    testing::Random random(4);
    Robots robots{{1, {robot_record(1), random_stored_plan(random)}}};
    begin(db, *store);
    store->insert(1, robots[1].record, {}, {}, &*robots[1].plan);
    commit(db, *store);
    expect_robots(*store, robots, "in memory");
    const double first = plan_number(stored_record(*store, 1));

    begin(other_db, *other);
    other->update(1, 9, stored_record(*other, 1), {});
    commit(other_db, *other);
    robots = {{9, robots[1]}};
    expect_robots(*store, robots, "of another id");
    EXPECT_EQ(plan_number(stored_record(*store, 9)), first);

    begin(other_db, *other);
    other->erase(9);
    commit(other_db, *other);
    auto third = Store::open(third_db, "main", "ships", fleet());
    robots = {{2, {robot_record(2), random_stored_plan(random)}}};
    begin(third_db, *third);
    third->insert(2, robots[2].record, {}, {}, &*robots[2].plan);
    commit(third_db, *third);
    expect_robots(*store, robots, "of another plan");
    EXPECT_EQ(plan_number(stored_record(*store, 2)), first);
  }
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace foresee
