// 'rebuild' and 'optimize'.
#include <algorithm>
#include <cmath>
#include <random>

#include "storage/database.h"

namespace foresee {
namespace {

class Pack : public ::testing::Test {
 protected:
  // Half of 4000 scattered objects, the others erased again: leaves half full.
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
  double mean_leaf_area() {
    std::vector<std::int64_t> ids;
    std::vector<double> records;
    double sum = 0, leaves = 0;
    for (std::int64_t leaf = 0; (leaf = store->next_leaf(leaf, ids, records)) != 0; ++leaves) {
      double low[2] = {1e9, 1e9}, high[2] = {-1e9, -1e9};
      for (std::size_t i = 0; i < records.size(); i += 6)
        for (std::size_t axis : {0, 1}) {
          low[axis] = std::min(low[axis], records[i + 1 + axis]);
          high[axis] = std::max(high[axis], records[i + 1 + axis]);
        }
      sum += (high[0] - low[0]) * (high[1] - low[1]);
    }
    return sum / leaves;
  }

  Database db;
  std::shared_ptr<ObjectStore> store;
  NeverInterrupt never;
};

TEST_F(Pack, FillsLeavesWithNeighboursAndKeepsEveryObject) {
  const auto before = contents(*store);
  const std::int64_t nodes = db.number("SELECT count(*) FROM ships_node");
  const double area = mean_leaf_area();
  begin(db, *store);
  const ContentVersion version = store->version();
  store->optimize(never);
  EXPECT_NE(store->version(), version);
  commit(db, *store);
  EXPECT_EQ(contents(*store), before);
  EXPECT_EQ(faults(*store), std::vector<std::string>{});
  EXPECT_EQ(db.number("SELECT count(*) FROM ships_node"), (2000 + 70) / 71);
  EXPECT_GT(nodes, 50);
  EXPECT_LT(mean_leaf_area(), area / 10);
}

TEST_F(Pack, RollsBackLikeAnyChange) {
  const auto before = contents(*store);
  begin(db, *store);
  store->erase(2);
  open_savepoint(db, *store, 0);
  store->rebuild(never);
  store->insert(1, ship(1), {});
  roll_back_to(db, *store, 0);
  EXPECT_EQ(store->count(), 1999);
  roll_back(db, *store);
  EXPECT_EQ(contents(*store), before);
  EXPECT_EQ(faults(*store), std::vector<std::string>{});
}

TEST_F(Pack, HalfDoneCanOnlyBeRolledBack) {
  const auto before = contents(*store);
  db.run(
      "CREATE TRIGGER stop BEFORE INSERT ON ships_node WHEN new.nodeno = 5 BEGIN SELECT raise(ABORT, "
      "'stopped'); END");
  begin(db, *store);
  expect_store_error(SQLITE_CONSTRAINT, "stopped", [&] { store->rebuild(never); });
  expect_store_error(SQLITE_ABORT, "roll back", [&] { store->read(2); });
  expect_store_error(SQLITE_ABORT, "roll back", [&] { store->insert(1, ship(1), {}); });
  expect_store_error(SQLITE_ABORT, "roll back", [&] { store->savepoint(0); });
  expect_store_error(SQLITE_ABORT, "roll back", [&] { store->sync(); });
  roll_back(db, *store);
  EXPECT_EQ(contents(*store), before);
  EXPECT_EQ(faults(*store), std::vector<std::string>{});
}

TEST_F(Pack, StopsWhenAskedBeforeItWritesAnything) {
  struct Always : Interrupt {
    void check() override { throw Interrupted(); }
  } always;
  begin(db, *store);
  EXPECT_THROW(store->rebuild(always), Interrupted);
  EXPECT_EQ(store->count(), 2000);
  commit(db, *store);
  EXPECT_EQ(faults(*store), std::vector<std::string>{});
}

TEST(PackEmpty, AnEmptyTableStaysEmpty) {
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
