// Query plans of predictive_join: constraints on ids and times, NULLs, views, lateral calls.
#include "sqlite/functions/join_planner.h"

namespace foresee::testing {
namespace {

TEST_F(JoinPlanner, AListOfTimesIsOneCall) {
  const std::string some = " IN (SELECT t FROM whole WHERE t > 0 LIMIT 20)";
  EXPECT_NE(both("WHERE t" + some + " ORDER BY a, b"), "");
  both("WHERE dt" + some + " ORDER BY a, b");
  EXPECT_EQ(plan("SELECT * FROM predictive_join(3) WHERE t IN (1.5, 2)"),
            plan("SELECT * FROM predictive_join(3) WHERE +t IN (1.5, 2)"));
}

TEST_F(JoinPlanner, FiltersRowsAsAnyTableDoes) {
  const std::string id = db.rows("SELECT a FROM whole GROUP BY a ORDER BY count(*) DESC, a LIMIT 1");
  const std::string end = " ORDER BY a, b";
  EXPECT_NE(both("WHERE a = " + id + end), "");
  both("WHERE b = " + id + end);
  EXPECT_NE(both("WHERE a = " + id + " OR b = " + id + end), "");
  both("WHERE a = " + id + " AND b = 7" + end);
  both("WHERE (a = " + id + " OR b = " + id + ") AND dt > 0" + end);
  both("WHERE a IN (1, 2, " + id + ", NULL)" + end);
  both("WHERE a = " + id + ".0" + end);
  both("WHERE a = '" + id + "'" + end);
  both("WHERE a = 1.5" + end);
  both("WHERE a = 'x'" + end);
  both("WHERE a = NULL" + end);
  both("WHERE a IS " + id + end);
  both("WHERE a = 100000" + end);
  EXPECT_NE(both("WHERE dt > 0" + end), "");
  both("WHERE dt > 1" + end);
  both("WHERE dt >= 0" + end);
  both("WHERE dt >= 1 AND t < 2" + end);
  both("WHERE dt = 0" + end);
  both("WHERE dt > -1" + end);
  both("WHERE dt BETWEEN 0.5 AND 2.5" + end);
  both("WHERE dt > '1'" + end);
  both("WHERE dt > 0 AND a = " + id + end);
}

/// Of two lists only one is given to the call: else SQLite would make a call for each combination.
TEST_F(JoinPlanner, TwoListsOfIdsAreCallsForOneOfThem) {
  const std::string some = " IN (SELECT b FROM whole)", others = " IN (SELECT a FROM whole WHERE a % 3)",
                    end = " ORDER BY a, b";
  EXPECT_NE(both("WHERE a" + some + " AND b" + others + end), "");
  both("WHERE b" + some + " AND a" + others + end);
  both("WHERE a" + some + " AND b = 7" + end);
  both("WHERE a = 7 AND b" + some + end);
  both("WHERE a = 7 AND b = 9" + end);
  const auto calls = [this](const std::string& where) {
    const std::string steps = plan("SELECT * FROM predictive_join(3) WHERE " + where);
    return steps.substr(steps.find("INDEX 0:") + 24);
  };
  if (sqlite3_libversion_number() < 3038000) return;  // which does not tell a list from a value
  EXPECT_EQ(calls("a IN (1, 2) AND b IN (3, 4)").find("B="), std::string::npos);
  EXPECT_EQ(calls("a IN (1, 2) AND b = 7").find("A="), std::string::npos);
  EXPECT_EQ(calls("a = 7 AND b IN (1, 2)").find("B="), std::string::npos);
  EXPECT_NE(calls("a = 7 AND b = 9").find("B="), std::string::npos) << "a pair";
}

TEST_F(JoinPlanner, FindsEveryPairOfAnId) {
  for (int id = 1; id <= 400; id += 23) {
    const std::string either = "WHERE a = " + std::to_string(id) + " OR b = " + std::to_string(id);
    both(either + " ORDER BY a, b");
  }
}

TEST_F(JoinPlanner, ProbesOneObjectWhenItsIdIsGiven) {
  EXPECT_NE(plan("SELECT * FROM predictive_join(3) WHERE a = 42 OR b = 42").find("MULTI-INDEX OR"),
            std::string::npos);
}

/// SQLite would compare the input with itself, after a call without it.
TEST_F(JoinPlanner, AnInputTakesNoInequality) {
  const auto refusal = [](const std::string& name, const std::string& sign) {
    return name + " is an input, not an output: write " + name + " = ..., not " + name + ' ' + sign + " ...";
  };
  const std::string join = "SELECT a, b FROM predictive_join(3, 'ships') WHERE ";
  EXPECT_EQ(db.error_of(join + "within <= 50"), "predictive_join: " + refusal("within", "<="));
  EXPECT_EQ(db.error_of(join + "within < 50 AND dt > 0"), "predictive_join: " + refusal("within", "<"));
  EXPECT_EQ(db.error_of(join + "now BETWEEN 0 AND 5"), "predictive_join: " + refusal("now", ">="));
  EXPECT_EQ(db.error_of(join + "(a = 7 OR b = 7) AND now > 5"), "predictive_join: " + refusal("now", ">"));
  EXPECT_EQ(
      db.error_of("SELECT id FROM predictive_window WHERE h = 3 AND tbl = 'ships' AND x0 >= 0 AND x1 <= 9"),
      "predictive_window: " + refusal("x0", ">="));
  EXPECT_EQ(db.error_of(join + "within <> 50"), "predictive_join: " + refusal("within", "<>"));
  EXPECT_EQ(db.error_of(join + "within IS NOT 50"), "predictive_join: " + refusal("within", "IS NOT"));
  EXPECT_EQ(db.error_of(join + "method LIKE '%ee'"), "predictive_join: " + refusal("method", "LIKE"));
  EXPECT_EQ(db.error_of(join + "method GLOB '*ee'"), "predictive_join: " + refusal("method", "GLOB"));
  EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_join(3, 'ships') WHERE now IS NOT NULL AND dt < 9"),
            db.rows("SELECT count(*) FROM predictive_join(3, 'ships') WHERE dt < 9"));
}

TEST_F(JoinPlanner, IsGivesAnInputAValueAsEqualityDoes) {
  const auto pairs = [this](const std::string& where) {
    return db.rows("SELECT a, b FROM predictive_join(3, 'ships') WHERE " + where + " ORDER BY a, b");
  };
  EXPECT_EQ(pairs("within IS 2"), pairs("within = 2"));
  EXPECT_NE(pairs("within IS 2"), pairs("within = 0"));
  EXPECT_EQ(pairs("(within, now) IS (2, 1)"), pairs("within = 2 AND now = 1"));
  EXPECT_EQ(db.rows("SELECT name FROM foresee_tables WHERE schema_name IS 'main' ORDER BY name"),
            db.rows("SELECT name FROM foresee_tables('main') ORDER BY name"));
}

/// SQLite compares what is inside an OR after a call without it, unless it makes a call for each side.
TEST_F(JoinPlanner, AnInputInsideAnOrLosesNoRow) {
  const std::string join = "SELECT a, b, within FROM predictive_join(3, 'ships'";
  EXPECT_EQ(db.rows(join + ") WHERE (a = 42 AND within = 2) OR (b = 7 AND within = 0) ORDER BY a, b, within"),
            db.rows(join + ", 2) WHERE a = 42 UNION " + join + ", 0) WHERE b = 7 ORDER BY a, b, within"));
  EXPECT_EQ(db.rows(join + ") WHERE (a = 42 AND within = 0) OR b = 42 OR a = 42 ORDER BY a, b"),
            db.rows(join + ", 0) WHERE a = 42 OR b = 42 ORDER BY a, b"));
  const std::string refused =
      "predictive_window: x0 is read, but has no value: write x0 = ... with AND; inside OR or an expression, "
      "or in WHERE on a LEFT JOIN, it does not reach the function";
  const std::string window = "SELECT id FROM predictive_window(3, 'ships') WHERE ";
  EXPECT_EQ(db.error_of(window + "(x0 = 6 AND x1 = 20) OR (x0 = 50 AND x1 = 90)"), refused);
  EXPECT_EQ(db.error_of(window + "x0 = 6 OR id = 1"), refused);
  EXPECT_EQ(db.error_of(window + "+x0 = 6"), refused);
  EXPECT_EQ(db.rows(window + "x0 = 6 AND (id = 1 OR id = 7) ORDER BY id"),
            db.rows("SELECT id FROM predictive_window(3, 'ships', 6) WHERE id IN (1, 7) ORDER BY id"));
}

TEST_F(JoinPlanner, ProbesOneObjectAlsoWhereInputsAreBound) {
  const std::string sides = "(a = ?3 OR b = ?3) ORDER BY a, b";
  const std::string by_place = "SELECT a, b, t FROM predictive_join(?1, ?2) WHERE " + sides,
                    by_name = "SELECT a, b, t FROM predictive_join WHERE h = ?1 AND tbl = ?2 AND " + sides,
                    computed = "SELECT a, b, t FROM predictive_join(?1, lower(?2), 0 + 0) WHERE " + sides;
  for (const std::string& sql : {by_place, by_name, computed}) {
    EXPECT_NE(plan(sql).find("MULTI-INDEX OR"), std::string::npos) << sql;
    for (const std::string id : {"7", "42", "100000"})
      EXPECT_EQ(bound(sql, {"3", "ships", id.c_str()}),
                db.rows("SELECT a, b, t FROM whole WHERE a = " + id + " OR b = " + id + " ORDER BY a, b"));
  }
  // Never fewer rows: where SQLite compares the NULL again, an error.
  const char* const lost =
      "error: predictive_join: tbl is NULL, which OR and more than sixteen conditions do not allow; leave "
      "tbl";
  const std::string all = db.rows("SELECT a, b, t FROM whole WHERE a = 42 OR b = 42 ORDER BY a, b");
  for (const std::string& sql : {by_place, by_name, computed}) {
    const std::string rows = bound(sql, {"3", nullptr, "42"});
    EXPECT_TRUE(rows == all || rows.starts_with(lost)) << sql << ": " << rows;
  }
  const std::string one = "SELECT a, b, tbl FROM predictive_join(?1, ?2) WHERE a = ?3 ORDER BY b";
  EXPECT_EQ(bound(one, {"3", nullptr, "42"}),
            db.rows("SELECT a, b, 'ships' FROM whole WHERE a = 42 ORDER BY b"))
      << "a NULL counts as left out";
}

TEST_F(JoinPlanner, LosesNoRowToABoundNull) {
  // SQLite compares the inputs again where it plans the sides of an OR, and then the call must fail.
  const std::string refused = "error: predictive_join: within is NULL, which OR and";
  const std::string joins = "SELECT a, b FROM ships s JOIN predictive_join j ON j.a = s.id WHERE ",
                    alone = "SELECT a, b FROM predictive_join j WHERE ",
                    inputs = "j.h = ?1 AND j.within = ?2 AND ", pairs = "(SELECT a, b FROM whole) j WHERE ";
  for (const std::string& ids :
       {std::string("(j.b = 43 OR j.a = 42)"), std::string("(j.a = 42 OR j.a = 43)"),
        std::string("j.a = 42 AND (j.b = 43 OR j.a = 42)"), std::string("(j.a = 42 AND j.b > 0 OR j.b = 43)"),
        std::string("(j.b IN (42, 43) OR j.a = 42)"),
        std::string("(j.a = 1 OR (j.a = 42 AND (j.b = 43 OR j.b > 0)))"), std::string("j.a = 42"),
        std::string("j.a IN (42, 43)")}) {
    const std::string all = db.rows("SELECT a, b FROM " + pairs + ids + " ORDER BY a, b");
    for (const std::string& call : {joins, alone})
      for (const std::string& sql : {call + inputs + ids, call + ids + " AND j.within = ?2 AND j.h = ?1",
                                     call + "j.h = ?1 AND " + ids + " AND j.within = ?2"}) {
        EXPECT_EQ(bound(sql + " ORDER BY a, b", {"3", "0"}), all) << sql;
        const std::string rows = bound(sql + " ORDER BY a, b", {"3", nullptr});
        EXPECT_TRUE(rows == all || rows.starts_with(refused)) << sql << ": " << rows;
      }
  }
}

TEST_F(JoinPlanner, ProbesBesideOtherCallsAndStatementsWithBoundInputs) {
  const auto probes = [&](const std::string& sql) {
    const std::string text = plan(sql), of_k = text.substr(text.find(" k VIRTUAL TABLE"));
    EXPECT_NE(of_k.find("A="), std::string::npos) << text;
  };
  const std::string inputs = "k.h = ?1 AND k.within = ?2";
  probes(
      "SELECT * FROM predictive_join j CROSS JOIN predictive_join k WHERE j.h = ?1 AND j.within = ?2 AND "
      "k.a = j.b AND " +
      inputs);
  sqlite3_stmt* prepared = nullptr;  // and not run
  const char* const all = "SELECT * FROM predictive_join WHERE h = ?1 AND within = ?2";
  ASSERT_EQ(sqlite3_prepare_v2(db.handle(), all, -1, &prepared, nullptr), SQLITE_OK);
  probes("SELECT * FROM predictive_join k WHERE a = ?3 AND " + inputs);
  probes("SELECT * FROM ships s JOIN predictive_join k ON k.a = s.id WHERE s.id < 5 AND " + inputs);
  sqlite3_finalize(prepared);
}

TEST_F(JoinPlanner, KeepsEveryRowWhereAnInputIsNull) {
  const std::string expected = db.rows("SELECT a, b FROM whole WHERE a = 42 OR b = 42 ORDER BY a, b");
  EXPECT_NE(expected, "");
  const auto rows = [this](const std::string& from) {
    return db.rows("SELECT a, b FROM " + from + " (a = 42 OR b = 42) ORDER BY a, b");
  };
  EXPECT_EQ(rows("predictive_join(3, 'ships', NULL) WHERE"), expected);
  EXPECT_EQ(rows("predictive_join WHERE h = 3 AND tbl = NULL AND"), expected);
  EXPECT_EQ(rows("(SELECT 3 AS h, NULL AS who) q, predictive_join(q.h, q.who) WHERE"), expected);
  db.exec("CREATE TEMP TABLE questions(h, who); INSERT INTO questions VALUES (3, NULL)");
  EXPECT_EQ(rows("questions q, predictive_join(q.h, q.who) WHERE"), expected);
  EXPECT_EQ(rows("questions q, predictive_join j WHERE j.h = q.h AND j.tbl = q.who AND"), expected);
  EXPECT_EQ(db.rows("SELECT a, b FROM predictive_join(3, 'ships', NULL) WHERE a = 42 UNION ALL SELECT a, b "
                    "FROM predictive_join(3, 'ships', NULL) WHERE b = 42 ORDER BY a, b"),
            expected);
}

// SQLite leaves out no comparison beyond its sixteenth constraint, and a comparison with NULL is never true.
TEST_F(JoinPlanner, LosesNoRowBehindManyConditions) {
  std::string nulls, conditions = "dt > -1";
  for (int i = 0; i < 12; ++i) nulls += ", NULL";
  for (int i = 2; i < 9; ++i) conditions += " AND dt > -" + std::to_string(i);
  EXPECT_TRUE(db.rows("SELECT count(*) FROM predictive_window(9, 'ships'" + nulls + ") WHERE " + conditions)
                  .starts_with("error: predictive_window: "));
  EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_window(9, 'ships') WHERE " + conditions), "400");
}

TEST_F(JoinPlanner, GivesTheSameRowsWithHelperThreads) {
  build_table(
      db, "fleet",
      random_scene({.layout = {.axes = 2, .law = Law::uniform, .shape = Shape::ball}, .count = 15000}));
  const auto rows = [this](const std::string& rest) {
    return db.rows("SELECT a, b, t, d_cpa FROM predictive_join(3, 'fleet') " + rest);
  };
  const std::string alone = rows(""), ordered = rows("WHERE dt > 0 ORDER BY t, a, b"),
                    first = rows("WHERE dt > 0 ORDER BY t, a, b LIMIT 3");
  db.exec("PRAGMA threads = 2");
  EXPECT_EQ(rows(""), alone);
  EXPECT_EQ(rows("WHERE dt > 0 ORDER BY t, a, b"), ordered);
  EXPECT_EQ(rows("WHERE dt > 0 ORDER BY t, a, b LIMIT 3"), first);
  db.exec("DROP TABLE fleet");
}

TEST_F(JoinPlanner, UsesBoundsOfTimeAsTheyAreWritten) {
  const std::string t = db.rows("SELECT t FROM whole WHERE dt > 0 ORDER BY t LIMIT 1 OFFSET 50");
  for (const std::string op : {"<", "<=", ">", ">=", "=", "IS"})
    for (const std::string column : {"t", "dt"}) {
      both("WHERE " + column + " " + op + " " + t + " ORDER BY a, b");
      both("WHERE " + column + " " + op + " '" + t + "' ORDER BY a, b");
      both("WHERE " + column + " " + op + " 1 ORDER BY a, b");
      both("WHERE " + column + " " + op + " 'x' ORDER BY a, b");
      both("WHERE " + column + " " + op + " x'00' ORDER BY a, b");
      both("WHERE " + column + " " + op + " 9007199254740993 ORDER BY a, b");
      both("WHERE " + column + " " + op + " NULL ORDER BY a, b");
    }
}

TEST_F(JoinPlanner, KeepsTheRowsOfTwoHorizonsApart) {
  EXPECT_EQ(db.rows("SELECT h, count(*) FROM predictive_join WHERE h IN (1, 3) GROUP BY h"),
            db.rows("SELECT 1, count(*) FROM predictive_join(1) UNION ALL SELECT 3, count(*) FROM whole"));
  EXPECT_EQ(db.rows("SELECT count(*) FROM (SELECT DISTINCT a, b FROM predictive_join WHERE h IN (1, 3))"),
            db.rows("SELECT count(*) FROM whole"));
  EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_join WHERE (h = 1 AND now = 0) OR (h = 3 AND now = 0)"),
            db.rows("SELECT (SELECT count(*) FROM predictive_join(1)) + (SELECT count(*) FROM whole)"));
}

TEST_F(JoinPlanner, RunsTheJoinOnceWhenShipsAreLookedUp) {
  const std::string sql =
      "SELECT sa.x, sb.x FROM ships sa JOIN ships sb JOIN predictive_join(3, 'ships') j ON sa.id = j.a AND "
      "sb.id = j.b";
  const std::string steps = plan(sql);
  EXPECT_LT(steps.find("SCAN j"), steps.find("SCAN sa")) << steps;
  EXPECT_LT(steps.find("SCAN j"), steps.find("SCAN sb")) << steps;
  EXPECT_EQ(db.rows("SELECT count(*) FROM (" + sql + ")"), db.rows("SELECT count(*) FROM whole"));
}

TEST_F(JoinPlanner, IsCalledOncePerRowOfTheTableBefore) {
  db.exec(
      "CREATE TABLE questions(h, who); INSERT INTO questions VALUES (1, 'ships'), (3, 'ships'), (0, NULL)");
  EXPECT_EQ(
      db.rows("SELECT h, (SELECT count(*) FROM predictive_join(q.h, q.who)) FROM questions q"),
      db.rows("SELECT 1, count(*) FROM predictive_join(1) UNION ALL SELECT 3, count(*) FROM whole UNION ALL "
              "SELECT 0, count(*) FROM predictive_join(0)"));
  EXPECT_EQ(
      db.rows("SELECT q.h, count(*) FROM questions q, predictive_join(q.h, q.who) GROUP BY q.h ORDER BY q.h"),
      db.rows("SELECT h, count(*) FROM predictive_join WHERE h IN (0, 1, 3) GROUP BY h ORDER BY h"));
  EXPECT_EQ(db.rows("SELECT count(*) FROM questions q LEFT JOIN predictive_join(q.h, q.who) j ON j.a < 0"),
            "3");
}

TEST_F(JoinPlanner, ServesViewsOfAnUntrustedSchema) {
  db.exec("CREATE VIEW soon AS SELECT a, b, t FROM predictive_join(3, 'ships'); PRAGMA trusted_schema = OFF");
  EXPECT_EQ(db.rows("SELECT count(*) FROM soon"), db.rows("SELECT count(*) FROM whole"));
}

TEST_F(JoinPlanner, ServesTriggersAndPreparedParameters) {
  db.exec(
      "CREATE TABLE clock(now); CREATE TABLE alarms(n); CREATE TRIGGER tick AFTER INSERT ON clock BEGIN "
      "INSERT INTO alarms SELECT count(*) FROM predictive_join(3, 'ships') WHERE now = new.now; END;"
      "INSERT INTO clock VALUES (0)");
  EXPECT_EQ(db.rows("SELECT n FROM alarms"), db.rows("SELECT count(*) FROM whole"));
}

}  // namespace
}  // namespace foresee::testing
