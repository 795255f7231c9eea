// Inputs that are NULL beside conditions on ids: no plan loses a row, whatever was planned before.
#include <sstream>

#include "sqlite/harbour_scene.h"
#include "sqlite/scene_table.h"

namespace foresee::testing {
namespace {

/// SQLite plans the sides of an OR separately, and drops every row of a side that has an input NULL.
struct NullInputs : ::testing::Test {
  NullInputs() {
    build_table(db, "ships",
                random_scene({.layout = {.axes = 2, .law = Law::uniform, .shape = Shape::ball},
                              .kind = SceneKind::clustered,
                              .count = 400,
                              .seed = 3}));
    db.exec("CREATE TABLE bounds(low, high, who); INSERT INTO bounds VALUES (NULL, 90, NULL)");
  }

  /// The statements before: run to the end, or prepared only.
  void plan_before(const std::string& sql, bool runs) {
    before_ = (runs ? "running " : "preparing ") + sql;
    if (runs) {
      db.rows(sql);
      return;
    }
    sqlite3_stmt* statement = nullptr;
    EXPECT_EQ(sqlite3_prepare_v2(db.handle(), sql.c_str(), -1, &statement, nullptr), SQLITE_OK) << sql;
    sqlite3_finalize(statement);
  }

  /// `call`: up to AND or WHERE; `conditions`: on ids, each with a blank behind. `+id` keeps SQLite from passing it on.
  void expect_all(const std::string& outputs, const std::string& call, std::string conditions) {
    const std::string select = "SELECT " + outputs + " FROM " + call + " ";
    const std::string rows = db.rows(select + conditions + " ORDER BY " + outputs);
    // After a statement that was planned and not run, an input that may be NULL may be refused; no row is lost.
    if (before_.starts_with("preparing") && call.find("q.") != std::string::npos &&
        rows.find(" is NULL, which OR and more than sixteen conditions do not allow") != std::string::npos)
      return;
    EXPECT_NE(rows, "") << call << ' ' << conditions;
    for (const std::string id : {"a ", "b ", "id "})
      for (std::size_t at = 0; (at = conditions.find(id, at)) != std::string::npos; at += 3)
        if (at == 0 || conditions[at - 1] == ' ' || conditions[at - 1] == '(') conditions.insert(at, "+");
    EXPECT_EQ(rows, db.rows(select + conditions + " ORDER BY " + outputs))
        << call << ' ' << conditions << " after " << before_;
  }

  Database db;
  std::string before_;
};

TEST_F(NullInputs, OfAJoinLoseNoPair) {
  const char* calls[] = {
      "predictive_join WHERE h = 3 AND within = NULL AND",
      "predictive_join WHERE h = 3 AND tbl = 'ships' AND within = 0 AND now = NULL AND",
      "predictive_join WHERE h = 3 AND within IS NULL AND method IS NULL AND",
      "predictive_join(3, 'ships', NULL) WHERE",
      "predictive_join(3, NULL, NULL, NULL, NULL) WHERE",
      "predictive_join(3, 'ships') WHERE",
      "bounds q, predictive_join(3, q.who) WHERE",
      "(SELECT 3 AS h, NULL AS who) q, predictive_join(q.h, q.who) WHERE",
  };
  const std::string a = db.rows(
                        "SELECT a FROM predictive_join(3) GROUP BY a ORDER BY count(*) DESC, a LIMIT 1"),
                    b = db.rows(
                        "SELECT b FROM predictive_join(3) GROUP BY b ORDER BY count(*) DESC, b LIMIT 1");
  const std::string ids[] = {"(a = " + a + " OR a = 42)",
                             "(a = " + a + " OR b = " + b + ")",
                             "(a = " + a + " OR (a = 42 AND dt >= 0))",
                             "(a IN (" + a + ", 42) OR b IN (" + b + ", 43))",
                             "a = " + a,
                             "a IN (" + a + ", 42) AND b > 0"};
  for (const bool runs : {true, false})
    for (const std::string& before :
         {std::string("SELECT * FROM predictive_join WHERE h = 3 AND within = NULL"),
          std::string("SELECT * FROM predictive_join(3) WHERE a = 1 OR b = 1"),
          std::string("SELECT * FROM predictive_join(3, NULL) WHERE a = 1 OR b = 1"),
          std::string("SELECT * FROM predictive_join(3) WHERE a = 1")})
      for (const char* call : calls)
        for (const std::string& some : ids) {
          plan_before(before, runs);
          expect_all("a, b", call, some);
        }
}

TEST_F(NullInputs, OfAJoinThatIsInnerLoseNoPair) {
  const std::string call =
      "ships s JOIN predictive_join j ON j.h = 3 AND j.within = NULL AND j.a = s.id WHERE";
  for (const char* sides : {"(j.b = 43 OR j.a = 42)", "(j.a = 42 OR j.a = 43)", "(s.id = 42 OR j.b = 43)"}) {
    plan_before("SELECT * FROM predictive_join(3) WHERE a = 1", true);
    std::string plain = sides;
    for (const std::string id : {"j.a", "j.b"})
      for (std::size_t at = 0; (at = plain.find(id, at)) != std::string::npos; at += 4) plain.insert(at, "+");
    const std::string rows = db.rows("SELECT a, b FROM " + call + ' ' + sides + " ORDER BY a, b");
    EXPECT_NE(rows, "") << sides;
    EXPECT_EQ(rows, db.rows("SELECT a, b FROM " + call + ' ' + plain + " ORDER BY a, b")) << sides;
  }
}

TEST_F(NullInputs, OfOneObjectLoseNoRow) {
  const char* calls[] = {
      "predictive_window WHERE h = 9 AND tbl = 'ships' AND x0 = NULL AND",
      "predictive_window WHERE h = 9 AND tbl = 'ships' AND x0 = NULL AND x1 = 1000 AND y1 = 1000 AND",
      "predictive_window WHERE h = 9 AND tbl = NULL AND",
      "predictive_window(9, 'ships', NULL, NULL, -1000, 1000) WHERE",
      "predictive_window(9, 'ships', -1000, 1000, -1000, 1000, NULL, NULL, NULL, NULL) WHERE",
      "bounds q, predictive_window(9, 'ships', q.low) WHERE",
      "(SELECT 9 AS h, NULL AS low) q, predictive_window(q.h, 'ships', q.low) WHERE",
      "predictive_position WHERE at = 3 AND tbl = NULL AND",
      "predictive_position(3, NULL) WHERE",
      "predictive_track WHERE t0 = 1 AND t1 = 3 AND step = 1 AND tbl = NULL AND",
  };
  const char* ids[] = {"(id = 1 OR id = 2)",   "(id = 1 OR (id = 2 AND id > 0))", "id IN (1, 2)",
                       "(id = 2 OR id > 398)", "(id = 2 OR id IN (3, 4))",        "id = 2"};
  for (const bool runs : {true, false})
    for (const char* before : {"SELECT * FROM predictive_window WHERE h = 1 AND x0 = NULL",
                               "SELECT * FROM predictive_window(1) WHERE id = 1 OR id = 3",
                               "SELECT * FROM predictive_position(1, NULL) WHERE id = 1"})
      for (const std::string call : calls)
        for (const char* some : ids) {
          plan_before(before, runs);
          expect_all("id", call, some);
        }
}

/// The names of the inputs of a function that may be left out.
std::vector<std::string> optional_inputs(Database& db, const std::string& function) {
  std::vector<std::string> names;
  std::istringstream all(
      db.rows("SELECT name FROM pragma_table_xinfo('" + function + "') WHERE hidden = 1 AND name <> 'call'"));
  for (std::string name; std::getline(all, name);) names.push_back(name);
  return {names.begin() + (function == "predictive_track" ? 3 : 1), names.end()};
}

TEST_F(NullInputs, AreLeftOutByIsNull) {
  for (const auto& [function, given] : std::vector<std::pair<std::string, std::string>>{
           {"predictive_join", "h = 3"},
           {"predictive_explain", "h = 3"},
           {"predictive_window", "h = 3"},
           {"predictive_nearest", "h = 3 AND k = 4 AND x = 1 AND y = 1"},
           {"predictive_sweep", "h = 3"},
           {"predictive_position", "at = 3"},
           {"predictive_track", "t0 = 1 AND t1 = 3 AND step = 1"}}) {
    const std::string count = "SELECT count(*) FROM " + function + " WHERE " + given;
    const std::string rows = db.rows(count);
    EXPECT_NE(rows, "0") << function;
    for (const std::string& input : optional_inputs(db, function)) {
      if (given.find(input + " = ") != std::string::npos) continue;
      EXPECT_EQ(db.rows(count + " AND " + input + " IS NULL"), rows) << function << ' ' << input;
    }
  }
}

}  // namespace
}  // namespace foresee::testing
