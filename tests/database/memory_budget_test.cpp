// Memory budget: one limit for all tables of a connection.
#include "database/memory_budget.h"

#include "index/tpr_tree/tpr_tree.h"
#include "storage/database.h"
#include "storage/rows/shadow_schema.h"
#include "storage/table/store.h"

namespace foresee {
namespace {

class TwoTables : public ::testing::Test {
 protected:
  std::shared_ptr<Store> make(const QualifiedName& name, const std::shared_ptr<MemoryBudget>& budget) {
    db.run("BEGIN IMMEDIATE");
    const NodeFormat format = create_shadow_tables(db, name, ships());
    auto rows = std::make_unique<ShadowRows>(shadow_tables(db, name, ships()), ships());
    auto store = std::make_shared<Store>(db, name, ships(), format, std::move(rows), true, budget);
    commit(db, *store);
    return store;
  }
  void make_both(const MemoryLimits& limits) {
    const auto budget = std::make_shared<MemoryBudget>(limits);
    a = make({"main", "a"}, budget), b = make({"main", "b"}, budget);
  }
  void insert_into_both(int last) {
    begin(db, *a);
    b->begin();
    for (int id = 1; id <= last; ++id) a->insert(id, ship(id), {}), b->insert(id, ship(-id), {});
  }
  void commit_both() {
    a->sync();
    b->sync();
    db.run("COMMIT");
    a->commit();
    b->commit();
  }

  Database db;
  std::shared_ptr<Store> a, b;
};

TEST_F(TwoTables, LoadedTogetherAreWrittenEarlyByTheCommonLimit) {
  constexpr int objects = 5000;  // of about 80 bytes: one table alone is within the limit
  make_both({.pending = objects * 120});
  insert_into_both(objects);
  EXPECT_GT(db.number("SELECT count(*) FROM a_map"), 0);
  EXPECT_GT(db.number("SELECT count(*) FROM b_map"), 0);
  db.run("ROLLBACK");
  a->rollback();
  b->rollback();
  EXPECT_EQ(count_of(*a) + count_of(*b), 0);
  insert_into_both(objects);
  commit_both();
  EXPECT_EQ(count_of(*a), objects);
  EXPECT_EQ(count_of(*b), objects);
  EXPECT_EQ(faults(*a), std::vector<std::string>{});
  EXPECT_EQ(faults(*b), std::vector<std::string>{});
}

TEST_F(TwoTables, NodesWrittenEarlyForAnotherTableRollBackToASavepoint) {
  constexpr int objects = 5000;
  make_both({.pending = objects * 120});
  begin(db, *a);
  b->begin();
  a->insert(-1, ship(1), {});
  a->savepoint(0);
  open_savepoint(db, *b, 0);
  for (int id = 1; id <= objects; ++id) a->insert(id, ship(id), {});
  EXPECT_EQ(db.number("SELECT count(*) FROM a_map"), 0);
  for (int id = 1; id <= objects; ++id) b->insert(id, ship(id), {});
  EXPECT_GT(db.number("SELECT count(*) FROM a_map"), 0);
  roll_back_to(db, *b, 0);
  a->rollback_to(0);
  EXPECT_EQ(contents(*a), (std::vector<std::pair<std::int64_t, double>>{{-1, 1}}));
  EXPECT_EQ(count_of(*b), 0);
  commit_both();
  EXPECT_EQ(contents(*a), (std::vector<std::pair<std::int64_t, double>>{{-1, 1}}));
  EXPECT_EQ(faults(*a), std::vector<std::string>{});
  EXPECT_EQ(faults(*b), std::vector<std::string>{});
}

TEST_F(TwoTables, ReportsThatAreWrittenWhileTheyAreMergedCanBeRolledBack) {
  constexpr int objects = 20000, reports = 2000;  // less than an eighth: they are merged
  make_both({.waiting = 20 * 4032});
  insert_into_both(objects);
  commit_both();
  const auto report = [&] {
    for (int i = 1; i <= reports; ++i) a->update(i * 7, i * 7, ship(-i), {});
    EXPECT_EQ(count_of(*a), objects);
    EXPECT_GT(db.number("SELECT count(*) FROM a_node WHERE data NOT IN (SELECT data FROM before)"), 0);
  };
  db.run("CREATE TABLE before AS SELECT * FROM a_node");
  const auto before = contents(*a);
  begin(db, *a);
  report();
  db.run("ROLLBACK");
  a->rollback();
  EXPECT_EQ(contents(*a), before);
  begin(db, *a);
  b->begin();
  open_savepoint(db, *a, 0);
  report();
  roll_back_to(db, *a, 0);
  EXPECT_EQ(contents(*a), before);
  report();
  commit_both();
  EXPECT_EQ(faults(*a), std::vector<std::string>{});
  for (int i = 1; i <= reports; ++i) ASSERT_EQ(a->read(i * 7)->at(1), -i);
}

TEST_F(TwoTables, AMergeThatFailsWhileItWritesRollsBackToASavepoint) {
  constexpr int objects = 20000;
  make_both({.waiting = 150 * 4032});
  insert_into_both(objects);
  commit_both();
  begin(db, *a);
  b->begin();
  for (int i = 1; i <= 60; ++i) a->update(i * 300, i * 300, ship(-i), {});
  const auto before = contents(*a);  // some changed nodes are unwritten
  open_savepoint(db, *a, 0);
  db.run(
      "CREATE TEMP TRIGGER full BEFORE INSERT ON main.a_node WHEN NEW.nodeno = "
      "(SELECT max(nodeno) FROM main.a_node) BEGIN SELECT raise(ABORT, 'full'); END");
  for (int i = 1; i <= 2400; ++i) a->update(i * 8 + 1, i * 8 + 1, ship(20000 - i * 8), {});
  EXPECT_THROW(contents(*a), StoreError);
  roll_back_to(db, *a, 0);
  EXPECT_EQ(contents(*a), before);
  commit_both();
  EXPECT_EQ(contents(*a), before);
  EXPECT_EQ(faults(*a), std::vector<std::string>{});
}

TEST_F(TwoTables, NodesOfOneAreEvictedForThoseOfTheOther) {
  constexpr int objects = 1000, nodes = 20;
  make_both({.memory = nodes * 4032});
  insert_into_both(objects);
  commit_both();
  NeverInterrupt never;
  const auto read_all = [&](Store& store) {
    std::vector<std::int64_t> ids;
    std::vector<double> records;
    collect_objects(*store.take_snapshot(), ids, records, never);
    return ids.size();
  };
  for (int twice = 0; twice < 2; ++twice) EXPECT_EQ(read_all(*a), std::size_t{objects});
  for (int twice = 0; twice < 2; ++twice) EXPECT_EQ(read_all(*b), std::size_t{objects});
  db.run("DELETE FROM a_node");  // the stamp is the same, so only a read of the rows detects it
  expect_store_error(SQLITE_CORRUPT_VTAB, "a: node", [&] { read_all(*a); });
}

TEST_F(TwoTables, OfOneConnectionShareABudgetAndOfTwoDoNot) {
  const auto budget = memory_budget_of(db);
  const auto first = make_store(db, ships(), "a"), second = make_store(db, ships(), "b");
  EXPECT_EQ(budget.use_count(), 3);
  Database other;
  EXPECT_NE(memory_budget_of(other), budget);
}

}  // namespace
}  // namespace foresee
