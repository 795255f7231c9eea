// Streams of position updates: what an UPDATE writes and when, what other connections see, and 100,000
// consecutive changes.
#include <map>
#include <memory>
#include <random>

#include "database.h"
#include "sanitized.h"

namespace foresee::testing {
namespace {

class Statement {
 public:
  Statement(Database& db, const char* sql) {
    EXPECT_EQ(sqlite3_prepare_v3(db.handle(), sql, -1, SQLITE_PREPARE_PERSISTENT, &statement_, nullptr),
              SQLITE_OK)
        << sqlite3_errmsg(db.handle());
  }
  ~Statement() { sqlite3_finalize(statement_); }
  Statement(const Statement&) = delete;

  /// Runs the statement with these numbers as ?1, ?2, …
  template <class... Numbers>
  void run(std::int64_t id, Numbers... numbers) {
    int place = 1;
    sqlite3_bind_int64(statement_, place, id);
    (sqlite3_bind_double(statement_, ++place, numbers), ...);
    EXPECT_EQ(sqlite3_step(statement_), SQLITE_DONE);
    EXPECT_EQ(sqlite3_reset(statement_), SQLITE_OK);
  }

 private:
  sqlite3_stmt* statement_ = nullptr;
};

/// Counts the writes to each row of the shadow tables.
class Writes {
 public:
  explicit Writes(Database& db) : db_(db) {
    sqlite3_update_hook(
        db.handle(),
        [](void* self, int, const char*, const char* table, sqlite3_int64 row) {
          ++static_cast<Writes*>(self)->counts_[table][row];
        },
        this);
  }
  ~Writes() { sqlite3_update_hook(db_.handle(), nullptr, nullptr); }

  int rows(const std::string& table) { return static_cast<int>(counts_[table].size()); }
  int max_writes(const std::string& table) {
    int max_writes = 0;
    for (const auto& [row, count] : counts_[table]) max_writes = std::max(max_writes, count);
    return max_writes;
  }
  void forget() { counts_.clear(); }

 private:
  Database& db_;
  std::map<std::string, std::map<sqlite3_int64, int>> counts_;
};

void create(Database& db, int objects) {
  db.exec("PRAGMA synchronous = OFF");
  db.exec("CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy, r, +name)");
  db.exec("WITH RECURSIVE n(i) AS (VALUES(1) UNION ALL SELECT i + 1 FROM n WHERE i < " +
          std::to_string(objects) +
          ") INSERT INTO ships SELECT i, 0, (i * 7919) % 1000, (i * 104729) % 1000, 1, -1, 0.5, 'n' FROM n");
}

TEST(LiveUpdates, APreparedUpdateInATransactionWritesNothingUntilCommit) {
  Database db;
  create(db, 5000);
  Statement update(db, "UPDATE ships SET x = x + ?2, t = t + 1 WHERE id = ?1");
  Writes writes(db);
  db.exec("BEGIN");
  for (int round = 0; round < 3; ++round)
    for (int id = 1; id <= 5000; id += 3) update.run(id, 0.01);
  EXPECT_EQ(writes.rows("ships_node"), 0);
  EXPECT_EQ(writes.rows("ships_map"), 0);
  EXPECT_EQ(db.rows("SELECT t FROM ships WHERE id = 4"), "3.0");
  db.exec("COMMIT");
  EXPECT_GT(writes.rows("ships_node"), 50);
  EXPECT_EQ(writes.max_writes("ships_node"), 1) << "each node is written once";
  EXPECT_EQ(writes.rows("ships_aux"), 0);
  db.exec("INSERT INTO ships(ships) VALUES('integrity-check')");
}

TEST(LiveUpdates, AnUpdateThatLeavesItsBoundsValidTouchesOneLeaf) {
  Database db;
  create(db, 5000);
  // A newer neighbour moves with the same velocity, so no node above the leaf changes.
  db.exec("UPDATE ships SET t = 1, x = x + 1, y = y - 1");
  Statement update(db, "UPDATE ships SET r = r - 0.1 WHERE id = ?1");
  Writes writes(db);
  update.run(2500);
  EXPECT_EQ(writes.rows("ships_node"), 1);
  EXPECT_EQ(writes.rows("ships_map"), 0);
}

// Leaves spread as objects move, and the tree reorganizes a few at a time.
TEST(LiveUpdates, ACommitOfOneReportIsSmallHoweverLongTheFeed) {
  Database db;
  create(db, 3000);
  Statement report(db, "UPDATE ships SET t = ?2, x = x + ?3, y = y + ?4, vx = ?5, vy = ?6 WHERE id = ?1");
  Writes writes(db);
  std::mt19937_64 random(9);
  std::uniform_int_distribution<int> id(1, 3000);
  std::uniform_real_distribution<double> velocity(-3, 3);
  const int reports = sanitized ? 2000 : 9000;
  int max_writes = 0;
  for (int i = 0; i < reports; ++i) {
    writes.forget();
    report.run(id(random), i * 0.01, velocity(random), velocity(random), velocity(random), velocity(random));
    max_writes = std::max(max_writes, writes.rows("ships_node") + writes.rows("ships_map"));
  }
  EXPECT_LE(max_writes, 200);
  EXPECT_LE(std::stoi(db.rows("SELECT count(*) FROM ships_node")), 1.3 * (3000 / 63 + 2))
      << "leaves stay full";
  db.exec("INSERT INTO ships(ships) VALUES('integrity-check')");
}

TEST(LiveUpdates, ManyInsertsAreLoadedTogetherHoweverManyStatementsMakeThem) {
  Database db;
  create(db, 100);
  Writes writes(db);
  Statement insert(db, "INSERT INTO ships(id, t, x, y, vx, vy, r) VALUES(?1, 0, ?2, ?3, 0, 0, 1)");
  db.exec("BEGIN");
  for (int id = 1001; id <= 8100; ++id) insert.run(id, id % 97, id % 89);
  EXPECT_EQ(writes.rows("ships_node") + writes.rows("ships_map"), 0);
  db.exec("COMMIT");
  EXPECT_EQ(writes.max_writes("ships_node"), 1);
  EXPECT_EQ(writes.max_writes("ships_map"), 1);
  EXPECT_EQ(db.rows("SELECT count(*) FROM ships_node"), std::to_string((7200 + 62) / 63 + 3 + 1))
      << "leaves of nine tenths";
}

TEST(LiveUpdates, ASavepointThatIsReleasedCostsNoWrite) {
  Database db;
  create(db, 1000);
  Writes writes(db);
  db.exec("BEGIN");
  for (int i = 0; i < 100; ++i) db.exec("SAVEPOINT s; UPDATE ships SET x = x + 1 WHERE id = 5; RELEASE s");
  EXPECT_EQ(writes.rows("ships_node"), 0);
  db.exec("SAVEPOINT s; DELETE FROM ships WHERE id < 500; ROLLBACK TO s; RELEASE s; COMMIT");
  EXPECT_EQ(writes.max_writes("ships_node"), 1);
  EXPECT_EQ(db.rows("SELECT count(*) FROM ships"), "1000");
  EXPECT_EQ(db.rows("SELECT x FROM ships WHERE id = 5"), "695.0");
  db.exec("INSERT INTO ships(ships) VALUES('integrity-check')");
}

TEST(LiveUpdates, OtherConnectionsSeeACommitAtTheirNextStatementAndNeverHalfOfIt) {
  TemporaryFile file;
  Database writer(file.path()), reader(file.path());
  writer.exec("PRAGMA journal_mode = wal");
  create(writer, 500);
  const std::string sum = "SELECT count(*), sum(t), (SELECT t FROM ships WHERE id = 3) FROM ships";
  EXPECT_EQ(reader.rows(sum), "500|0.0|0.0");
  writer.exec("BEGIN; UPDATE ships SET t = 1; DELETE FROM ships WHERE id > 400");
  EXPECT_EQ(reader.rows(sum), "500|0.0|0.0");
  reader.exec("BEGIN");
  EXPECT_EQ(reader.rows(sum), "500|0.0|0.0");
  writer.exec("COMMIT");
  EXPECT_EQ(reader.rows(sum), "500|0.0|0.0") << "the reader's snapshot is unchanged, and blocks no writer";
  reader.exec("COMMIT");
  EXPECT_EQ(reader.rows(sum), "400|400.0|1.0");
  reader.exec("UPDATE ships SET t = 2 WHERE id = 3");
  EXPECT_EQ(writer.rows(sum), "400|401.0|2.0");
  writer.exec("UPDATE ships SET t = 3 WHERE id <= 3");
  reader.exec("DELETE FROM ships WHERE id = 4; INSERT INTO ships(ships) VALUES('integrity-check')");
  EXPECT_EQ(writer.rows(sum), "399|405.0|3.0");
}

TEST(LiveUpdates, TheDefaultNowFollowsTheNewestRow) {
  Database db;
  create(db, 300);
  db.exec("INSERT INTO ships VALUES(9000, 50, 5, 5, 0, 0, 1, 'late'), (9001, 50, 6, 5, 0, 0, 1, 'late')");
  const std::string touching =
      "SELECT t FROM predictive_join(1, 'ships') WHERE a = 9000 AND b = 9001 LIMIT 1";
  EXPECT_EQ(db.rows(touching), "50.0");
  db.exec("BEGIN; INSERT INTO ships VALUES(9002, 70, 5, 5, 0, 0, 1, 'later')");
  EXPECT_EQ(db.rows(touching), "70.0");
  db.exec("DELETE FROM ships WHERE id = 9002");
  EXPECT_EQ(db.rows(touching), "50.0");
  db.exec("COMMIT");
  EXPECT_EQ(db.rows(touching), "50.0");
}

TEST(LiveUpdates, ManyMixedChangesWithAMovingNowLoseNothing) {
  Database db;
  create(db, 3000);
  std::map<std::int64_t, double> model;
  for (int id = 1; id <= 3000; ++id) model[id] = (id * 7919) % 1000;
  Statement insert(db, "INSERT INTO ships(id, t, x, y, vx, vy, r) VALUES(?1, ?2, ?3, ?4, ?5, ?6, 0.5)");
  Statement update(db, "UPDATE ships SET t = ?2, x = ?3, y = ?4, vx = ?5, vy = ?6 WHERE id = ?1");
  Statement erase(db, "DELETE FROM ships WHERE id = ?1");
  std::mt19937_64 random(1121);
  const auto number = [&](double size) { return static_cast<double>(random() % 100000) / 100000 * size; };
  const int steps = sanitized ? 20'000 : 100'000;
  for (int step = 0; step < steps; ++step) {
    if (step % 1000 == 0) db.exec("BEGIN");
    const auto id = static_cast<std::int64_t>(random() % 6000);
    const double t = step * 0.01, x = number(1000), y = number(1000), vx = number(6) - 3, vy = number(6) - 3;
    if (!model.contains(id)) {
      insert.run(id, t, x, y, vx, vy), model[id] = x;
    } else if (random() % 4 == 0) {
      erase.run(id), model.erase(id);
    } else {
      update.run(id, t, x, y, vx, vy), model[id] = x;
    }
    if (step % 1000 == 999) db.exec("COMMIT");
    if (step % 20000 == 19999) db.exec("INSERT INTO ships(ships) VALUES('integrity-check')");
  }
  double sum = 0;
  for (const auto& [id, x] : model) sum += x;
  EXPECT_EQ(db.rows("SELECT count(*) FROM ships"), std::to_string(model.size()));
  EXPECT_NEAR(std::stod(db.rows("SELECT sum(x) FROM ships")), sum, 1e-6 * sum);
  for (const std::int64_t id : {1, 77, 2999, 5000})
    EXPECT_EQ(db.rows("SELECT count(*) FROM ships WHERE id = " + std::to_string(id)),
              model.contains(id) ? "1" : "0");
}

}  // namespace
}  // namespace foresee::testing
