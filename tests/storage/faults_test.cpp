// Failed writes: a change that fails changes nothing, and unwritten changes survive a failed flush.
#include "stopping_interrupt.h"
#include "storage/database.h"
#include "storage/rows/shadow_schema.h"
#include "storage/table/store.h"

namespace foresee {
namespace {

class Faults : public ::testing::Test {
 protected:
  Faults() : values(db, {"name", "cargo"}), store(make_store(db, named_ships())) {
    begin(db, *store);
    for (int id = 1; id <= 100; ++id) store->insert(id, ship(id), values);
    commit(db, *store);
  }
  /// Makes writes of this kind to this shadow table fail.
  void forbid(const std::string& event, const std::string& suffix) {
    db.run("CREATE TRIGGER forbid BEFORE " + event + " ON ships_" + suffix +
           " BEGIN SELECT raise(ABORT, 'forbidden'); END");
  }
  void allow() { db.run("DROP TRIGGER forbid"); }
  template <class Call>
  void expect_forbidden(Call call) {
    expect_store_error(SQLITE_CONSTRAINT, "forbidden", call);
  }
  std::string auxiliaries() {
    return db.text(
        "SELECT group_concat(id || coalesce(a0, '-') || coalesce(a1, '-')) FROM (SELECT * FROM ships_aux "
        "ORDER BY id)");
  }

  Database db;
  SqlValues values;
  std::shared_ptr<Store> store;
};

TEST_F(Faults, InsertUpdateAndEraseAreAtomicWhenAuxiliariesCannotBeWritten) {
  for (const char* event : {"INSERT", "UPDATE", "DELETE"}) {
    const auto before = contents(*store);
    const std::string names = auxiliaries();
    forbid(event, "aux");
    begin(db, *store);
    if (event == std::string("INSERT")) expect_forbidden([&] { store->insert(101, ship(1), values); });
    if (event == std::string("UPDATE")) expect_forbidden([&] { store->update(5, 5, ship(1), values); });
    if (event == std::string("UPDATE")) expect_forbidden([&] { store->update(5, 6, ship(1), values); });
    if (event == std::string("DELETE")) expect_forbidden([&] { store->erase(5); });
    EXPECT_EQ(contents(*store), before);
    EXPECT_EQ(count_of(*store), 100);
    commit(db, *store);
    allow();
    EXPECT_EQ(contents(*store), before);
    EXPECT_EQ(auxiliaries(), names);
    EXPECT_EQ(faults(*store), std::vector<std::string>{});
  }
}

TEST_F(Faults, AFailedFlushKeepsUnwrittenChanges) {
  for (const char* suffix : {"node", "map"}) {
    begin(db, *store);
    for (int id = 101; id <= 300; ++id) store->insert(id, ship(id), values);
    store->erase(50);
    const auto expected = contents(*store);
    db.run(std::string("CREATE TRIGGER forbid BEFORE INSERT ON ships_") + suffix +
           " WHEN new.rowid IN (4, 256) BEGIN SELECT raise(ABORT, 'forbidden'); END");
    expect_forbidden([&] { store->sync(); });
    EXPECT_EQ(contents(*store), expected);
    EXPECT_EQ(count_of(*store), 299);
    allow();
    store->sync();
    EXPECT_EQ(contents(*store), expected);
    EXPECT_EQ(faults(*store), std::vector<std::string>{});
    roll_back(db, *store);
    EXPECT_EQ(count_of(*store), 100);
    EXPECT_EQ(faults(*store), std::vector<std::string>{});
  }
}

TEST_F(Faults, AStampThatCannotBeWrittenStopsTheChange) {
  forbid("INSERT", "meta");
  begin(db, *store);
  expect_forbidden([&] { store->erase(1); });
  EXPECT_TRUE(store->contains(1));
  EXPECT_EQ(count_of(*store), 100);
  commit(db, *store);
}

TEST_F(Faults, AVersionAfterAFailedFirstChangeIsNotThatOfTheCommit) {
  store = nullptr;
  store = Store::open(db, "main", "ships", named_ships());  // a store without changes
  forbid("INSERT", "aux");
  begin(db, *store);
  expect_forbidden([&] { store->insert(101, ship(1), values); });
  const ContentVersion before_any_change = store->read_version();
  allow();
  store->insert(101, ship(1), values);
  commit(db, *store);
  begin(db, *store);
  store->erase(1);
  roll_back(db, *store);
  EXPECT_NE(store->read_version(), before_any_change);
}

TEST_F(Faults, AnAuthorizerThatDeniesIsAnErrorNotACrash) {
  // The new store has no compiled statement yet, so each one calls the authorizer.
  store = nullptr;
  store = Store::open(db, "main", "ships", named_ships());
  sqlite3_set_authorizer(
      db,
      [](void*, int action, const char* table, const char*, const char*, const char*) {
        const bool shadow = table && std::string(table) == "ships_map";
        return shadow && action == SQLITE_INSERT ? SQLITE_DENY : SQLITE_OK;
      },
      nullptr);
  begin(db, *store);
  store->insert(101, ship(1), values);
  expect_store_error(SQLITE_AUTH, "not authorized", [&] { store->sync(); });
  roll_back(db, *store);
  sqlite3_set_authorizer(db, nullptr, nullptr);
  EXPECT_EQ(count_of(*store), 100);
  EXPECT_EQ(faults(*store), std::vector<std::string>{});
}

TEST_F(Faults, AFullDatabaseLosesTheTransactionAndNothingElse) {
  const auto before = contents(*store);
  const std::int64_t pages = db.number("PRAGMA page_count");
  for (int room = 0; room < 12; ++room) {
    db.run("PRAGMA max_page_count = " + std::to_string(pages + room));
    begin(db, *store);
    try {
      for (int id = 101; id <= 5000; ++id) store->insert(id, ship(id), values);
      store->sync();
      ADD_FAILURE() << "the database should be full";
    } catch (const StoreError& error) {
      EXPECT_EQ(error.code & 0xff, SQLITE_FULL);
    }
    if (!sqlite3_get_autocommit(db)) db.run("ROLLBACK");
    store->rollback();
    EXPECT_EQ(contents(*store), before);
    EXPECT_EQ(faults(*store), std::vector<std::string>{});
  }
}

/// Large records, so that a few objects take much memory.
Declaration boxes() {
  return {
      .layout = {.axes = 3, .law = Law::accelerated, .shape = Shape::box, .has_t = true, .has_until = true}};
}

std::vector<double> box(double x) {
  return {0, x, 1, 2, 0, 0, 0, 0, 0, 0, 1, 1, 1, 9};
}

std::shared_ptr<Store> store_with(Database& db, MemoryLimits limits) {
  static const QualifiedName name{"main", "ships"};
  db.run("BEGIN IMMEDIATE");
  const NodeFormat format = create_shadow_tables(db, name, boxes());
  auto rows = std::make_unique<ShadowRows>(shadow_tables(db, name, boxes()), boxes());
  auto store = std::make_shared<Store>(db, name, boxes(), format, std::move(rows), true,
                                       std::make_shared<MemoryBudget>(limits));
  commit(db, *store);
  return store;
}

TEST(Memory, ChangesBeyondTheBudgetAreWrittenEarlyAndStillRollBack) {
  Database db;
  auto store = store_with(db, {.pending = 1 << 20, .memory = 1 << 20, .waiting = 1 << 20});
  begin(db, *store);
  for (int id = 1; id <= 100; ++id) store->insert(id, box(id), {});
  commit(db, *store);
  begin(db, *store);
  store->update(7, 7, box(-7), {});
  open_savepoint(db, *store, 0);
  constexpr int last = 20'000;
  for (int id = 101; id <= last; ++id) store->insert(id, box(id), {});
  EXPECT_GT(stored_map(db, boxes()).size(), 100u);
  EXPECT_EQ(store->read(4'000)->at(1), 4'000);
  EXPECT_EQ(store->read(last)->at(1), last);
  roll_back_to(db, *store, 0);
  EXPECT_EQ(count_of(*store), 100);
  EXPECT_EQ(store->read(7)->at(1), -7);
  EXPECT_EQ(faults(*store), std::vector<std::string>{});
  roll_back(db, *store);
  EXPECT_EQ(store->read(7)->at(1), 7);
  EXPECT_EQ(faults(*store), std::vector<std::string>{});
}

TEST(Memory, ALoadThatFailsAfterItsFirstRowsAreWrittenCanOnlyBeRolledBack) {
  Database db;
  auto store = store_with(db, {.waiting = 80'000});
  begin(db, *store);
  for (int id = 1; id <= 100; ++id) store->insert(id, box(id), {});
  commit(db, *store);
  const auto before = contents(*store);
  db.run(
      "CREATE TRIGGER stop BEFORE INSERT ON ships_node WHEN new.nodeno = 9 BEGIN SELECT raise(ABORT, "
      "'stopped'); END");
  begin(db, *store);
  for (int id = 101; id <= 3000; ++id) store->insert(id, box(id), {});
  expect_store_error(SQLITE_CONSTRAINT, "stopped", [&] { store->take_snapshot(); });
  const std::string words = "ships: a write failed half-way; roll back";
  expect_store_error(SQLITE_ABORT, words, [&] { store->take_snapshot(); });
  expect_store_error(SQLITE_ABORT, words, [&] { store->read(2); });
  expect_store_error(SQLITE_ABORT, words, [&] { store->insert(-1, box(1), {}); });
  expect_store_error(SQLITE_ABORT, words, [&] { store->savepoint(0); });
  expect_store_error(SQLITE_ABORT, words, [&] { store->sync(); });
  roll_back(db, *store);
  EXPECT_EQ(contents(*store), before);
  EXPECT_EQ(faults(*store), std::vector<std::string>{});
}

TEST_F(Faults, LoadStopsAtAnInterrupt) {
  testing::StopAt stop(0);
  begin(db, *store);
  for (int id = 101; id <= 5000; ++id) store->insert(id, ship(id), values);
  commit(db, *store);
  std::vector<std::int64_t> ids;
  std::vector<double> rows;
  EXPECT_THROW(store->read_all(ids, rows, stop), Interrupted);
  db.run("VACUUM");  // nothing was left open
}

}  // namespace
}  // namespace foresee
