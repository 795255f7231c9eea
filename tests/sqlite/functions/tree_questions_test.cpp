// Queries by the tree give what a scan of all objects gives: windows, nearest, joins and joins of one id.
// Meanwhile rows are inserted, moved and erased, within transactions and after rollbacks to savepoints.
#include "sqlite/scene_table.h"

namespace foresee::testing {
namespace {

std::string literal(double number) {
  char text[40];
  sqlite3_snprintf(sizeof text, text, "%!.17g", number);
  return text;
}

/// A table of a random scene, queried by two methods.
class RandomQueries {
 public:
  RandomQueries(const Layout& layout, SceneKind kind, std::size_t count, std::uint64_t seed)
      : scene_(random_scene({.layout = layout, .kind = kind, .count = count, .seed = seed})),
        random_(seed),
        tail_(", " + literal(scene_.now)) {
    db.exec("PRAGMA page_size = 512");  // several levels
    build_table(db, "objects", scene_);
    std::tie(lower_, upper_) = extent("x");
  }

  void expect_same_answers(int questions) {
    for (int i = 0; i < questions && !::testing::Test::HasFailure(); ++i) {
      expect_same_window();
      expect_same_nearest();
      expect_same_probe("a = ");
      expect_same_probe("b = ");
    }
    expect_same("SELECT * FROM predictive_join(" + h() + ", 'objects', " + literal(scene_.within) + ", NULL" +
                    tail_ + ", METHOD) ORDER BY a, b",
                "tree");
  }

  /// Moves some rows, deletes some, inserts some and changes some ids.
  void change() {
    const std::string some = std::to_string(random_.below(7));
    db.exec("UPDATE objects SET x = x + " + literal(random_.in(-2, 2)) + " WHERE id % 7 = " + some);
    db.exec("DELETE FROM objects WHERE id % 31 = " + some);
    db.exec("INSERT OR REPLACE INTO objects SELECT id + 100000, " + columns_of(scene_.layout) +
            " FROM objects WHERE id % 23 = " + some + " AND id < 100000");
    db.exec("UPDATE OR REPLACE objects SET id = -id WHERE id % 37 = " + some + " AND id > 0");
  }

  Database db;
  std::size_t answered = 0;

 private:
  std::pair<double, double> extent(const std::string& axis) {
    const std::string range = db.rows("SELECT min(" + axis + "), max(" + axis + ") FROM objects");
    return {std::stod(range), std::stod(range.substr(range.find('|') + 1))};
  }
  std::string h() const { return literal(scene_.h); }
  std::string place() { return literal(random_.in(lower_, upper_)); }

  void expect_same(std::string question, const std::string& method) {
    const auto rows_by = [&](const std::string& name) {
      return db.rows(std::string(question).replace(question.find("METHOD"), 6, "'" + name + "'"));
    };
    const std::string found = rows_by(method), right = rows_by("scan");
    EXPECT_EQ(found.substr(0, 6) == "error:", false) << found;
    EXPECT_TRUE(found == right) << method << ": " << question << "\n"
                                << found.substr(0, 300) << "\nscan:\n"
                                << right.substr(0, 300);
    answered += right.size();
  }

  void expect_same_window() {
    const double x = random_.in(lower_, upper_), width = (upper_ - lower_) * random_.unit() * 0.3;
    std::string bounds = literal(x) + ", " + literal(x + width);
    if (scene_.layout.axes > 1) bounds += ", " + literal(lower_) + ", NULL";
    for (int axis = scene_.layout.axes > 1 ? 2 : 1; axis < 3; ++axis) bounds += ", NULL, NULL";
    const std::string velocity = random_.below(2) ? ", 0.5, NULL, NULL" : ", NULL, NULL, NULL";
    const std::string call = "predictive_window(" + h() + ", 'objects', " + bounds + tail_ + velocity;
    expect_same("SELECT * FROM " + call + ", METHOD) ORDER BY id", "tree");
    EXPECT_TRUE(
        db.rows("SELECT w.* FROM objects o CROSS JOIN " + call + ") w WHERE w.id = o.id ORDER BY w.id") ==
        db.rows("SELECT * FROM " + call + ") ORDER BY id"))
        << "one object after another: " << call;
  }
  void expect_same_nearest() {
    std::string point = place();
    for (int axis = 1; axis < 3; ++axis) point += axis < scene_.layout.axes ? ", " + place() : ", NULL";
    expect_same("SELECT * FROM predictive_nearest(" + std::string(random_.below(3) ? h() : "0") +
                    ", 'objects', " + std::to_string(1 + random_.below(12)) + ", " + point + tail_ +
                    ", 0.25, NULL, NULL, METHOD) ORDER BY rank",
                "auto");
  }
  void expect_same_probe(const std::string& column) {
    const std::string other = random_.below(2) ? "'objects'" : "NULL";
    expect_same("SELECT * FROM predictive_join(" + h() + ", 'objects', " + literal(scene_.within) + ", " +
                    other + tail_ + ", METHOD) WHERE " + column +
                    "(SELECT id FROM objects ORDER BY id LIMIT 1 OFFSET " +
                    std::to_string(random_.below(40)) + ") ORDER BY a, b",
                random_.below(2) ? "auto" : "tree");
  }

  RandomScene scene_;
  Random random_;
  std::string tail_;  ///< of a call, from its input now on
  double lower_ = 0, upper_ = 0;
};

class TreeQuestionsOfEveryLayout : public ::testing::TestWithParam<Layout> {};

TEST_P(TreeQuestionsOfEveryLayout, AgreeWithAScanOfAllObjects) {
  std::size_t answered = 0;
  for (const SceneKind kind : all_scene_kinds) {
    RandomQueries queried(GetParam(), kind, 60, 5);
    queried.expect_same_answers(1);
    queried.change();
    queried.expect_same_answers(1);
    answered += queried.answered;
  }
  EXPECT_GT(answered, 0u);
}

INSTANTIATE_TEST_SUITE_P(AxesLawShapeTimes, TreeQuestionsOfEveryLayout, ::testing::ValuesIn(all_layouts()));

TEST(TreeQuestions, AgreeThroughTransactionsAndSavepoints) {
  RandomQueries queried({.axes = 2, .law = Law::uniform, .shape = Shape::ball, .has_t = true},
                        SceneKind::clustered, 800, 6);
  for (int round = 0; round < 6; ++round) {
    queried.db.exec("BEGIN");
    queried.change();
    queried.expect_same_answers(2);
    queried.db.exec("SAVEPOINT a");
    queried.change();
    queried.expect_same_answers(1);
    queried.db.exec("SAVEPOINT b; DELETE FROM objects WHERE id % 2 = 0");
    queried.expect_same_answers(1);
    queried.db.exec("ROLLBACK TO b");
    queried.expect_same_answers(1);
    if (round % 3 == 0) queried.db.exec("ROLLBACK TO a");
    queried.expect_same_answers(1);
    queried.db.exec(round % 2 ? "COMMIT" : "ROLLBACK");
    queried.expect_same_answers(1);
  }
  queried.db.exec("INSERT INTO objects(objects) VALUES('integrity-check')");
}

TEST(TreeQuestions, ALoopThatWritesSeesTheTreeAsItWas) {
  Database db;
  db.exec(
      "CREATE VIRTUAL TABLE ships USING moving_objects(id, x, y, vx, vy, r);"
      "WITH n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 2000)"
      "INSERT INTO ships SELECT i, i % 50, i / 50, 0, 0, 0.5 FROM n");
  const char* question = "SELECT id FROM predictive_window(5, 'ships', 10, 39)";
  const std::string right = db.rows("SELECT count(*), sum(id) FROM (" + std::string(question) + ")");
  sqlite3_stmt* reading = nullptr;
  ASSERT_EQ(sqlite3_prepare_v2(db.handle(), question, -1, &reading, nullptr), SQLITE_OK);
  std::int64_t count = 0, sum = 0;
  while (sqlite3_step(reading) == SQLITE_ROW) {
    const std::string id = std::to_string(sqlite3_column_int64(reading, 0));
    sum += sqlite3_column_int64(reading, 0), ++count;
    if (count % 3 == 0) db.exec("UPDATE ships SET x = x + 100 WHERE id = " + id + " + 1");
    if (count % 3 == 1) db.exec("DELETE FROM ships WHERE id = " + id + " + 2");
    if (count == 50) db.exec("INSERT INTO ships(ships) VALUES('rebuild')");
  }
  sqlite3_finalize(reading);
  EXPECT_EQ(std::to_string(count) + "|" + std::to_string(sum), right);
}

TEST(TreeQuestions, HorizonsOfEverySize) {
  for (const char* motion : {"0, 0", "3, 0", "i % 3 - 1, 0", "i % 3 - 1, i % 2"})
    for (const char* h :
         {"0", "1e-300", "1e-12", "10", "1e12", "1e100", "1e153", "1e155", "1e200", "1e300", "1e308"}) {
      Database db;
      db.exec(
          "PRAGMA page_size = 512; CREATE VIRTUAL TABLE ships USING moving_objects(id, x, vx, ax);"
          "WITH n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 60)"
          "INSERT INTO ships SELECT i, i * 2, " +
          std::string(motion) + " FROM n");
      const auto rows_by = [&](const std::string& method) {
        return db.rows("SELECT a, b, t FROM predictive_join(" + std::string(h) + ", 'ships', 3, NULL, 0, '" +
                       method + "') ORDER BY a, b");
      };
      for (const char* method : {"grid", "tree", "gpcd"})
        EXPECT_TRUE(rows_by(method) == rows_by("scan")) << method << ", h = " << h << ", " << motion;
      for (const char* question : {"SELECT * FROM predictive_window(", "SELECT * FROM predictive_nearest("}) {
        const std::string queried =
            question + std::string(h) + ", 'ships', " + (question[26] == 'w' ? "7, 9" : "4, 8");
        EXPECT_EQ(db.rows(queried + ") WHERE method = 'tree' ORDER BY 1, 2"),
                  db.rows(queried + ") WHERE method = 'scan' ORDER BY 1, 2"));
      }
    }
}

TEST(TreeQuestions, NowAfterTheNewestRowIsGone) {
  Database db;
  db.exec(
      "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, vx);"
      "INSERT INTO ships VALUES(1, 10, 0, 1), (2, 20, 0, 1), (3, 30, 0, 1); DELETE FROM ships WHERE id = 3");
  EXPECT_EQ(db.rows("SELECT id, t FROM predictive_window(5, 'ships', 0) ORDER BY id"), "1|20.0\n2|20.0");
}

// Each row of the left table is a query by the tree. The rows that no such query has found are those of a query of all:
// SQLite compares the whole key, of which the statement may read a part.
TEST(TreeQuestions, FullJoinGivesEachRowOnce) {
  if (sqlite3_libversion_number() < 3039000) GTEST_SKIP() << "SQLite has no FULL JOIN";
  Database db;
  db.exec(
      "CREATE VIRTUAL TABLE objects USING moving_objects(id, x, y, vx, vy, r);"
      "WITH RECURSIVE n(i) AS (VALUES (1) UNION ALL SELECT i + 1 FROM n WHERE i < 150) INSERT INTO objects "
      "SELECT i, i * 37 % 101 * 0.3, i * 53 % 97 * 0.3, i % 7 - 3, i % 5 - 2, 0.1 + i % 11 * 0.1 FROM n;"
      "CREATE TABLE others(id INTEGER PRIMARY KEY);"
      "INSERT INTO others SELECT id FROM objects WHERE id % 3 > 0");
  const std::string in_window = "predictive_window(9, 'objects', 5, 25, 0, 20)",
                    pairs = "predictive_join(3, 'objects')";
  struct Joined {
    std::string from, id;
    std::vector<const char*> outputs;
  };
  for (const Joined& one : {Joined{in_window, "id", {"id, w.id", "id, w.t", "id, w.t_end", "id, w.dt_end"}},
                            Joined{pairs, "a", {"a, w.a", "a, w.b", "b, w.t", "b, w.t_end"}},
                            Joined{pairs, "b", {"a, w.a", "a, w.b", "a, w.t_end"}}}) {
    db.exec("DROP TABLE IF EXISTS copy; CREATE TEMP TABLE copy AS SELECT * FROM " + one.from);
    EXPECT_NE(db.rows("SELECT id FROM others EXCEPT SELECT " + one.id + " FROM copy"), "");
    EXPECT_NE(db.rows("SELECT " + one.id + " FROM copy EXCEPT SELECT id FROM others"), "");
    for (const std::string output : one.outputs) {
      const auto joined = [&](const std::string& right) {
        return db.rows("SELECT o.id, w." + output + " FROM others o FULL JOIN " + right + " w ON w." +
                       one.id + " = o.id ORDER BY 1, 2, 3");
      };
      EXPECT_EQ(joined(one.from), joined("copy")) << one.from << " on " << one.id << ": " << output;
    }
  }
}

}  // namespace
}  // namespace foresee::testing
