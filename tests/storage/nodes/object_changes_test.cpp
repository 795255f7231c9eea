// Log of changed objects: always those that the transaction has changed and not rolled back.
#include "storage/nodes/object_changes.h"

#include <cstdio>
#include <map>
#include <random>
#include <set>

#include "sqlite/foresee.h"
#include "storage/database.h"
#include "storage/table/store.h"

namespace foresee {
namespace {

using Record = std::vector<double>;
using Objects = std::map<std::int64_t, Record>;
using Difference = std::map<std::int64_t, Record>;  // the changed objects as they are now; empty: erased

std::vector<std::int64_t> logged(const ObjectChanges& changes) {
  return {changes.ids().begin(), changes.ids().end()};
}

TEST(ObjectChanges, AreThoseSinceTheStartAndNotRolledBack) {
  Journal journal;
  ObjectChanges changes(journal);
  journal.begin();
  EXPECT_FALSE(changes.lacks(7)) << "no change is kept yet";
  changes.start_keeping();
  EXPECT_TRUE(changes.are_none());
  for (const std::int64_t id : {7, 8})
    if (changes.lacks(id)) changes.add(id);
  EXPECT_FALSE(changes.lacks(7) || changes.lacks(8));
  const Journal::Mark mark = journal.set_mark();
  changes.add(9);
  journal.rewind(mark);
  EXPECT_TRUE(changes.lacks(9));
  changes.add(-9);
  EXPECT_EQ(logged(changes), (std::vector<std::int64_t>{7, 8, -9}));
  EXPECT_FALSE(changes.are_none());
  journal.end(Journal::Ended::committed);
  EXPECT_TRUE(changes.are_none());
  EXPECT_EQ(changes.memory(), 0u);
}

TEST(ObjectChanges, OfVeryManyObjectsAreNotLogged) {
  Journal journal;
  ObjectChanges changes(journal);
  journal.begin();
  changes.start_keeping();
  const auto limit = static_cast<std::int64_t>(ObjectChanges::max_logged);
  for (std::int64_t id = 1; id <= limit / 2; ++id) changes.add(id);
  const Journal::Mark mark = journal.set_mark();
  for (std::int64_t id = limit / 2 + 1; id <= limit; ++id) changes.add(id);
  EXPECT_TRUE(changes.are_complete());
  EXPECT_LT(changes.memory(), 64 * ObjectChanges::max_logged);
  changes.add(0);
  EXPECT_FALSE(changes.are_complete() || changes.lacks(-1) || changes.are_none());
  EXPECT_EQ(changes.memory(), 0u);
  journal.rewind(mark);
  EXPECT_FALSE(changes.are_complete()) << "the first half is not logged either";
  journal.end(Journal::Ended::rolled_back);
  changes.start_keeping();
  EXPECT_TRUE(changes.are_complete() && changes.lacks(1));
}

class StoreChanges : public ::testing::Test {
 protected:
  StoreChanges() {
    sqlite3_foresee_init(db, nullptr, nullptr);
    db.run("CREATE VIRTUAL TABLE ships USING moving_objects(id, x, r, +name)");
    db.run(
        "CREATE TRIGGER refuse BEFORE INSERT ON ships_aux WHEN new.a0 = 'bad' "
        "BEGIN SELECT raise(ABORT, 'bad'); END");
  }
  bool run(const std::string& sql) {
    return sqlite3_exec(db, sql.c_str(), nullptr, nullptr, nullptr) == SQLITE_OK;
  }
  Store& store() { return *find_open_store(db, {"main", "ships"}); }
  Objects objects() {
    Objects all;
    sqlite3_stmt* select = nullptr;
    sqlite3_prepare_v2(db, "SELECT id, x, r FROM ships", -1, &select, nullptr);
    while (sqlite3_step(select) == SQLITE_ROW)
      all[sqlite3_column_int64(select, 0)] = {sqlite3_column_double(select, 1),
                                              sqlite3_column_double(select, 2)};
    EXPECT_EQ(sqlite3_finalize(select), SQLITE_OK);
    return all;
  }
  /// A name in `_meta`, as CREATE of a watch writes it. Commits skip the watch, which does not exist.
  void watch() { store().add_watch("alerts"); }
  Difference reported() {
    Difference all;
    store().for_each_change([&](std::int64_t id, std::span<const double> record) {
      EXPECT_TRUE(all.emplace(id, Record(record.begin(), record.end())).second) << id << " is reported twice";
    });
    return all;
  }
  /// The objects that a transaction has changed, and savepoints that go back to fewer.
  struct Changed {
    std::set<std::int64_t> ids;
    std::vector<std::set<std::int64_t>> at_savepoints;

    /// After a statement that has succeeded.
    void note(const std::string& sql, const Objects& before, const Objects& after) {
      for (const auto& [id, record] : difference(before, after)) ids.insert(id);
      // An object that takes the place of an equal one has changed both.
      const std::size_t at = sql.find("SET id = ");
      std::int64_t to = 0, from = 0;
      if (at != std::string::npos &&
          std::sscanf(sql.c_str() + at, "SET id = %ld WHERE id = %ld", &to, &from) == 2 && to != from &&
          before.contains(from))
        ids.insert({to, from});
    }
    /// These objects as they are now.
    Difference now(const Objects& objects) const {
      Difference all;
      for (const std::int64_t id : ids) {
        const auto found = objects.find(id);
        all[id] = found == objects.end() ? Record() : found->second;
      }
      return all;
    }
  };
  static Difference difference(const Objects& before, const Objects& after) {
    Difference all = after;
    for (const auto& [id, record] : before) all.try_emplace(id);
    std::erase_if(all, [&](const auto& one) {
      const auto old = before.find(one.first);
      return old != before.end() && old->second == one.second;
    });
    return all;
  }

  Database db;
};

TEST_F(StoreChanges, AreThoseOfATransaction) {
  run("INSERT INTO ships VALUES(1, 10, 1, 'one'), (2, 20, 2, 'two'), (3, 30, 3, 'three'), (4, 40, 4, "
      "'four')");
  watch();
  EXPECT_EQ(reported(), Difference{});
  run("BEGIN; UPDATE ships SET x = 11 WHERE id = 1; UPDATE ships SET x = 12 WHERE id = 1");
  run("UPDATE ships SET id = 5 WHERE id = 2; DELETE FROM ships WHERE id = 3; INSERT INTO ships VALUES(6, 60, "
      "6, '')");
  run("UPDATE ships SET name = 'other' WHERE id = 4");
  EXPECT_EQ(reported(), (Difference{{1, {12, 1}}, {2, {}}, {3, {}}, {5, {20, 2}}, {6, {60, 6}}}));
  run("UPDATE ships SET x = 10 WHERE id = 1; DELETE FROM ships WHERE id = 6; INSERT INTO ships VALUES(3, 30, "
      "3, '')");
  EXPECT_EQ(reported(), (Difference{{1, {10, 1}}, {2, {}}, {3, {30, 3}}, {5, {20, 2}}, {6, {}}}));
  run("INSERT OR REPLACE INTO ships VALUES(4, -40, 4, ''); UPDATE OR REPLACE ships SET id = 1 WHERE id = 5");
  EXPECT_EQ(reported(), (Difference{{1, {20, 2}}, {2, {}}, {3, {30, 3}}, {4, {-40, 4}}, {5, {}}, {6, {}}}));
  run("COMMIT");
  EXPECT_EQ(reported(), Difference{});
}

TEST_F(StoreChanges, AZeroThatChangesItsSignIsOne) {
  run("INSERT INTO ships VALUES(1, 0.0, 1, '')");
  watch();
  run("BEGIN; UPDATE ships SET x = -0.0");
  EXPECT_EQ(reported().size(), 1u);
  run("ROLLBACK");
}

TEST_F(StoreChanges, AreTheSameAfterRollbacksWritesAndErrors) {
  watch();
  std::mt19937 random(20261122);
  const auto below = [&](unsigned n) { return random() % n; };
  const auto id = [&] { return std::to_string(1 + below(30)); };
  unsigned refused = 0, differences = 0;
  for (int transaction = 0; transaction < 60; ++transaction) {
    Objects before = objects();
    Changed changed;
    ASSERT_TRUE(run("BEGIN"));
    unsigned depth = 0;
    for (unsigned step = 0; step < 40 && !sqlite3_get_autocommit(db); ++step) {
      const std::string x = std::to_string(below(5)), level = std::to_string(depth == 0 ? 0 : below(depth));
      const std::string statements[] = {
          "INSERT INTO ships VALUES(" + id() + ", " + x + ", 1, '')",
          "INSERT OR REPLACE INTO ships VALUES(" + id() + ", " + x + ", 2, '')",
          "INSERT OR REPLACE INTO ships VALUES(" + id() + ", " + x + ", 2, 'bad')",
          "INSERT OR IGNORE INTO ships VALUES(" + id() + ", 1, 2, ''), (" + id() + ", 2, 2, '')",
          "INSERT OR FAIL INTO ships VALUES(" + id() + ", 1, 3, ''), (" + id() + ", 1, 3, 'bad')",
          "INSERT INTO ships SELECT " + id() +
              " + value, value, 1, '' FROM (SELECT 0 AS value UNION VALUES(1), (2))",
          "UPDATE ships SET x = " + x + " WHERE id = " + id(),
          "UPDATE ships SET x = CASE WHEN id > " + id() + " THEN -1 ELSE 1e999 END",
          "UPDATE OR REPLACE ships SET id = " + id() + " WHERE id = " + id(),
          "UPDATE ships SET id = " + id() + " WHERE id = " + id(),
          "DELETE FROM ships WHERE id = " + id(),
          "INSERT INTO ships(ships) VALUES('integrity-check')",
          "INSERT INTO ships(ships) VALUES('optimize')",
          "CREATE TABLE other" + std::to_string(step) + "(a); ALTER TABLE other" + std::to_string(step) +
              " ADD b",
          "SAVEPOINT s" + std::to_string(depth),
          "SAVEPOINT s" + std::to_string(depth),
          "ROLLBACK TO s" + level,
          "RELEASE s" + level,
          below(8) == 0 ? "INSERT OR ROLLBACK INTO ships VALUES(1, 1e999, 1, '')" : "SELECT 1"};
      const std::string& sql = statements[below(std::size(statements))];
      const bool done = run(sql);
      refused += !done;
      if (sqlite3_get_autocommit(db)) break;
      const Objects now = objects();
      if (done && sql.starts_with("SAVEPOINT")) {
        ++depth;
        changed.at_savepoints.push_back(changed.ids);
      } else if (done && sql.starts_with("ROLLBACK TO")) {
        depth = static_cast<unsigned>(std::stoi(level)) + 1;
        changed.at_savepoints.resize(depth);
        changed.ids = changed.at_savepoints.back();
      } else if (done && sql.starts_with("RELEASE")) {
        depth = static_cast<unsigned>(std::stoi(level));
        changed.at_savepoints.resize(depth);
      } else if (done || sql.starts_with("INSERT OR FAIL")) {
        changed.note(sql, before, now);
      }
      before = now;
      const Difference expected = changed.now(now);
      ASSERT_EQ(reported(), expected) << "transaction " << transaction << ", step " << step << ": " << sql;
      differences += !expected.empty();
    }
    if (!sqlite3_get_autocommit(db)) {
      ASSERT_TRUE(run(below(3) ? "COMMIT" : "ROLLBACK"));
    }
    ASSERT_TRUE(objects().size() < 40 && reported().empty());
  }
  EXPECT_GT(refused, 100u);
  EXPECT_GT(differences, 1000u);
}

TEST_F(StoreChanges, AreNotKeptWithoutAWatch) {
  run("INSERT INTO ships VALUES(1, 10, 1, '')");
  run("BEGIN; UPDATE ships SET x = 11; INSERT INTO ships VALUES(2, 0, 0, '')");
  EXPECT_EQ(reported(), Difference{});
  watch();
  run("DELETE FROM ships WHERE id = 1; UPDATE ships SET x = 1 WHERE id = 2");
  EXPECT_EQ(reported(), Difference{}) << "the transaction has changed objects before it had a watch";
  run("COMMIT; BEGIN; UPDATE ships SET x = 12");
  EXPECT_EQ(reported(), (Difference{{2, {12, 0}}}));
  store().remove_watch("alerts");
  EXPECT_EQ(reported().size(), 1u) << "to the end of the transaction";
  run("COMMIT; BEGIN; UPDATE ships SET x = 13");
  EXPECT_EQ(reported(), Difference{});
  run("ROLLBACK");
}

TEST_F(StoreChanges, OfATableDroppedAndBackAreNotLost) {
  watch();
  run("BEGIN; INSERT INTO ships VALUES(1, 10, 1, ''); INSERT INTO ships(ships) VALUES('integrity-check')");
  EXPECT_FALSE(run("SAVEPOINT s; DROP TABLE ships")) << "a new store would not know what is written already";
  run("ROLLBACK TO s");
  EXPECT_EQ(reported(), (Difference{{1, {10, 1}}}));
  run("COMMIT; DROP TABLE ships");
}

}  // namespace
}  // namespace foresee
