// More objects than are sorted in memory: 'rebuild', 'optimize' and loads through a temporary file.
#include "format/leaf_node.h"
#include "index/tpr_tree/tpr_tree.h"
#include "stopping_interrupt.h"
#include "storage/table/partitioned_table.h"

namespace foresee {
namespace {

TEST_F(Partitioned, RebuildKeepsEveryObjectInFullLeaves) {
  load();
  expect_model();
  for (std::int64_t i = 1; i <= objects; i += 2) {
    begin(db, *store);
    erase((i * 7919) % 10'007 - 300);
    commit(db, *store);
  }
  begin(db, *store);
  store->rebuild(never);
  commit(db, *store);
  expect_model();
  // One leaf per partition may not be full; and the inner nodes.
  const std::int64_t parts = objects / 2 * 48 / 8'000 + 1;
  EXPECT_LE(db.number("SELECT count(*) FROM ships_node"), objects / 2 / 63 + 1 + parts + 4);
  EXPECT_EQ(db.number("SELECT max(nodeno) - count(*) FROM ships_node"), 0) << "numbers are consecutive";
  EXPECT_EQ(db.number("SELECT value FROM ships_meta WHERE key = 'objects'"), objects / 2);
}

TEST_F(Partitioned, WritesOverTheOldNodes) {
  load();
  const std::int64_t pages = db.number("PRAGMA page_count");
  for (int i = 0; i < 3; ++i) {
    begin(db, *store);
    store->optimize(never);
    commit(db, *store);
    expect_model();
  }
  EXPECT_LE(db.number("PRAGMA page_count"), pages + pages / 8);
}

TEST_F(Partitioned, QueriesFindTheNearest) {
  load();
  begin(db, *store);
  store->rebuild(never);
  for (const auto& [id, x] : model) EXPECT_EQ(store->read(id)->at(1), x);
  EXPECT_FALSE(store->contains(10'000'000));
  commit(db, *store);
  for (const auto& [id, x] : model) EXPECT_EQ(store->read(id)->at(1), x);
}

TEST_F(Partitioned, ManyAtOnePlaceAreDivided) {
  begin(db, *store);
  for (int id = 1; id <= objects; ++id)
    store->insert(id, std::vector<double>{1, model[id] = 5, 5, 1, 1, 2}, {});
  commit(db, *store);
  begin(db, *store);
  store->rebuild(never);
  commit(db, *store);
  expect_model();
}

TEST_F(Partitioned, ReportsOfAllInOneTransaction) {
  load();
  for (int round = 0; round < 2; ++round) {
    begin(db, *store);
    std::vector<std::int64_t> ids;
    for (const auto& [id, x] : model) ids.push_back(id);
    std::shuffle(ids.begin(), ids.end(), random);
    for (const std::int64_t id : ids) update(id);
    commit(db, *store);
    expect_model();
  }
}

/// As one UPDATE of all rows: it reads them by leaf.
TEST_F(Partitioned, ReportsOfAllByLeafWriteEachNodeAFewTimes) {
  store = store_within({.pending = 100'000, .memory = 40'000, .waiting = 16'000, .ordered = 8'000});
  load(2 * objects);
  std::vector<std::int64_t> ids;
  std::vector<double> records;
  collect_objects(*store->take_snapshot(), ids, records, never);
  const std::int64_t nodes = db.number("SELECT count(*) FROM ships_node");
  db.run("CREATE TEMP TABLE writes(nodeno)");
  for (const char* what : {"INSERT", "UPDATE"})
    db.run("CREATE TEMP TRIGGER of_" + std::string(what) + " AFTER " + what +
           " ON ships_node BEGIN INSERT INTO writes VALUES (new.nodeno); END");
  const std::size_t size = records.size() / ids.size();
  for (const bool rolls_back : {true, false}) {
    db.run("DELETE FROM writes");
    const Model before = model;
    begin(db, *store);
    for (std::size_t i = 0; i < ids.size(); ++i) {
      std::vector<double> record(records.begin() + static_cast<std::ptrdiff_t>(i * size),
                                 records.begin() + static_cast<std::ptrdiff_t>((i + 1) * size));
      model[ids[i]] = record[1] += 0.5;
      store->update(ids[i], ids[i], record, {});
    }
    EXPECT_LT(db.number("SELECT count(*) FROM writes"), 2 * nodes);
    if (rolls_back) {
      db.run("ROLLBACK");
      store->rollback();
      model = before;
    } else {
      commit(db, *store);
    }
    expect_model();
  }
}

TEST_F(Partitioned, RollBackToASavepoint) {
  load();
  begin(db, *store);
  update(-300 + 7919);
  for (int i = 0; i < 40; ++i) insert(50'000 + i);
  const Model before = model;
  open_savepoint(db, *store, 0);
  store->rebuild(never);
  for (int i = 0; i < 2'000; ++i) insert(60'000 + i);
  open_savepoint(db, *store, 1);
  const Model between = model;
  for (int i = 0; i < 2'000; ++i) insert(70'000 + i);
  store->rebuild(never);
  expect_model();
  roll_back_to(db, *store, 1);
  model = between;
  expect_model();
  roll_back_to(db, *store, 0);
  model = before;
  expect_model();
  commit(db, *store);
  expect_model();
}

TEST_F(Partitioned, ASnapshotSeesTheOldTree) {
  load();
  begin(db, *store);
  {
    const auto snapshot = store->take_snapshot();
    store->rebuild(never);
    for (int i = 0; i < 3'000; ++i) insert(60'000 + i);
    std::vector<std::int64_t> ids;
    std::vector<double> records;
    collect_objects(*snapshot, ids, records, never);
    EXPECT_EQ(ids.size(), static_cast<std::size_t>(objects));
  }
  expect_model();
  commit(db, *store);
  expect_model();
}

TEST_F(Partitioned, AFailedLoadIsRolledBack) {
  load();
  const Model before = model;
  for (const char* when : {"node WHEN new.nodeno = 40", "map WHEN new.rowid = 6400"}) {
    db.run(std::string("CREATE TRIGGER stop BEFORE INSERT ON ships_") + when +
           " BEGIN SELECT raise(ABORT, 'stopped'); END");
    begin(db, *store);
    expect_store_error(SQLITE_CONSTRAINT, "stopped", [&] { store->rebuild(never); });
    expect_store_error(SQLITE_ABORT, "roll back", [&] { store->read(2); });
    roll_back(db, *store);
    expect_model();
    begin(db, *store);
    expect_store_error(SQLITE_CONSTRAINT, "stopped", [&] {
      for (const auto& [id, x] : before) store->update(id, id, scattered(1), {});
      store->sync();
    });
    roll_back(db, *store);
    db.run("DROP TRIGGER stop");
    expect_model();
  }
}

TEST_F(Partitioned, StopAtAnInterruptAtAnyTime) {
  load(2'000);
  bool stopped = true;
  for (int n = 0; stopped; n += 1 + n / 8) {
    testing::StopAt stop(n);
    begin(db, *store);
    try {
      store->rebuild(stop);
      stopped = false;
    } catch (const Interrupted&) {
    }
    if (stopped)
      roll_back(db, *store);
    else
      commit(db, *store);
    expect_model();
    ASSERT_LT(n, 100'000);
  }
}

TEST_F(Partitioned, ReadOnlySoundLeaves) {
  load();
  const std::string leaf = "(SELECT min(nodeno) FROM ships_node WHERE substr(data, 1, 1) = x'00')";
  const std::string root = "(SELECT value FROM ships_meta WHERE key = 'root')";
  for (const std::string& damage :
       {std::string("DELETE FROM ships_map"), "DELETE FROM ships_node WHERE nodeno = " + root,
        std::string("UPDATE ships_meta SET value = 1000000000 WHERE key = 'objects'")}) {
    db.run(damage + "; UPDATE ships_meta SET value = random() WHERE key = 'stamp'");
    EXPECT_NE(faults(*store), std::vector<std::string>{}) << damage;
    begin(db, *store);
    store->rebuild(never);
    commit(db, *store);
    expect_model();
  }
  db.run(
      "UPDATE ships_node SET data = CAST(x'00' || substr(data, 2, 4000) || x'00' AS BLOB) WHERE nodeno = " +
      leaf + "; UPDATE ships_meta SET value = random() WHERE key = 'stamp'");
  begin(db, *store);
  expect_store_error(SQLITE_CORRUPT_VTAB, "is damaged", [&] { store->rebuild(never); });
  expect_store_error(SQLITE_CORRUPT_VTAB, "is damaged", [&] { store->optimize(never); });
  roll_back(db, *store);
}

TEST_F(Partitioned, AnObjectInTwoLeavesIsAnErrorBeforeAnythingIsWritten) {
  load();
  begin(db, *store);
  store->rebuild(never);
  commit(db, *store);
  // A copy of the first leaf as another node, which is not part of the tree.
  Statement read(db, "SELECT data FROM ships_node WHERE nodeno = 1");
  std::vector<std::byte> copy;
  {
    Statement::Run run(read);
    ASSERT_TRUE(run.step());
    const Node leaf = decode_leaf(store->format(), run.blob(0));
    copy = encode_leaf(store->format(), 9'000, leaf);
  }
  Statement write(db, "INSERT INTO ships_node VALUES(9000, ?)");
  {
    Statement::Run run(write);
    run.bind(1, copy);
    run.step();
  }
  const std::int64_t changes = db.number("SELECT total_changes()");
  begin(db, *store);
  expect_store_error(SQLITE_CORRUPT_VTAB, "is in two leaves", [&] { store->rebuild(never); });
  EXPECT_LE(db.number("SELECT total_changes()"), changes + 1) << "the stamp";
  roll_back(db, *store);
}

/// Unused forms are deleted, as they are when all objects are sorted in memory.
TEST(PartitionedOutlines, KeepTheFormsThatAreUsed) {
  Database db;
  static const QualifiedName name{"main", "hulls"};
  const Declaration hulls{.layout = {.axes = 2, .shape = Shape::outline, .has_heading = true}};
  db.run("BEGIN IMMEDIATE");
  const NodeFormat format = create_shadow_tables(db, name, hulls);
  auto rows = std::make_unique<ShadowRows>(shadow_tables(db, name, hulls), hulls);
  const MemoryLimits limits{.pending = 40'000, .memory = 40'000, .waiting = 16'000, .ordered = 8'000};
  const auto store = std::make_shared<Store>(db, name, hulls, format, std::move(rows), true,
                                             std::make_shared<MemoryBudget>(limits));
  commit(db, *store);
  constexpr int objects = 2'000;
  begin(db, *store);
  for (int id = 1; id <= objects; ++id) {
    const std::string width = std::to_string(1 + id % 7);
    const auto form = store->find_or_add_form("POLYGON((0 0, " + width + " 0, 0 3, 0 0))");
    const double heading = id % 4 * 90;
    const Extents<3> around = form.form->extents(heading);
    store->insert(
        id,
        std::vector<double>{id * 31 % 997 / 1.0, id * 17 % 991 / 1.0, static_cast<double>(form.number),
                            heading, around.lower[0], around.lower[1], around.upper[0], around.upper[1]},
        {});
  }
  commit(db, *store);
  begin(db, *store);
  for (int id = 3; id <= objects; id += 7) store->erase(id);
  commit(db, *store);
  const auto before = contents(*store);
  EXPECT_EQ(db.number("SELECT count(*) FROM hulls_shape"), 7);
  NeverInterrupt never;
  for (const bool check : {false, true}) {
    begin(db, *store);
    check ? store->optimize(never) : store->rebuild(never);
    commit(db, *store);
    EXPECT_EQ(contents(*store), before);
    EXPECT_EQ(db.number("SELECT count(*) FROM hulls_shape"), 6);
    EXPECT_EQ(faults(*store), std::vector<std::string>{});
  }
}

}  // namespace
}  // namespace foresee
