// Loads in many transactions: new objects become loose leaves (index/tpr_tree/update/merge.h) under rollbacks,
// snapshots, early writes and faults.
#include "storage/table/partitioned_table.h"

namespace foresee {
namespace {

/// Small pages: a partition has some ten leaves, and a few thousand objects have a tree of four levels.
class LoadBatches : public ::testing::Test {
 protected:
  void make(const MemoryLimits& limits) {
    db.run("PRAGMA page_size = 1024; BEGIN IMMEDIATE");
    format = create_shadow_tables(db, name(), ships());
    limits_ = limits;
    store = another();
    commit(db, *store);
  }
  std::shared_ptr<Store> another() {
    auto rows = std::make_unique<ShadowRows>(shadow_tables(db, name(), ships()), ships());
    return std::make_shared<Store>(db, name(), ships(), format, std::move(rows), true,
                                   std::make_shared<MemoryBudget>(limits_));
  }
  static const QualifiedName& name() {
    static const QualifiedName ships{"main", "ships"};
    return ships;
  }
  std::vector<double> record(double mark) {
    return {100 + random() % 50 / 10.0, mark, random() % 1000 / 1.0, random() % 20 - 10.0,
            random() % 20 - 10.0,       1};
  }
  void insert_many(int count) {
    for (int i = 0; i < count; ++i) {
      const auto id = static_cast<std::int64_t>(random() % 40'000);
      if (!model.contains(id)) store->insert(id, record(model[id] = static_cast<double>(random() % 999)), {});
    }
  }
  void update_some(int count) {
    for (int i = 0; i < count && !model.empty(); ++i) {
      auto found = model.lower_bound(static_cast<std::int64_t>(random() % 40'000));
      if (found == model.end()) continue;
      const auto id = found->first;
      if (random() % 3 == 0) {
        store->erase(id);
        model.erase(found);
      } else {
        store->update(id, id, record(found->second = static_cast<double>(random() % 999)), {});
      }
    }
  }
  void expect_model() {
    const auto found = contents(*store);
    EXPECT_TRUE(std::equal(found.begin(), found.end(), model.begin(), model.end(),
                           [](auto& a, auto& b) { return a.first == b.first && a.second == b.second; }));
    EXPECT_EQ(faults(*store), std::vector<std::string>{});
  }
  void live(unsigned seed, int rounds);

  Database db;
  MemoryLimits limits_;
  NodeFormat format;
  std::shared_ptr<Store> store;
  Model model;
  std::mt19937 random{7};
};

/// Transactions of new objects, some with changes of others, rolled back in part or whole, or read by a snapshot
/// that is older.
void LoadBatches::live(unsigned seed, int rounds) {
  random.seed(seed);
  for (int round = 0; round < rounds; ++round) {
    const Model before = model;
    begin(db, *store);
    insert_many(static_cast<int>(random() % 600));
    if (random() % 4 == 0) {
      open_savepoint(db, *store, 0);
      const Model at_savepoint = model;
      insert_many(200);
      if (random() % 2 == 0) expect_model();
      update_some(30);
      roll_back_to(db, *store, 0);
      model = at_savepoint;
    }
    if (random() % 3 == 0) update_some(40);
    std::shared_ptr<NodeSource> snapshot;
    Model seen;
    if (random() % 3 == 0) {
      snapshot = store->take_snapshot();
      seen = model;
    }
    if (snapshot) insert_many(300);
    if (random() % 5 == 0) {
      snapshot.reset();
      roll_back(db, *store);
      model = before;
    } else {
      commit(db, *store);
    }
    if (snapshot) {
      NeverInterrupt never;
      std::vector<std::int64_t> ids;
      std::vector<double> records;
      collect_objects(*snapshot, ids, records, never);
      EXPECT_EQ(ids.size(), seen.size());
    }
    snapshot.reset();
    expect_model();
    if (random() % 6 == 0) {
      store = another();
      begin(db, *store);
      commit(db, *store);
    }
    if (HasFailure()) FAIL() << "seed " << seed << ", round " << round;
  }
}

TEST_F(LoadBatches, RandomLivesAgreeWithAModel) {
  make({});
  live(1, 40);
}

TEST_F(LoadBatches, RandomLivesWithinLittleMemoryAgreeWithAModel) {
  make({.pending = 20'000, .memory = 60'000, .waiting = 20'000, .ordered = 30'000});
  live(2, 40);
}

TEST_F(LoadBatches, AFailedCommitIsRolledBackOrTriedAgain) {
  make({});
  begin(db, *store);
  insert_many(3000);
  commit(db, *store);
  const Model before = model;
  const std::int64_t last = db.number("SELECT max(nodeno) FROM ships_node");
  db.run("CREATE TABLE allowed(x)");
  for (const std::int64_t offset : {1, 5, 20}) {
    db.run(
        "CREATE TRIGGER stop BEFORE INSERT ON ships_node WHEN new.nodeno = " + std::to_string(last + offset) +
        " AND NOT EXISTS(SELECT * FROM allowed) BEGIN SELECT raise(ABORT, 'stopped'); END");
    for (const bool again : {false, true}) {
      begin(db, *store);
      insert_many(600);
      expect_store_error(SQLITE_CONSTRAINT, "stopped", [&] { store->sync(); });
      if (again) {
        db.run("INSERT INTO allowed VALUES(1)");
        store->sync();
      }
      roll_back(db, *store);
      db.run("DELETE FROM allowed");
      model = before;
      expect_model();
    }
    db.run("DROP TRIGGER stop");
  }
}

}  // namespace
}  // namespace foresee
