// Table names in calls of functions: they resolve as SQLite resolves names, and an error lists the tables
// that exist.
#include "sqlite/harbour_scene.h"

namespace foresee::testing {
namespace {

struct JoinTables : ::testing::Test {
  std::string pairs(const std::string& call) {
    return db.rows("SELECT a, b FROM " + call + " ORDER BY a, b");
  }
  Database db;
};

TEST_F(JoinTables, MayBeLeftOutWhereThereIsOne) {
  EXPECT_EQ(pairs("predictive_join(20)"),
            "error: predictive_join: there is no table to query (no moving_objects table here; make "
            "one with "
            "CREATE VIRTUAL TABLE ships USING moving_objects(id, x, y, vx, vy))");
  build_ships(db);
  db.exec("CREATE TABLE notes(x); CREATE VIRTUAL TABLE boxes USING rtree(id, x0, x1)");
  EXPECT_EQ(pairs("predictive_join(20)"), "1|2");
  build_crates(db);
  EXPECT_EQ(
      pairs("predictive_join(20)"),
      "error: predictive_join: tbl is missing; write the name of one table (moving_objects tables here: "
      "'ships', 'crates')");
}

TEST_F(JoinTables, AreFoundInTempAndAttachedSchemas) {
  build_ships(db, "temp.ferries");
  EXPECT_EQ(pairs("predictive_join(20)"), "1|2");
  EXPECT_EQ(pairs("predictive_join(20, 'ferries')"), "1|2");
  db.exec("DROP TABLE temp.ferries; ATTACH ':memory:' AS \"old \"\"fleet\"");
  build_ships(db, "\"old \"\"fleet\".ferries");
  EXPECT_EQ(pairs("predictive_join(20)"), "1|2");
  EXPECT_EQ(pairs("predictive_join(20, 'ferries')"), "1|2");
  EXPECT_EQ(pairs("predictive_join(20, 'ferries') WHERE schema = 'OLD \"fleet'"), "1|2");
}

TEST_F(JoinTables, ResolveAsSqliteDoesUnlessASchemaIsGiven) {
  build_ships(db);
  build_ships(db, "temp.ships");
  db.exec("ATTACH ':memory:' AS aux");
  build_ships(db, "aux.ships");
  db.exec("DELETE FROM temp.ships WHERE id = 2; DELETE FROM aux.ships");
  EXPECT_EQ(pairs("predictive_join(20, 'ships')"), "") << "temp comes first";
  EXPECT_EQ(pairs("predictive_join(20, 'ships') WHERE schema = 'main'"), "1|2");
  EXPECT_EQ(pairs("predictive_join(20, 'ships') WHERE schema = 'aux'"), "");
  EXPECT_EQ(pairs("predictive_join(20) WHERE schema = 'main'"), "1|2") << "one table in that schema";
  EXPECT_EQ(pairs("predictive_join(20, 'ships', 0, 'ships') WHERE schema = 'main'"), "1|2\n2|1");
}

TEST_F(JoinTables, MayHaveAnyName) {
  for (const std::string name :
       {"two words", "a\"b", "a'b", "[x]", "select", "Sch\xc3\xb6n", "%s%w", "a.b", "1"}) {
    std::string quoted, literal;
    for (char c : name) quoted += c == '"' ? "\"\"" : std::string(1, c);
    for (char c : name) literal += c == '\'' ? "''" : std::string(1, c);
    build_ships(db, "\"" + quoted + "\"");
    EXPECT_EQ(pairs("predictive_join(20, '" + literal + "')"), "1|2") << name;
    EXPECT_EQ(pairs("predictive_join(20)"), "1|2") << name;
    db.exec("DROP TABLE \"" + quoted + "\"");
  }
}

TEST_F(JoinTables, MayBeNamedInAnyCase) {
  build_ships(db);
  EXPECT_EQ(pairs("predictive_join(20, 'SHIPS')"), "1|2");
}

TEST_F(JoinTables, AreFoundUnderTheirNewNames) {
  build_ships(db);
  EXPECT_EQ(pairs("predictive_join(20, 'ships')"), "1|2");
  db.exec("ALTER TABLE ships RENAME TO \"new ships\"");
  EXPECT_EQ(pairs("predictive_join(20)"), "1|2");
  EXPECT_EQ(pairs("predictive_join(20, 'new ships')"), "1|2");
  EXPECT_EQ(pairs("predictive_join(20, 'ships')"),
            "error: predictive_join: no such table: 'ships' (moving_objects tables here: 'new ships')");
}

TEST_F(JoinTables, OfAnotherKindAreNamedAsSuch) {
  build_ships(db);
  const std::string listed = " (moving_objects tables here: 'ships')";
  const auto error = [&](const std::string& table) {
    return db.error_of("SELECT * FROM predictive_join(20, '" + table + "')");
  };
  EXPECT_EQ(error("nowhere"), "predictive_join: no such table: 'nowhere'" + listed);
  EXPECT_EQ(error(""), "predictive_join: no such table: ''" + listed);
  db.exec("CREATE TABLE plain(x); CREATE TABLE same(same INTEGER); INSERT INTO same VALUES (1)");
  db.exec("CREATE VIEW v AS SELECT * FROM ships; CREATE VIRTUAL TABLE boxes USING rtree(id, x0, x1)");
  for (const std::string table : {"plain", "same", "v", "boxes"})
    EXPECT_EQ(error(table), "predictive_join: '" + table + "' is not a moving_objects table" + listed);
  EXPECT_EQ(
      db.error_of("SELECT * FROM predictive_join(20, 'ships') WHERE schema = 'aux'"),
      "predictive_join: no such table: 'ships' in schema 'aux' (moving_objects tables here: 'ships' with "
      "schema = 'main')");
  EXPECT_EQ(error("predictive_join"), "predictive_join: no such table: 'predictive_join'" + listed);
  EXPECT_EQ(error("ships_node"), "predictive_join: 'ships_node' is not a moving_objects table" + listed);
}

TEST_F(JoinTables, ThatHideAnotherAreDistinguished) {
  build_ships(db);
  db.exec("CREATE TEMP TABLE ships(x)");
  EXPECT_EQ(db.error_of("SELECT * FROM predictive_join(20, 'ships')"),
            "predictive_join: 'ships' is not a moving_objects table (moving_objects tables here: 'ships' "
            "with schema = 'main')");
  EXPECT_EQ(pairs("predictive_join(20, 'ships') WHERE schema = 'main'"), "1|2");
  db.exec("DROP TABLE temp.ships");
  build_ships(db, "temp.ships");
  EXPECT_EQ(
      db.error_of("SELECT * FROM predictive_join(20, 'boats')"),
      "predictive_join: no such table: 'boats' (moving_objects tables here: 'ships', 'ships' with schema "
      "= 'main')");
}

TEST_F(JoinTables, AreFoundDespiteAUserFunctionNamedMatch) {
  db.exec("CREATE TABLE plain(x); INSERT INTO plain VALUES (1)");
  sqlite3_create_function(
      db.handle(), "match", 2, SQLITE_UTF8, nullptr,
      [](sqlite3_context* context, int, sqlite3_value**) { sqlite3_result_int(context, 1); }, nullptr,
      nullptr);
  build_ships(db);
  EXPECT_EQ(db.error_of("SELECT * FROM predictive_join(20, 'plain')"),
            "predictive_join: 'plain' is not a moving_objects table (moving_objects tables here: 'ships')");
}

TEST(JoinOfTwoTables, SurvivesThatLookingUpOneMakesSQLiteReconnectTheOther) {
  TemporaryFile file;
  Database db, another(file.path());
  another.exec(
      "CREATE VIRTUAL TABLE other USING moving_objects(id, x, vx); INSERT INTO other VALUES(1, 10, -1)");
  db.exec("ATTACH '" + file.path() +
          "' AS far; CREATE VIRTUAL TABLE temp.ships USING moving_objects(id, x, vx);"
          "INSERT INTO ships VALUES(1, 0, 1)");
  const char* question = "SELECT a, b, t FROM predictive_join(10, 'ships', 0, 'other')";
  for (const char* name : {"p", "q", "r"}) {
    EXPECT_EQ(db.rows(question), "1|1|5.0");
    another.exec(std::string("CREATE TABLE ") + name + "(x)");  // the schema of `far` is read again
  }
  EXPECT_EQ(db.rows(question), "1|1|5.0");
}

TEST(JoinAboutTwoIds, TakesNullInputsAsLeftOut) {
  Database db;
  db.exec(
      "CREATE VIRTUAL TABLE ships USING moving_objects(id, x, vx);"
      "INSERT INTO ships VALUES(1, 0, 6), (2, 1200, -6), (3, 5000, 0)");
  for (const char* inputs : {"300, 'ships', 5", "300, 'ships', 5, NULL, 0", "300, 'ships', NULL",
                             "300, NULL, 5", "300, 'ships', 0, NULL, NULL, 'tree'"}) {
    const std::string join = "SELECT a, b FROM predictive_join(" + std::string(inputs) + ") WHERE ";
    EXPECT_EQ(db.rows(join + "a = 1 OR b = 1"), "1|2") << inputs;
    EXPECT_EQ(db.rows(join + "a IN (2) OR b = 2"), "1|2") << inputs;
  }
  // SQLite does not report beforehand that a computed or bound value is NULL. It may compare the value again,
  // and then the result is an error.
  const std::string computed =
      db.rows("SELECT a, b FROM predictive_join(300, 'ships', abs(0), (SELECT NULL)) WHERE a = 1 OR b = 1");
  EXPECT_TRUE(computed == "1|2" || computed.starts_with("error: predictive_join: other is NULL")) << computed;
  EXPECT_EQ(
      db.rows(
          "SELECT s.id, j.a, j.b FROM ships s LEFT JOIN predictive_join(300, 'ships', 0, NULL, NULL, 'tree')"
          " j ON j.a = s.id OR j.b = s.id ORDER BY 1"),
      "1|1|2\n2|1|2\n3|NULL|NULL");
}

}  // namespace
}  // namespace foresee::testing
