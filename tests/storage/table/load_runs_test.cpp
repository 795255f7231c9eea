// Loads larger than the memory for pending objects: runs within the transaction, one packed tree after it.
#include "storage/table/partitioned_table.h"

namespace foresee {
namespace {

using LoadRuns = Partitioned;

TEST_F(LoadRuns, WriteEachRowTwiceAndLeaveOnePackedTree) {
  const std::int64_t before = db.number("SELECT total_changes()");
  load();
  const std::int64_t written = db.number("SELECT total_changes()") - before;
  expect_model();
  const std::int64_t nodes = db.number("SELECT count(*) FROM ships_node");
  const std::int64_t blocks = db.number("SELECT count(*) FROM ships_map");
  EXPECT_EQ(db.number("SELECT max(nodeno) FROM ships_node"), nodes) << "numbers are consecutive";
  begin(db, *store);
  store->rebuild(never);
  commit(db, *store);
  EXPECT_EQ(db.number("SELECT count(*) FROM ships_node"), nodes);
  // Deleted nodes count too; a block of the map has ids of nearly every run.
  const std::int64_t runs = objects * 100 / 40'000 + 1;
  EXPECT_LE(written, 4 * nodes + (runs + 2) * blocks);
}

TEST_F(LoadRuns, QueriesWithinTheTransactionSeeEveryObject) {
  begin(db, *store);
  for (int i = 1; i <= objects; ++i) {
    insert((i * 7919LL) % 10'007 - 300);
    if (i % 700 == 0) expect_model();
    if (i % 450 == 0) {
      const auto snapshot = store->take_snapshot();
      std::vector<std::int64_t> ids;
      std::vector<double> records;
      collect_objects(*snapshot, ids, records, never);
      ASSERT_EQ(ids.size(), model.size());
    }
  }
  commit(db, *store);
  expect_model();
}

TEST_F(LoadRuns, MayBeErasedInTheirTransaction) {
  for (const std::int64_t every : {2, 1}) {
    begin(db, *store);
    for (int i = 1; i <= objects; ++i) insert((i * 7919LL) % 10'007 - 300);
    store->take_snapshot();
    std::vector<std::int64_t> ids;
    for (const auto& [id, mark] : model)
      if (id % every == 0) ids.push_back(id);
    for (const std::int64_t id : ids) erase(id);  // more than may wait
    commit(db, *store);
    expect_model();
    begin(db, *store);
    while (!model.empty()) erase(model.begin()->first);
    commit(db, *store);
    expect_model();
    EXPECT_EQ(db.number("SELECT count(*) FROM ships_node"), 0);
    EXPECT_EQ(db.number("SELECT count(*) FROM ships_map"), 0);
  }
}

TEST_F(LoadRuns, SavepointsAndUpdatesAmongThem) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    random.seed(seed);
    const Model committed = model;
    std::vector<Model> savepoints;
    begin(db, *store);
    for (int step = 0; step < 25; ++step) {
      const auto first = static_cast<std::int64_t>(random() % 9 * 3'000);
      const auto count = static_cast<std::int64_t>(random() % 900);
      switch (random() % 8) {
        case 0:
          for (std::int64_t id = first; id < first + count; ++id)
            if (model.contains(id)) update(id);
          break;
        case 1:
          for (std::int64_t id = first; id < first + count / 2; ++id)
            if (model.contains(id)) erase(id);
          break;
        case 2:
          open_savepoint(db, *store, static_cast<int>(savepoints.size()));
          savepoints.push_back(model);
          break;
        case 3:
          if (savepoints.empty()) break;
          savepoints.resize(1 + random() % savepoints.size());
          roll_back_to(db, *store, static_cast<int>(savepoints.size()) - 1);
          model = savepoints.back();
          break;
        case 4:
          expect_model();
          break;
        default:
          for (std::int64_t id = first; id < first + count; ++id)
            if (!model.contains(id)) insert(id);
      }
    }
    if (seed % 4 == 3) {
      roll_back(db, *store);
      model = committed;
    } else {
      commit(db, *store);
    }
    expect_model();
    if (HasFailure()) FAIL() << seed;
  }
}

TEST_F(LoadRuns, AFailedRunIsRolledBack) {
  load(500);
  const Model before = model;
  for (const char* when : {"node WHEN new.nodeno = 40", "map WHEN new.rowid > 9000"}) {
    db.run(std::string("CREATE TRIGGER stop BEFORE INSERT ON ships_") + when +
           " BEGIN SELECT raise(ABORT, 'stopped'); END");
    begin(db, *store);
    expect_store_error(SQLITE_CONSTRAINT, "stopped", [&] {
      for (std::int64_t id = 20'000; id < 30'000; ++id) store->insert(id, scattered(1), {});
    });
    expect_store_error(SQLITE_ABORT, "roll back", [&] { store->read(2); });
    roll_back(db, *store);
    db.run("DROP TRIGGER stop");
    expect_model();
  }
}

TEST_F(LoadRuns, AFailedCommitIsRolledBackOrTriedAgain) {
  const int loaded = 1'500;
  db.run("CREATE TABLE allowed(x)");
  db.run(
      "CREATE TRIGGER stop BEFORE DELETE ON ships_map WHEN NOT EXISTS(SELECT * FROM allowed) "
      "BEGIN SELECT raise(ABORT, 'stopped'); END");
  begin(db, *store);
  for (int i = 1; i <= loaded; ++i) insert(i);
  expect_store_error(SQLITE_CONSTRAINT, "stopped", [&] { store->sync(); });
  roll_back(db, *store);
  model.clear();
  expect_model();
  db.run("INSERT INTO allowed VALUES(1)");
  load();
  expect_model();
}

}  // namespace
}  // namespace foresee
