// Number of objects in _meta: exact after every commit, written only if it changed, checked when it is read.
#include <filesystem>

#include "storage/database.h"
#include "storage/table/table_totals.h"

namespace foresee {
namespace {

const std::string stored_count = "SELECT value FROM ships_meta WHERE key = 'objects'";

class Counted : public ::testing::Test {
 protected:
  Counted() {
    begin(db, *store);
    for (int id = 1; id <= 100; ++id) store->insert(id, ship(id), {});
    commit(db, *store);
  }
  /// A store that has just been opened.
  std::shared_ptr<Store> opened() {
    store = nullptr;
    return store = Store::open(db, "main", "ships", ships());
  }
  void expect_count(std::int64_t count) {
    EXPECT_EQ(store->likely_objects(), count);
    EXPECT_EQ(db.number(stored_count), count);
    EXPECT_EQ(faults(*store), std::vector<std::string>{});
  }
  Database db;
  std::shared_ptr<Store> store = make_store(db);
};

TEST(ObjectCount, IsNeverNegativeAndAddsOnlyKnownNumbers) {
  EXPECT_EQ(ObjectCount().likely(), 1048576);
  EXPECT_EQ(ObjectCount().sum(), std::nullopt);
  EXPECT_EQ((ObjectCount{.stored = 5, .added = -2}).sum(), 3);
  EXPECT_EQ((ObjectCount{.stored = 5, .added = -6}).sum(), std::nullopt);
  EXPECT_EQ((ObjectCount{.stored = 5, .added = -6}).likely(), 0);
}

TEST_F(Counted, IsExactAfterEveryCommit) {
  expect_count(100);
  begin(db, *store);
  store->erase(7);
  store->update(8, 9, ship(8), {});  // replaces 9
  store->update(10, 500, ship(10), {});
  store->insert(501, ship(501), {});
  store->erase(501);
  EXPECT_EQ(store->likely_objects(), 98);
  commit(db, *store);
  expect_count(98);
  EXPECT_EQ(opened()->likely_objects(), 98);
  begin(db, *store);
  for (const auto& [id, x] : contents(*store)) store->erase(id);
  commit(db, *store);
  expect_count(0);
}

TEST_F(Counted, IsWrittenOnlyWhereItChanged) {
  db.run(
      "CREATE TEMP TABLE written(key); CREATE TEMP TRIGGER note AFTER INSERT ON main.ships_meta BEGIN "
      "INSERT INTO written VALUES(new.key); END");
  const std::string counts = "SELECT count(*) FROM written WHERE key = 'objects'";
  begin(db, *store);
  for (int id = 1; id <= 100; ++id) store->update(id, id, ship(-id), {});
  store->erase(5);
  store->insert(5, ship(5), {});
  commit(db, *store);
  EXPECT_EQ(db.number(counts), 0);
  begin(db, *store);
  store->erase(5);
  store->erase(6);
  commit(db, *store);
  EXPECT_EQ(db.number(counts), 1);
  db.run("DROP TABLE written");
}

TEST_F(Counted, IsRestoredByRollbacksAndSavepoints) {
  begin(db, *store);
  store->insert(101, ship(101), {});
  open_savepoint(db, *store, 1);
  store->insert(102, ship(102), {});
  faults(*store);  // which writes all changes
  store->erase(1);
  EXPECT_EQ(store->likely_objects(), 101);
  roll_back_to(db, *store, 1);
  EXPECT_EQ(store->likely_objects(), 101);
  expect_store_error(SQLITE_ERROR, "no object 999", [&] { store->erase(999); });
  commit(db, *store);
  expect_count(101);
  begin(db, *store);
  store->erase(1);
  faults(*store);
  store->erase(2);
  roll_back(db, *store);
  expect_count(101);
  begin(db, *store);
  db.run("SAVEPOINT s0");
  store->erase(1);
  open_savepoint(db, *store, 1);
  store->erase(2);
  roll_back_to(db, *store, 0);
  store->insert(1000, ship(1), {});
  commit(db, *store);
  expect_count(102);
}

TEST_F(Counted, IsWrittenLaterAfterAFailedWrite) {
  begin(db, *store);
  store->erase(1);
  db.run(
      "CREATE TEMP TRIGGER no BEFORE INSERT ON main.ships_meta WHEN new.key = 'objects' BEGIN "
      "SELECT raise(FAIL, 'no'); END");
  expect_store_error(SQLITE_CONSTRAINT, "no", [&] { store->sync(); });
  db.run("DROP TRIGGER no");
  commit(db, *store);
  expect_count(99);
}

TEST_F(Counted, IsLearnedFromOtherConnectionsWithTheStamp) {
  const std::string path = std::string(FORESEE_BINARY_DIR) + "/count_of_two.db";
  std::filesystem::remove(path);
  {
    Database one(path), two(path);
    auto mine = make_store(one);
    auto theirs = Store::open(two, "main", "ships", ships());
    EXPECT_EQ(theirs->likely_objects(), 0);
    begin(one, *mine);
    for (int id = 1; id <= 10; ++id) mine->insert(id, ship(id), {});
    commit(one, *mine);
    EXPECT_EQ(theirs->likely_objects(), 0);  // the planner does not read
    theirs->read_version();
    EXPECT_EQ(theirs->likely_objects(), 10);
    begin(two, *theirs);
    theirs->erase(3);
    commit(two, *theirs);
    begin(one, *mine);
    mine->insert(11, ship(11), {});
    commit(one, *mine);
    EXPECT_EQ(mine->likely_objects(), 10);
    EXPECT_EQ(one.number(stored_count), 10);
    mine = theirs = nullptr;
  }
  std::filesystem::remove(path);
}

TEST_F(Counted, InAFileOfVersionZeroOneAWriterCountsOnce) {
  db.run("DELETE FROM ships_meta WHERE key = 'objects'");
  EXPECT_EQ(opened()->likely_objects(), 1048576);
  contents(*store);
  EXPECT_EQ(store->likely_objects(), 100);
  begin(db, *store);
  store->update(1, 1, ship(-1), {});
  commit(db, *store);
  EXPECT_EQ(db.number(stored_count), -1);
  EXPECT_EQ(faults(*store), std::vector<std::string>{});
  begin(db, *store);
  store->insert(101, ship(101), {});
  store->erase(1);
  store->erase(2);
  commit(db, *store);
  expect_count(99);
}

TEST_F(Counted, AnImpossibleCountIsIgnoredReportedAndRepaired) {
  for (const char* value : {"-1", "'many'", "1000000000000000000", "-9223372036854775808", "1e300", "x'00'",
                            "100.0", "99", "printf('%.*c', 1000000, '9')"}) {
    db.run("UPDATE ships_meta SET value = " + std::string(value) + " WHERE key = 'objects'");
    const bool may_be = std::string(value) == "99";
    EXPECT_EQ(opened()->likely_objects(), may_be ? 99 : 1048576) << value;
    const std::vector<std::string> found = faults(*store);
    EXPECT_EQ(found.size(), 1u) << value;
    EXPECT_TRUE(found.at(0).starts_with("ships: the count of objects is ")) << found.at(0);
    EXPECT_TRUE(found.at(0).ends_with(", but there are 100")) << found.at(0);
    NeverInterrupt never;
    begin(db, *store);
    expect_store_error(SQLITE_CORRUPT_VTAB, "the count of objects", [&] { store->optimize(never); });
    store->rebuild(never);
    commit(db, *store);
    expect_count(100);
  }
}

TEST_F(Counted, AWrongOneHidesNoOtherFault) {
  db.run(
      "UPDATE ships_meta SET value = 1 WHERE key = 'objects'; UPDATE ships_meta SET value = 1 WHERE key = "
      "'root'");
  opened();
  EXPECT_EQ(faults(*store).size(), 1u);
  EXPECT_EQ(faults(*store).at(0).find("the count of objects"), std::string::npos) << faults(*store).at(0);
}

TEST_F(Counted, AWrongCountThatWouldBecomeNegativeIsCountedAgain) {
  db.run("UPDATE ships_meta SET value = 1 WHERE key = 'objects'");
  opened();
  begin(db, *store);
  for (int id = 1; id <= 3; ++id) store->erase(id);
  EXPECT_EQ(store->likely_objects(), 0);
  commit(db, *store);
  expect_count(97);
}

}  // namespace
}  // namespace foresee
