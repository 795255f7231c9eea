// Store through its public interface: round trips of objects inside and outside transactions.
#include <algorithm>
#include <bit>
#include <limits>
#include <map>
#include <random>

#include "storage/database.h"

namespace foresee {
namespace {

using Contents = std::vector<std::pair<std::int64_t, double>>;

TEST(Store, ReturnsEveryDoubleBitForBit) {
  Database db;
  auto store = make_store(
      db, {.layout = {
               .axes = 3, .law = Law::forced, .shape = Shape::cylinder, .has_t = true, .has_until = true}});
  const std::vector<double> record{-0.0,
                                   5e-324,
                                   -1.7976931348623157e308,
                                   0.1,
                                   -0.0,
                                   1e-310,
                                   3,
                                   1,
                                   2,
                                   3,
                                   0.5,
                                   0.0,
                                   2.2250738585072014e-308,
                                   std::numeric_limits<double>::infinity()};
  begin(db, *store);
  store->insert(-7, record, {});
  commit(db, *store);
  const auto back = store->read(-7);
  ASSERT_TRUE(back);
  for (std::size_t i = 0; i < record.size(); ++i)
    EXPECT_EQ(std::bit_cast<std::uint64_t>(record[i]), std::bit_cast<std::uint64_t>((*back)[i])) << i;
  EXPECT_FALSE(store->read(7));
}

TEST(Store, LoadsRowsWithAccelerationInPlaceOfForceAndMass) {
  Database db;
  auto store = make_store(db, {.layout = {.axes = 1, .law = Law::forced, .shape = Shape::ball}});
  begin(db, *store);
  store->insert(1, std::vector<double>{10, 1, 6, 3, 0.25}, {});  // x vx fx m r
  NeverInterrupt never;
  std::vector<std::int64_t> ids;
  std::vector<double> rows;
  store->read_all(ids, rows, never);
  EXPECT_EQ(rows, (std::vector<double>{10, 1, 2, 0.25}));
  commit(db, *store);
}

TEST(Store, ReadsPendingChangesWithoutWritingThem) {
  Database db;
  auto store = make_store(db);
  begin(db, *store);
  for (int id = 1; id <= 100; ++id) store->insert(id, ship(id), {});
  EXPECT_EQ(db.number("SELECT count(*) FROM ships_node"), 0);
  EXPECT_EQ(count_of(*store), 100);
  EXPECT_EQ(contents(*store).size(), 100u);
  EXPECT_EQ(store->read(42)->at(1), 42);
  commit(db, *store);
  EXPECT_EQ(stored_map(db).size(), 100u);
  EXPECT_EQ(faults(*store), std::vector<std::string>{});
}

TEST(Store, MergesPendingLeavesIntoTheStoredOnes) {
  Database db;
  auto store = make_store(db);
  begin(db, *store);
  for (int id = 1; id <= 300; ++id) store->insert(id, ship(id), {});
  commit(db, *store);
  begin(db, *store);
  store->update(150, 150, ship(-150), {});
  for (int id = 1; id <= 80; ++id) store->erase(id);
  store->insert(301, ship(301), {});
  const Contents all = contents(*store);
  EXPECT_EQ(all.size(), 221u);
  EXPECT_EQ(count_of(*store), 221);
  EXPECT_TRUE(std::ranges::count(all, std::pair<std::int64_t, double>(150, -150)));
  std::vector<std::int64_t> seen;
  Node leaf;
  for (NodeNumber number = 0; (number = store->next_leaf(number, leaf)) != 0;)
    seen.insert(seen.end(), leaf.keys.begin(), leaf.keys.end());
  EXPECT_EQ(seen.size(), 221u);
  commit(db, *store);
  EXPECT_EQ(contents(*store), all);
  EXPECT_EQ(faults(*store), std::vector<std::string>{});
}

TEST(Store, DeletesLeavesThatBecomeEmpty) {
  Database db;
  auto store = make_store(db);
  begin(db, *store);
  for (int id = 1; id <= 500; ++id) store->insert(id, ship(id), {});
  commit(db, *store);
  begin(db, *store);
  for (int id = 1; id <= 500; ++id) store->erase(id);
  commit(db, *store);
  EXPECT_EQ(db.number("SELECT count(*) FROM ships_node"), 0);
  EXPECT_EQ(db.number("SELECT count(*) FROM ships_map"), 0);
  EXPECT_EQ(store->find_next_id(), 1);
}

TEST(Store, NextIdIsOneMoreThanTheLargest) {
  Database db;
  auto store = make_store(db);
  begin(db, *store);
  EXPECT_EQ(store->find_next_id(), 1);
  store->insert(41, ship(1), {});
  EXPECT_EQ(store->find_next_id(), 42);
  store->insert(7, ship(1), {});
  EXPECT_EQ(store->find_next_id(), 42);
  store->erase(41);
  EXPECT_EQ(store->find_next_id(), 8);
  store->update(7, -3, ship(1), {});
  EXPECT_EQ(store->find_next_id(), -2);
  store->insert(std::numeric_limits<std::int64_t>::max(), ship(1), {});
  const std::int64_t random = store->find_next_id();
  EXPECT_GT(random, 0);
  EXPECT_FALSE(store->contains(random));
  commit(db, *store);
}

TEST(Store, UpdateToATakenIdReplacesThatObject) {
  Database db;
  auto store = make_store(db, named_ships());
  SqlValues first(db, {"first", "coal"}), second(db, {"second", "iron"});
  begin(db, *store);
  store->insert(1, ship(1), first);
  store->insert(2, ship(2), second);
  commit(db, *store);
  begin(db, *store);
  store->update(1, 2, ship(3), first);
  commit(db, *store);
  EXPECT_EQ(contents(*store), (Contents{{2, 3}}));
  EXPECT_EQ(db.text("SELECT group_concat(id || a0 || a1) FROM ships_aux"), "2firstcoal");
  EXPECT_EQ(faults(*store), std::vector<std::string>{});
}

TEST(Store, RefusesARecordThatItCouldNotReadBack) {
  Database db;
  auto store = make_store(db);
  begin(db, *store);
  std::vector<double> record = ship(1);
  record[5] = -1;
  EXPECT_THROW(store->insert(1, record, {}), Error);
  EXPECT_FALSE(store->contains(1));
  commit(db, *store);
}

TEST(Store, AgreesWithAMapThroughRandomChanges) {
  Database db;
  auto store = make_store(db, named_ships());
  std::map<std::int64_t, double> model;
  std::mt19937_64 random(20240607);
  SqlValues values(db, {"name", "cargo"});
  for (int round = 0; round < 60; ++round) {
    begin(db, *store);
    const auto before = model;
    for (int step = 0; step < 200; ++step) {
      const auto id = static_cast<std::int64_t>(random() % 400) - 100,
                 other = id + static_cast<int>(random() % 3);
      const double mark = static_cast<double>(random() % 1000);
      ASSERT_EQ(store->contains(id), model.contains(id));
      if (!model.contains(id)) {
        store->insert(id, ship(mark), values);
      } else if (random() % 3 == 0) {
        store->erase(id);
        model.erase(id);
        continue;
      } else {
        store->update(id, other, ship(mark), values);
        model.erase(id);
        model[other] = mark;
        continue;
      }
      model[id] = mark;
    }
    ASSERT_EQ(count_of(*store), static_cast<std::int64_t>(model.size()));
    if (random() % 4 == 0) {
      roll_back(db, *store);
      model = before;
    } else {
      commit(db, *store);
    }
    ASSERT_EQ(contents(*store), Contents(model.begin(), model.end()));
    ASSERT_EQ(faults(*store), std::vector<std::string>{});
  }
}

TEST(Store, ABulkLoadCanBeInterruptedAndRepeated) {
  Database db;
  auto store = make_store(db);
  begin(db, *store);
  store->insert(1, ship(1), {});
  store->read_newest_t();  // the tree is in memory: the following calls run no SQL statement
  for (int id = 2; id <= 300; ++id) store->insert(id, ship(id), {});
  sqlite3_progress_handler(
      db, 1, [](void*) { return 1; }, nullptr);
  EXPECT_THROW(store->take_snapshot(), Interrupted);
  sqlite3_progress_handler(db, 0, nullptr, nullptr);
  store->take_snapshot();
  commit(db, *store);
  EXPECT_EQ(count_of(*store), 300);
  EXPECT_EQ(faults(*store), std::vector<std::string>{});
}

}  // namespace
}  // namespace foresee
