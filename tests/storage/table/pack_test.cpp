// Commands 'rebuild' and 'optimize' of a table that fits into memory.
#include <algorithm>
#include <cmath>
#include <random>

#include "stopping_interrupt.h"
#include "storage/database.h"

namespace foresee {
namespace {

class Pack : public ::testing::Test {
 protected:
  // Half of 4000 scattered objects, the others deleted again: leaves are half full.
  Pack() : store(make_store(db)) {
    std::mt19937 random(5);
    begin(db, *store);
    for (int id = 1; id <= 4000; ++id) {
      std::vector<double> record = ship(id);
      record[1] = random() % 1000;
      record[2] = random() % 1000;
      store->insert(id, record, {});
    }
    for (int id = 1; id <= 4000; id += 2) store->erase(id);
    commit(db, *store);
  }
  Database db;
  std::shared_ptr<Store> store;
  NeverInterrupt never;
};

TEST_F(Pack, FillsLeavesWithNeighboursAndKeepsEveryObject) {
  const auto before = contents(*store);
  begin(db, *store);
  const ContentVersion version = store->read_version();
  store->optimize(never);
  EXPECT_NE(store->read_version(), version);
  commit(db, *store);
  EXPECT_EQ(contents(*store), before);
  EXPECT_EQ(faults(*store), std::vector<std::string>{});
  EXPECT_EQ(db.number("SELECT count(*) FROM ships_node"), (2000 + 62) / 63 + 1) << "leaves and the root";
}

TEST_F(Pack, RollsBackLikeAnyChange) {
  const auto before = contents(*store);
  begin(db, *store);
  store->erase(2);
  open_savepoint(db, *store, 0);
  store->rebuild(never);
  store->insert(1, ship(1), {});
  roll_back_to(db, *store, 0);
  EXPECT_EQ(count_of(*store), 1999);
  roll_back(db, *store);
  EXPECT_EQ(contents(*store), before);
  EXPECT_EQ(faults(*store), std::vector<std::string>{});
}

TEST_F(Pack, AFailedCommitIsRolledBack) {
  const auto before = contents(*store);
  db.run(
      "CREATE TRIGGER stop BEFORE INSERT ON ships_node WHEN new.nodeno = 5 BEGIN SELECT raise(ABORT, "
      "'stopped'); END");
  begin(db, *store);
  store->rebuild(never);
  expect_store_error(SQLITE_CONSTRAINT, "stopped", [&] { store->sync(); });
  EXPECT_EQ(contents(*store), before);
  roll_back(db, *store);
  EXPECT_EQ(contents(*store), before);
  EXPECT_EQ(faults(*store), std::vector<std::string>{});
}

TEST_F(Pack, ReadsOnlyLeaves) {
  const auto before = contents(*store);
  const std::int64_t root = db.number("SELECT value FROM ships_meta WHERE key = 'root'");
  for (const std::string& damage : {std::string("UPDATE ships_meta SET value = 3 WHERE key = 'root'"),
                                    std::string("UPDATE ships_meta SET value = -3 WHERE key = 'root'"),
                                    std::string("DELETE FROM ships_map"),
                                    "DELETE FROM ships_node WHERE nodeno = " + std::to_string(root)}) {
    db.run(damage + "; UPDATE ships_meta SET value = random() WHERE key = 'stamp'");
    EXPECT_NE(faults(*store), std::vector<std::string>{}) << damage;
    begin(db, *store);
    store->rebuild(never);
    commit(db, *store);
    EXPECT_EQ(faults(*store), std::vector<std::string>{}) << damage;
    EXPECT_EQ(contents(*store), before);
  }
}

TEST_F(Pack, StopsAtAnInterruptBeforeItWritesAnything) {
  testing::StopAt stop(0);
  begin(db, *store);
  EXPECT_THROW(store->rebuild(stop), Interrupted);
  EXPECT_EQ(count_of(*store), 2000);
  commit(db, *store);
  EXPECT_EQ(faults(*store), std::vector<std::string>{});
}

TEST(PackEmpty, AnEmptyTableRemainsEmpty) {
  Database db;
  auto store = make_store(db);
  NeverInterrupt never;
  begin(db, *store);
  store->rebuild(never);
  store->insert(1, ship(1), {});
  commit(db, *store);
  EXPECT_EQ(contents(*store).size(), 1u);
}

}  // namespace
}  // namespace foresee
