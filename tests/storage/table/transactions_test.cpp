// Transactions of a store: exact savepoints, complete rollbacks, correct versions, two connections.
#include <cstdio>
#include <filesystem>

#include "storage/database.h"

namespace foresee {
namespace {

using Contents = std::vector<std::pair<std::int64_t, double>>;

TEST(Transactions, RollbackDropsPendingAndWrittenChanges) {
  Database db;
  auto store = make_store(db);
  begin(db, *store);
  store->insert(1, ship(1), {});
  commit(db, *store);
  begin(db, *store);
  store->insert(2, ship(2), {});
  open_savepoint(db, *store, 0);
  store->erase(1);
  roll_back(db, *store);
  EXPECT_EQ(contents(*store), (Contents{{1, 1}}));
}

TEST(Transactions, SavepointsRestoreExactlyTheirState) {
  Database db;
  auto store = make_store(db);
  begin(db, *store);
  store->insert(1, ship(1), {});
  open_savepoint(db, *store, 0);
  store->insert(2, ship(2), {});
  open_savepoint(db, *store, 1);
  store->update(1, 5, ship(5), {});
  roll_back_to(db, *store, 1);
  EXPECT_EQ(contents(*store), (Contents{{1, 1}, {2, 2}}));
  EXPECT_EQ(store->find_next_id(), 3);
  roll_back_to(db, *store, 0);
  EXPECT_EQ(contents(*store), (Contents{{1, 1}}));
  EXPECT_FALSE(store->contains(2));
  commit(db, *store);
  EXPECT_EQ(faults(*store), std::vector<std::string>{});
}

TEST(Transactions, RollbackBelowTheFirstSavepointRestoresTheStart) {
  Database db;
  auto store = make_store(db);
  db.run("BEGIN IMMEDIATE");
  db.run("SAVEPOINT s0");
  store->begin();
  store->savepoint(1);
  db.run("SAVEPOINT s1");
  store->insert(1, ship(1), {});
  db.run("ROLLBACK TO s0");
  store->rollback_to(0);
  EXPECT_EQ(contents(*store), Contents{});
  commit(db, *store);
}

TEST(Transactions, CreateIsAWriteTransactionWithoutBegin) {
  Database db;
  db.run("BEGIN");
  auto store = Store::create(db, "main", "ships", ships());
  store->insert(1, ship(1), {});
  store->sync();
  db.run("COMMIT");
  store->commit();
  EXPECT_EQ(contents(*store), (Contents{{1, 1}}));
}

TEST(Transactions, VersionChangesWithEveryChangeAndReturnsWithRollback) {
  Database db;
  auto store = make_store(db);
  const ContentVersion empty = store->read_version();
  EXPECT_EQ(store->read_version(), empty);
  begin(db, *store);
  EXPECT_EQ(store->read_version(), empty);
  store->insert(1, ship(1), {});
  const ContentVersion one = store->read_version();
  EXPECT_NE(one, empty);
  store->insert(2, ship(2), {});
  const ContentVersion two = store->read_version();
  EXPECT_NE(two, one);
  open_savepoint(db, *store, 0);
  EXPECT_EQ(store->read_version(), two);
  store->erase(1);
  EXPECT_NE(store->read_version(), two);
  roll_back_to(db, *store, 0);
  EXPECT_NE(store->read_version(), one);
  roll_back(db, *store);
  EXPECT_EQ(store->read_version(), empty);
}

TEST(Transactions, StampIsWrittenWithTheFirstChangeAndAfterAllOtherRows) {
  Database db;
  auto store = make_store(db);
  const std::string stamp = "SELECT value FROM ships_meta WHERE key = 'stamp'";
  const std::int64_t created = db.number(stamp);
  begin(db, *store);
  store->insert(1, ship(1), {});
  const std::int64_t first = db.number(stamp);
  EXPECT_NE(first, created);
  store->insert(2, ship(2), {});
  EXPECT_EQ(db.number(stamp), first);
  const ContentVersion version = store->read_version();
  commit(db, *store);
  const std::int64_t committed = db.number(stamp);
  EXPECT_NE(committed, first);
  EXPECT_EQ(store->read_version(), version) << "the same contents";
  begin(db, *store);
  commit(db, *store);
  EXPECT_EQ(db.number(stamp), committed) << "nothing was written";
}

TEST(Transactions, KeepLastInsertRowid) {
  Database db;
  auto store = make_store(db);
  db.run("CREATE TABLE other(id INTEGER PRIMARY KEY); INSERT INTO other VALUES(77)");
  begin(db, *store);
  store->insert(1, ship(1), {});
  commit(db, *store);
  EXPECT_EQ(sqlite3_last_insert_rowid(db), 77);
}

TEST(Transactions, ASecondVirtualTableOfOneTransactionSharesTheStore) {
  Database db;
  auto store = make_store(db);
  begin(db, *store);
  store->insert(1, ship(1), {});
  auto again = Store::open(db, "main", "ships", ships());
  again->begin();
  EXPECT_EQ(contents(*again), (Contents{{1, 1}}));
  again->insert(2, ship(2), {});
  again->sync();
  commit(db, *store);
  again->commit();
  EXPECT_EQ(contents(*store), (Contents{{1, 1}, {2, 2}}));
  EXPECT_EQ(faults(*store), std::vector<std::string>{});
}

class TwoConnections : public ::testing::Test {
 protected:
  TwoConnections() : file_(std::filesystem::path(FORESEE_BINARY_DIR) / "two_connections.db") { remove(); }
  ~TwoConnections() override { remove(); }
  void remove() {
    for (const char* end : {"", "-wal", "-shm", "-journal"}) std::filesystem::remove(file_.string() + end);
  }
  std::filesystem::path file_;
};

TEST_F(TwoConnections, SeeEachOthersCommitsAndNothingOld) {
  Database writer(file_.string()), other(file_.string());
  writer.run("PRAGMA journal_mode = wal");
  auto mine = make_store(writer);
  auto theirs = Store::open(other, "main", "ships", ships());
  for (int id = 1; id <= 200; id += 2) {
    begin(writer, *mine);
    EXPECT_EQ(mine->find_next_id(), id);
    mine->insert(id, ship(id), {});
    const ContentVersion before = theirs->read_version();
    EXPECT_EQ(count_of(*theirs), id - 1) << "uncommitted";
    commit(writer, *mine);
    EXPECT_NE(theirs->read_version(), before);
    begin(other, *theirs);
    EXPECT_TRUE(theirs->contains(id));
    EXPECT_EQ(theirs->find_next_id(), id + 1);
    theirs->insert(id + 1, ship(id + 1), {});
    commit(other, *theirs);
  }
  EXPECT_EQ(contents(*mine), contents(*theirs));
  EXPECT_EQ(count_of(*mine), 200);
  EXPECT_EQ(faults(*mine), std::vector<std::string>{});
}

}  // namespace
}  // namespace foresee
