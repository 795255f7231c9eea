// Statements that look up objects by id, row after row, while the table changes between their rows, or by plan IS NULL.
#include <functional>
#include <random>

#include "sqlite/database.h"

namespace foresee::testing {
namespace {

/// A statement that joins a list of ids to the table, one row at a time.
class SteppedJoin {
 public:
  explicit SteppedJoin(Database& db, const std::string& table = "ships") : db_(db) {
    const std::string sql = "SELECT l.id, s.x FROM list l CROSS JOIN " + table + " s ON s.id = l.id";
    EXPECT_EQ(sqlite3_prepare_v2(db.handle(), sql.c_str(), -1, &statement_, nullptr), SQLITE_OK)
        << sqlite3_errmsg(db.handle());
  }
  ~SteppedJoin() { sqlite3_finalize(statement_); }
  SteppedJoin(const SteppedJoin&) = delete;

  /// The next row as "id|x"; "" at the end.
  std::string next() {
    const int rc = sqlite3_step(statement_);
    if (rc == SQLITE_DONE) return "";
    if (rc != SQLITE_ROW) return std::string("error: ") + sqlite3_errmsg(db_.handle());
    return printable(sqlite3_column_value(statement_, 0)) + "|" +
           printable(sqlite3_column_value(statement_, 1));
  }

 private:
  Database& db_;
  sqlite3_stmt* statement_ = nullptr;
};

struct TableLookUp : ::testing::Test {
  TableLookUp() {
    db.exec(
        "PRAGMA journal_mode = wal;"
        "CREATE VIRTUAL TABLE ships USING moving_objects(id, x, vx);"
        "CREATE TABLE list(id INTEGER PRIMARY KEY);"
        "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 400)"
        "INSERT INTO ships SELECT i, i, 1 FROM n;"
        "INSERT INTO list SELECT id FROM ships");
  }

  TemporaryFile file;
  Database db{file.path()};
};

TEST_F(TableLookUp, ARunningStatementSeesNoCommitOfAnotherConnectionAndTheNextOneDoes) {
  Database other(file.path());
  for (int round = 0; round < 3; ++round) {
    SteppedJoin join(db);
    const int before = 1000 * round;
    EXPECT_EQ(join.next(), "1|" + std::to_string(before + 1) + ".0");
    other.exec("UPDATE ships SET x = x + 1000; INSERT INTO ships(ships) VALUES('rebuild')");
    for (int id = 2; id <= 400; ++id)
      ASSERT_EQ(join.next(), std::to_string(id) + "|" + std::to_string(before + id) + ".0");
    EXPECT_EQ(join.next(), "");
  }
  EXPECT_EQ(db.rows("SELECT x FROM ships WHERE id = 400"), "3400.0");
}

TEST_F(TableLookUp, ChangesDuringTheJoinAreSeenAtOnce) {
  SteppedJoin join(db);
  EXPECT_EQ(join.next(), "1|1.0");
  EXPECT_EQ(join.next(), "2|2.0");
  db.exec("UPDATE ships SET x = -3 WHERE id = 3");
  EXPECT_EQ(join.next(), "3|-3.0");
  db.exec("BEGIN; UPDATE ships SET x = -id; DELETE FROM ships WHERE id = 5");
  EXPECT_EQ(join.next(), "4|-4.0");
  EXPECT_EQ(join.next(), "6|-6.0");
  db.exec("SAVEPOINT s; UPDATE ships SET x = 70 WHERE id = 7; INSERT INTO ships(ships) VALUES('rebuild')");
  EXPECT_EQ(join.next(), "7|70.0");
  db.exec("UPDATE ships SET x = 80 WHERE id = 8; ROLLBACK TO s; RELEASE s");
  EXPECT_EQ(join.next(), "8|-8.0");
  db.exec("COMMIT");
  EXPECT_EQ(join.next(), "9|-9.0");
  db.exec("BEGIN; UPDATE ships SET x = 0; DELETE FROM ships WHERE id = 11");
  EXPECT_EQ(join.next(), "10|0.0");
  db.exec("ROLLBACK");
  EXPECT_EQ(join.next(), "11|-11.0");
  db.exec("INSERT INTO ships(ships) VALUES('optimize')");
  EXPECT_EQ(join.next(), "12|-12.0");
  EXPECT_EQ(db.code_of("DROP TABLE ships"), SQLITE_LOCKED);
  EXPECT_EQ(join.next(), "13|-13.0");
}

TEST_F(TableLookUp, AfterACommitDuringTheJoinOtherConnectionsCommitsAreNotSeen) {
  Database other(file.path());
  SteppedJoin join(db);
  db.exec("BEGIN");
  EXPECT_EQ(join.next(), "1|1.0");
  db.exec("UPDATE ships SET x = x + 0.5; COMMIT");
  EXPECT_EQ(join.next(), "2|2.5");
  other.exec("UPDATE ships SET x = 0; INSERT INTO ships(ships) VALUES('rebuild')");
  for (int id = 3; id <= 400; ++id)
    ASSERT_EQ(join.next(), std::to_string(id) + "|" + std::to_string(id) + ".5");
}

TEST_F(TableLookUp, TablesOfAttachedFilesToo) {
  TemporaryFile second;
  db.exec("ATTACH '" + second.path() +
          "' AS far; PRAGMA far.journal_mode = wal;"
          "CREATE VIRTUAL TABLE far.boats USING moving_objects(id, x);"
          "INSERT INTO boats SELECT id, x FROM ships");
  Database other(second.path());
  const std::string sum = "SELECT sum(s.x) FROM list l CROSS JOIN boats s ON s.id = l.id";
  EXPECT_EQ(db.rows(sum), "80200.0");
  SteppedJoin join(db, "boats");
  EXPECT_EQ(join.next(), "1|1.0");
  other.exec("UPDATE boats SET x = 1");
  for (int id = 2; id <= 400; ++id)
    ASSERT_EQ(join.next(), std::to_string(id) + "|" + std::to_string(id) + ".0");
  EXPECT_EQ(join.next(), "");
  EXPECT_EQ(db.rows(sum), "400.0");
  db.exec("BEGIN; UPDATE boats SET x = 2; ROLLBACK");
  EXPECT_EQ(db.rows(sum), "400.0");
}

TEST_F(TableLookUp, ManyIdsAndCorrelatedSubqueriesFindThemAll) {
  EXPECT_EQ(db.rows("SELECT count(*), sum(x) FROM ships WHERE id IN (SELECT id FROM list WHERE id % 3 = 0)"),
            "133|26733.0");
  EXPECT_EQ(db.rows("SELECT sum((SELECT x FROM ships s WHERE s.id = l.id)) FROM list l"), "80200.0");
  EXPECT_EQ(db.rows("SELECT count(*) FROM list l CROSS JOIN ships a ON a.id = l.id CROSS JOIN ships b "
                    "ON b.id = 401 - a.id WHERE a.x + b.x = 401"),
            "400");
}

TEST_F(TableLookUp, RandomStatementsAgreeWithAnOrdinaryTable) {
  db.exec("CREATE TABLE model(id INTEGER PRIMARY KEY, x); INSERT INTO model SELECT id, x FROM ships");
  std::mt19937 random(3);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const auto both = [&](const std::string& before, const std::string& after) {
    for (const char* table : {"ships", "model"}) db.exec(before + table + after);
  };
  for (int round = 0; round < 30; ++round) {
    SteppedJoin ours(db, "ships"), theirs(db, "model");
    bool in_transaction = false;
    for (std::string row = "-"; !row.empty() && !HasFailure();) {
      const std::string id = std::to_string(1 + below(400)), x = std::to_string(below(1000)) + ".0";
      switch (below(40)) {
        case 0:
          if (!in_transaction) db.exec("BEGIN"), in_transaction = true;
          break;
        case 1:
          if (in_transaction) db.exec("COMMIT"), in_transaction = false;
          break;
        case 2:
          if (in_transaction) db.exec("ROLLBACK"), in_transaction = false;
          break;
        case 3:
          both("UPDATE ", " SET x = x + 1");
          break;
        case 4:
          both("DELETE FROM ", " WHERE id = " + id);
          break;
        case 5:
          both("INSERT OR REPLACE INTO ", "(id, x) VALUES(" + id + ", " + x + ")");
          break;
        case 6:
          both("UPDATE ", " SET x = " + x + " WHERE id = " + id);
          break;
        default:
          row = theirs.next();
          EXPECT_EQ(ours.next(), row);
      }
    }
    if (in_transaction) db.exec(below(2) ? "COMMIT" : "ROLLBACK");
  }
  EXPECT_EQ(db.rows("SELECT id, x FROM ships ORDER BY id"), db.rows("SELECT id, x FROM model ORDER BY id"));
  db.exec("INSERT INTO ships(ships) VALUES('integrity-check')");
}

/// The table itself answers IS NULL, in scans, by ids and beside other conditions; any other test reads the plans.
TEST(TableLookUps, ObjectsWithoutAPlanAreFoundByIsNull) {
  Database db;
  db.exec("CREATE VIRTUAL TABLE robots USING moving_objects(id, t, x, y, plan)");
  const std::string stops = "'LINESTRING M(0 0 0, 10 0 5, 10 0 9, 10 20 29)'";
  for (int id = 1; id <= 300; ++id)
    db.exec("INSERT INTO robots(id, plan, t, x, y) VALUES (" + std::to_string(id) + ", " +
            (id % 3 == 0 ? stops + ", NULL, NULL, NULL)" : "NULL, 0, 1, 2)"));
  for (const char* rest : {"", " AND id > 100", " AND id BETWEEN 5 AND 90", " AND x > 0",
                           " AND id IN (3, 4, 6)", " AND id = 9"}) {
    const std::string where = std::string(rest) + " ORDER BY id";
    for (const auto& [test, same] :
         {std::pair("plan IS NULL", "+plan IS NULL"), std::pair("plan NOTNULL", "+plan NOTNULL"),
          std::pair("NOT plan IS NULL", "length(plan) > 0")})
      EXPECT_EQ(db.rows(std::string("SELECT id, x FROM robots WHERE ") + test + where),
                db.rows(std::string("SELECT id, x FROM robots WHERE ") + same + where))
          << test << where;
  }
  EXPECT_EQ(db.rows("SELECT count(*), sum(plan IS NULL) FROM robots"), "300|200");
  EXPECT_EQ(db.rows("SELECT count(*) FROM robots WHERE plan IS NULL OR id = 3"), "201");
  EXPECT_EQ(db.rows("SELECT count(*) FROM robots WHERE rowid IS NULL"), "0");
  // Conditions of ON and of WHERE, on either side of a join, as of an ordinary table.
  db.exec(
      "CREATE TABLE copies AS SELECT id, x, plan FROM robots; CREATE TABLE n(i); INSERT INTO n VALUES (3), "
      "(4), (999)");
  for (const char* join : {"n LEFT JOIN % t", "% t LEFT JOIN n", "n JOIN % t"})
    for (const char* on : {"t.id = i", "t.id = i AND t.plan IS NULL", "t.id = i AND t.plan IS NOT NULL"})
      for (const char* where : {"1", "t.plan IS NULL", "t.plan IS NOT NULL", "t.plan IS NULL OR i = 3"}) {
        const auto rows_of = [&](const std::string& table) {
          std::string from = join;
          from.replace(from.find('%'), 1, table);
          return db.rows("SELECT i, t.id FROM " + from + " ON " + on + " WHERE " + where + " ORDER BY 1, 2");
        };
        EXPECT_EQ(rows_of("robots"), rows_of("copies")) << join << " ON " << on << " WHERE " << where;
      }
  db.exec("DELETE FROM robots WHERE plan IS NULL");
  EXPECT_EQ(db.rows("SELECT count(*), count(plan) FROM robots"), "100|100");
  db.exec("UPDATE robots SET plan = NULL, t = 0, x = 0, y = 0 WHERE plan IS NOT NULL AND id < 10");
  EXPECT_EQ(
      db.rows("SELECT group_concat(id) FROM (SELECT id FROM robots WHERE plan IS NULL ORDER BY id DESC)"),
      "9,6,3");
}

}  // namespace
}  // namespace foresee::testing
