// Writes of plans that fail: undone, or the transaction is only good for a rollback. Writers that are killed.
#include "sqlite/faults/killed_writer.h"
#include "storage/plan_cases.h"

namespace foresee {
namespace {

Declaration named_fleet() {
  Declaration declaration = fleet();
  declaration.auxiliaries = {{"name", "TEXT"}, {"cargo", ""}};
  return declaration;
}

class PlanFaults : public ::testing::Test {
 protected:
  PlanFaults() : values(db, {"name", "cargo"}), store(make_store(db, named_fleet())) {
    testing::Random random(9);
    begin(db, *store);
    for (std::int64_t id = 1; id <= 5; ++id) {
      Robot& robot = robots[id];
      robot.record = robot_record(1);
      robot.plan = random_stored_plan(random, 2, PlanKind::knots, 100);
      store->insert(id, robot.record, values, {}, &*robot.plan);
    }
    commit(db, *store);
    other = random_stored_plan(random, 2, PlanKind::uniform, 100);
    while (leg_count(other) < 40) other = random_stored_plan(random, 2, PlanKind::uniform, 100);
  }
  void forbid(const std::string& event, const std::string& table, const std::string& when = "1") {
    db.run("CREATE TRIGGER forbid BEFORE " + event + " ON ships_" + table + " WHEN " + when +
           " BEGIN SELECT raise(ABORT, 'forbidden'); END");
  }
  template <class Call>
  void expect_forbidden(Call call) {
    expect_store_error(SQLITE_CONSTRAINT, "forbidden", call);
  }
  /// Expects the present state, which a commit keeps.
  void expect_unchanged() {
    expect_robots(*store, robots, "after the failure");
    commit(db, *store);
    db.run("DROP TRIGGER forbid");
    expect_robots(*store, robots, "after the commit");
    EXPECT_EQ(faults(*store), std::vector<std::string>{});
  }

  Database db;
  SqlValues values;
  std::shared_ptr<Store> store;
  Robots robots;
  Plan other;
};

TEST_F(PlanFaults, AChunkThatCannotBeWrittenUndoesTheChange) {
  // The third chunk of each new plan, whose numbers are above those of the plans that failed before.
  const std::string known = std::to_string(db.number("SELECT max(number) FROM ships_leg"));
  forbid("INSERT", "leg",
         "new.number - 2 > " + known + " AND EXISTS (SELECT 1 FROM ships_leg WHERE number = new.number - 2)");
  begin(db, *store);
  expect_forbidden([&] { store->insert(9, robot_record(1), values, {}, &other); });
  expect_forbidden([&] { store->update(2, 2, *store->read(2), values, &other); });
  expect_forbidden([&] { store->update(2, 7, *store->read(2), values, &other); });
  expect_unchanged();
}

TEST_F(PlanFaults, AuxiliariesThatCannotBeWrittenUndoTheChange) {
  for (const char* event : {"INSERT", "UPDATE"}) {
    forbid(event, "aux");
    begin(db, *store);
    if (event == std::string("INSERT"))
      expect_forbidden([&] { store->insert(9, robot_record(1), values, {}, &other); });
    else
      expect_forbidden([&] { store->update(2, 7, *store->read(2), values, &other); });
    expect_unchanged();
  }
}

TEST_F(PlanFaults, ChunksThatCannotBeDeletedLeaveOnlyARollback) {
  for (const bool erases : {false, true}) {
    forbid("DELETE", "leg");
    begin(db, *store);
    expect_forbidden([&] {
      if (erases)
        store->erase(3);
      else
        store->update(3, 3, *store->read(3), values, &other);
    });
    expect_store_error(SQLITE_ABORT, "a write failed half-way; roll back", [&] { store->read(3); });
    roll_back(db, *store);
    db.run("DROP TRIGGER forbid");
    expect_robots(*store, robots, "rolled back");
    EXPECT_EQ(faults(*store), std::vector<std::string>{});
  }
}

// --- memory, and the end of a process

std::shared_ptr<Store> make_fleet(Database& db, const MemoryLimits& limits) {
  static const QualifiedName name{"main", "ships"};
  db.run("BEGIN IMMEDIATE");
  const NodeFormat format = create_shadow_tables(db, name, fleet());
  auto rows = std::make_unique<ShadowRows>(shadow_tables(db, name, fleet()), fleet());
  auto store = std::make_shared<Store>(db, name, fleet(), format, std::move(rows), true,
                                       std::make_shared<MemoryBudget>(limits));
  commit(db, *store);
  return store;
}

TEST(PlanMemory, ChangesBeyondTheBudgetAreWrittenEarlyAndStillRollBack) {
  Database db;
  const auto store = make_fleet(db, {.pending = 1 << 18, .memory = 1 << 18, .waiting = 1 << 18});
  testing::Random random(11);
  Robots robots;
  const auto insert = [&](std::int64_t first, std::int64_t last, Robots& into) {
    for (std::int64_t id = first; id <= last; ++id) {
      into[id] = {robot_record(1), random_stored_plan(random)};
      store->insert(id, into[id].record, {}, {}, &*into[id].plan);
    }
  };
  begin(db, *store);
  insert(1, 50, robots);
  commit(db, *store);
  begin(db, *store);
  open_savepoint(db, *store, 0);
  Robots more = robots;
  insert(51, 3000, more);
  EXPECT_GT(db.number("SELECT count(*) FROM ships_chunknode"), 20) << "written early";
  expect_robots(*store, more, "all");
  roll_back_to(db, *store, 0);
  expect_robots(*store, robots, "rolled back");
  commit(db, *store);
  EXPECT_EQ(faults(*store), std::vector<std::string>{});
}

TEST(PlanMemory, ARebuildInPortionsRestoresTheTreeOfChunks) {
  Database db;
  const auto store =
      make_fleet(db, {.pending = 1 << 18, .memory = 1 << 18, .waiting = 1 << 16, .ordered = 1 << 14});
  testing::Random random(12);
  Robots robots;
  begin(db, *store);
  for (std::int64_t id = 1; id <= 400; ++id) {
    robots[id] = {robot_record(1), random_stored_plan(random)};
    store->insert(id, robots[id].record, {}, {}, &*robots[id].plan);
  }
  commit(db, *store);
  const std::int64_t chunks = db.number("SELECT count(*) FROM ships_leg");
  ASSERT_GT(chunks * 72, 4 << 14) << "several portions";
  db.run(
      "DELETE FROM ships_chunkmap WHERE id % 3 = 0; DELETE FROM ships_chunknode WHERE nodeno % 2 = 0;"
      "INSERT INTO ships_leg SELECT 1000000, data FROM ships_leg LIMIT 1;"
      "UPDATE ships_meta SET value = random() WHERE key = 'stamp'");
  NeverInterrupt never;
  begin(db, *store);
  store->rebuild(never);
  commit(db, *store);
  EXPECT_EQ(faults(*store), std::vector<std::string>{});
  EXPECT_EQ(db.number("SELECT count(*) FROM ships_leg"), chunks);
  expect_robots(*store, robots, "rebuilt");
}

TEST(PlanCrash, KilledWritersLeaveWholeTransactions) {
  for (std::uint64_t seed = 1; seed <= 6 && !::testing::Test::HasFailure(); ++seed) {
    testing::TemporaryFile file;
    {
      Database db(file.path());
      db.run("PRAGMA page_size = 1024; CREATE TABLE progress(k)");
      make_store(db, fleet());
    }
    const std::int64_t announced = testing::write_and_kill(seed, [&](testing::Announce announce) {
      Database db(file.path());
      db.run("PRAGMA cache_size = 10");
      auto store = Store::open(db, "main", "ships", fleet());
      testing::Random random(seed);
      for (std::int64_t k = 1;; ++k) {
        begin(db, *store);
        for (std::int64_t id = 1; id <= 40; ++id) {
          // In transaction k every object has a plan that starts at k.
          Plan plan = random_stored_plan(random, 2, PlanKind::uniform, 100);
          plan = shifted_plan(plan, 1000.0 * static_cast<double>(k));
          if (k == 1)
            store->insert(id, robot_record(1), {}, {}, &plan);
          else
            store->update(id, id, *store->read(id), {}, &plan);
        }
        db.run("INSERT INTO progress VALUES(" + std::to_string(k) + ")");
        commit(db, *store);
        announce(k);
      }
    });
    Database db(file.path());
    auto store = Store::open(db, "main", "ships", fleet());
    EXPECT_EQ(faults(*store), std::vector<std::string>{});
    const std::int64_t kept = db.number("SELECT coalesce(max(k), 0) FROM progress");
    EXPECT_GE(kept, announced);
    NeverInterrupt never;
    store->read_objects(
        -no_end, no_end,
        [&](std::int64_t, std::span<const double>, std::span<const Leg> legs) {
          EXPECT_NEAR(legs.front().t, 1000.0 * static_cast<double>(kept), 60);
        },
        never);
  }
}

}  // namespace
}  // namespace foresee
