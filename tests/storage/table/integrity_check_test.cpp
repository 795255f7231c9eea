// Damage is reported: by every read of the damaged part, and by integrity_check() anywhere.

#include "format/leaf_node.h"
#include "storage/database.h"

namespace foresee {
namespace {

class Damage : public ::testing::Test {
 protected:
  Damage() : store(make_store(db, named_ships())) {
    SqlValues values(db, {"name", "cargo"});
    begin(db, *store);
    for (int id = 1; id <= 100; ++id) store->insert(id, ship(id), values);  // nodes 1 and 2, and 3 above
    commit(db, *store);
    store = nullptr;
    store = Store::open(db, "main", "ships", named_ships());  // a store that has read nothing
  }

  void expect_faults(const std::vector<std::string>& expected) { EXPECT_EQ(faults(*store), expected); }
  NeverInterrupt never;
  Database db;
  std::shared_ptr<Store> store;
};

TEST_F(Damage, NoneIsNoFault) {
  expect_faults({});
}

TEST_F(Damage, EveryChangedByteOfALeafIsAnErrorOnEveryPath) {
  const std::int64_t size = db.number("SELECT length(data) FROM ships_node WHERE nodeno = 1");
  Statement change(db,
                   "UPDATE ships_node SET data = CAST(substr(data, 1, ?1) || "
                   "CAST(x'ff' AS BLOB) || substr(data, ?1 + 2) AS BLOB) WHERE nodeno = 1 "
                   "AND substr(data, ?1 + 1, 1) <> x'ff'");
  const std::string words = "ships: node 1 is damaged: its checksum does not match";
  int changed = 0;
  for (std::int64_t at = 0; at < size; ++at) {
    db.run("SAVEPOINT untouched");
    {
      Statement::Run run(change);
      run.bind(1, at);
      run.step();
    }
    if (sqlite3_changes(db) == 1) {
      ++changed;
      std::vector<std::int64_t> ids;
      std::vector<double> rows;
      expect_store_error(SQLITE_CORRUPT_VTAB, words, [&] { store->read_all(ids, rows, never); });
      expect_store_error(SQLITE_CORRUPT_VTAB, words, [&] {
        Node leaf;
        store->next_leaf(0, leaf);
      });
      expect_store_error(SQLITE_CORRUPT_VTAB, words, [&] { store->read(1); });
    }
    db.run("ROLLBACK TO untouched; RELEASE untouched");
    if (HasFailure()) break;
  }
  EXPECT_GT(changed, size - 100);
  expect_faults({});
}

TEST_F(Damage, WritersRefuseADamagedLeafAndChangeNothing) {
  db.run("UPDATE ships_node SET data = zeroblob(4032) WHERE nodeno = 1");
  begin(db, *store);
  SqlValues values(db, {"n", "c"});
  const std::string words = "ships: node 1 is damaged";
  expect_store_error(SQLITE_CORRUPT_VTAB, words, [&] { store->erase(1); });
  expect_store_error(SQLITE_CORRUPT_VTAB, words, [&] { store->update(1, 1, ship(0), values); });
  expect_store_error(SQLITE_CORRUPT_VTAB, words, [&] { store->update(100, 1, ship(0), values); });
  expect_store_error(SQLITE_CORRUPT_VTAB, words, [&] { store->rebuild(never); });
  expect_store_error(SQLITE_CORRUPT_VTAB, words, [&] { store->optimize(never); });
  EXPECT_EQ(store->read(100)->at(1), 100);
  EXPECT_EQ(stored_map(db).size(), 100u);
  commit(db, *store);
}

TEST_F(Damage, BlobsOfAnotherTypeOrSizeAreDamaged) {
  for (const char* data : {"NULL", "5", "'text'", "x''", "x'00'", "zeroblob(4031)", "zeroblob(100000)"}) {
    db.run(std::string("UPDATE ships_node SET data = ") + data + " WHERE nodeno = 2");
    expect_store_error(SQLITE_CORRUPT_VTAB, "node 2 is damaged: it does not have the size of a node",
                       [&] { store->read(100); });
  }
}

TEST_F(Damage, SwappedNodesAreDamaged) {
  db.run("UPDATE ships_node SET nodeno = -nodeno; UPDATE ships_node SET nodeno = 4 + nodeno");
  EXPECT_EQ(faults(*store).at(0), "ships: node 1 is damaged: its checksum does not match");
}

TEST_F(Damage, NodeNumbersBelowOneAreDamaged) {
  db.run("UPDATE ships_node SET nodeno = -1 WHERE nodeno = 1");
  EXPECT_EQ(faults(*store).at(0), "ships: node -1 is damaged: nodes are numbered from 1");
  expect_store_error(SQLITE_CORRUPT_VTAB, "numbered from 1", [&] { contents(*store); });
}

TEST_F(Damage, AMissingNodeIsNamed) {
  db.run("DELETE FROM ships_node WHERE nodeno = 1");
  expect_store_error(SQLITE_CORRUPT_VTAB, "ships: node 1 of object 1 is missing", [&] { store->read(1); });
  expect_store_error(SQLITE_CORRUPT_VTAB, "objects, the map 100", [&] { contents(*store); });
  EXPECT_EQ(faults(*store).at(0), "ships: the map sends object 1 to node 1, but no leaf has it");
}

TEST_F(Damage, AWrongMapIsFoundAndRepairedByRebuild) {
  write_map_as_version_0_1(db);
  db.run("UPDATE ships_map SET leaf = 2 WHERE id = 1; UPDATE ships_map SET leaf = 9 WHERE id = 2");
  db.run("DELETE FROM ships_map WHERE id IN (3, 100); INSERT INTO ships_map VALUES(50000, 1), (-1, 7)");
  expect_faults({"ships: the map sends object -1 to node 7, but no leaf has it",
                 "ships: the map sends object 1 to node 2, but it is in node 1",
                 "ships: the map sends object 2 to node 9, but it is in node 1",
                 "ships: object 3 of node 1 is missing in the map",
                 "ships: object 100 of node 2 is missing in the map",
                 "ships: the map sends object 50000 to node 1, but no leaf has it"});
  expect_store_error(SQLITE_CORRUPT_VTAB, "node 2 lacks object 1", [&] { store->read(1); });
  expect_store_error(SQLITE_CORRUPT_VTAB, "node 9 of object 2", [&] { store->read(2); });
  begin(db, *store);
  expect_store_error(SQLITE_CORRUPT_VTAB, "the map sends object -1", [&] { store->optimize(never); });
  store->rebuild(never);
  commit(db, *store);
  expect_faults({});
  EXPECT_EQ(store->read(1)->at(1), 1);
  EXPECT_EQ(contents(*store).size(), 100u);
}

TEST_F(Damage, StrayAndMissingAuxiliariesAreFoundAndRepairedByRebuild) {
  db.run("DELETE FROM ships_aux WHERE id = 7; INSERT INTO ships_aux VALUES(0, 1, 2), (101, 1, 2)");
  expect_faults({"ships: there are auxiliary columns of object 0, but no leaf has it",
                 "ships: object 7 of node 1 is missing in the auxiliary columns",
                 "ships: there are auxiliary columns of object 101, but no leaf has it"});
  begin(db, *store);
  store->rebuild(never);
  commit(db, *store);
  expect_faults({});
}

TEST_F(Damage, AnObjectInTwoLeavesIsFound) {
  const NodeFormat format(ships().layout, 4032);
  const std::vector<std::byte> blob = encode_leaf(format, 9, Node{.keys = {5}, .values = ship(5)});
  Statement insert(db, "INSERT INTO ships_node VALUES(9, ?)");
  {
    Statement::Run run(insert);
    run.bind(1, std::span<const std::byte>(blob));
    run.step();
  }
  expect_faults({"ships: object 5 is in nodes 1 and 9"});
  expect_store_error(SQLITE_CORRUPT_VTAB, "the leaves hold 101 objects, the map 100",
                     [&] { contents(*store); });
  begin(db, *store);
  expect_store_error(SQLITE_CORRUPT_VTAB, "object 5 is in two leaves", [&] { store->rebuild(never); });
  commit(db, *store);
}

TEST_F(Damage, RebuildDoesNotNeedInnerNodes) {
  db.run("UPDATE ships_node SET data = zeroblob(4032) WHERE nodeno = 3");
  expect_faults({"ships: node 3 is damaged: its checksum does not match"});
  begin(db, *store);
  store->rebuild(never);
  commit(db, *store);
  expect_faults({});
  EXPECT_EQ(contents(*store).size(), 100u);
}

TEST_F(Damage, RebuildRefusesANodeThatMayBeALeaf) {
  const std::string words = "ships: node 2 is damaged: its checksum does not match";
  const auto expect_refused = [&] {
    begin(db, *store);
    expect_store_error(SQLITE_CORRUPT_VTAB, words, [&] { store->rebuild(never); });
    roll_back(db, *store);
  };
  // A leaf that says it is an inner node, and then one that the map has lost too.
  db.run(
      "UPDATE ships_node SET data = CAST(CAST(x'01' AS BLOB) || substr(data, 2) AS BLOB) WHERE nodeno = 2");
  expect_refused();
  write_map_as_version_0_1(db);
  db.run("UPDATE ships_map SET leaf = 1 WHERE leaf = 2");
  expect_refused();
}

TEST_F(Damage, AMissingStampIsAnError) {
  db.run("UPDATE ships_meta SET value = 'abc' WHERE key = 'stamp'");
  expect_store_error(SQLITE_CORRUPT_VTAB, "ships: the stamp is missing", [&] { store->read_version(); });
  expect_faults({"ships: the stamp is missing"});
}

TEST_F(Damage, NoNodeNumberIsLeftAfterTheLargest) {
  const NodeFormat format(ships().layout, 4032);
  const auto last = std::numeric_limits<std::int64_t>::max();
  const std::vector<std::byte> blob = encode_leaf(format, last, Node{.keys = {5}, .values = ship(5)});
  Statement insert(db, "INSERT INTO ships_node VALUES(?, ?)");
  {
    Statement::Run run(insert);
    run.bind(1, last);
    run.bind(2, std::span<const std::byte>(blob));
    run.step();
  }
  SqlValues values(db, {"n", "c"});
  const auto fill = [&] {
    for (int id = 500; id < 700; ++id) {  // one at a time: a bulk load would number nodes from 1 again
      begin(db, *store);
      store->insert(id, ship(1), values);
      commit(db, *store);
    }
  };
  expect_store_error(SQLITE_CORRUPT_VTAB, "no node number left", fill);
  roll_back(db, *store);
}

}  // namespace
}  // namespace foresee
