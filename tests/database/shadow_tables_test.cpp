// Shadow tables of another kind of virtual table than moving_objects.
#include "database/shadow_tables.h"

#include <array>

#include "database/ascending_rows.h"
#include "database/meta_rows.h"
#include "sqlite/foresee.h"
#include "storage/database.h"

namespace foresee {
namespace {

ShadowTables alerts(Database& db, const std::string& table = "alerts", const std::string& schema = "main") {
  return {db,
          {schema, table},
          {{"pair", "(a, b, t, PRIMARY KEY(a, b)) WITHOUT ROWID"},
           {"log", "(seq INTEGER PRIMARY KEY, op)"},
           MetaRows::table()}};
}

std::string names(Database& db, const std::string& schema = "main") {
  return db.text(
      format_sql("SELECT group_concat(name, ', ') FROM (SELECT name FROM \"%w\".sqlite_schema "
                 "WHERE name NOT LIKE 'sqlite_%%' ORDER BY name)",
                 schema.c_str()));
}

TEST(ShadowTables, AreMadeRenamedAndDroppedTogether) {
  Database db;
  db.run("CREATE TABLE other(x)");
  alerts(db).create();
  EXPECT_EQ(names(db), "alerts_log, alerts_meta, alerts_pair, other");
  EXPECT_EQ(db.text("SELECT sql FROM sqlite_schema WHERE name = 'alerts_log'"),
            "CREATE TABLE \"alerts_log\"(seq INTEGER PRIMARY KEY, op)");
  alerts(db).rename("alarms");
  EXPECT_EQ(names(db), "alarms_log, alarms_meta, alarms_pair, other");
  db.run("DROP TABLE alarms_log");
  alerts(db, "alarms").drop();
  EXPECT_EQ(names(db), "other");
}

TEST(ShadowTables, GoByAnyNameInAnySchema) {
  const std::string schema = "o'ther \"db\"";
  for (const std::string table : {"two words", "it's", "say \"hi\"", "häfen 港", "a{log}b", "%s"}) {
    Database db;
    db.run(format_sql("ATTACH ':memory:' AS \"%w\"", schema.c_str()));
    const ShadowTables tables = alerts(db, table, schema);
    tables.create();
    tables.require_tables();
    Statement insert = tables.statement("INSERT INTO {log}(op) SELECT count(*) FROM {pair}");
    Statement::Run(insert).step();
    Statement select = tables.statement("SELECT op FROM {log}");
    {
      Statement::Run run(select);
      ASSERT_TRUE(run.step());
      EXPECT_EQ(run.integer(0), 0);
    }
    tables.rename("re" + table);
    EXPECT_EQ(names(db, schema), "re" + table + "_log, re" + table + "_meta, re" + table + "_pair");
  }
}

TEST(ShadowTables, AViewInPlaceOfOneIsRefused) {
  Database db;
  const ShadowTables tables = alerts(db);
  tables.create();
  tables.require_tables();
  db.run("DROP TABLE alerts_pair; CREATE VIEW Alerts_Pair AS SELECT 1 AS a");
  expect_store_error(SQLITE_CORRUPT_VTAB, "alerts: Alerts_Pair is a view, where foresee keeps a table",
                     [&] { tables.require_tables(); });
  db.run("DROP VIEW alerts_pair");
  tables.require_tables();  // a missing table is reported where it is read
}

TEST(ShadowTables, MetaKeepsValuesByKey) {
  Database db;
  const ShadowTables tables = alerts(db);
  tables.create();
  MetaRows meta(tables);
  EXPECT_EQ(meta.read("clock"), "");
  meta.write("clock", 2.5);
  meta.write("watched", std::string("it's"));
  meta.write("seq", std::int64_t{7});
  meta.write("seq", std::int64_t{8});
  EXPECT_EQ(meta.read("clock") + ", " + meta.read("watched") + ", " + meta.read("seq"), "2.5, it's, 8");
  EXPECT_EQ(db.number("SELECT count(*) FROM alerts_meta"), 3);
  db.run("UPDATE alerts_meta SET value = printf('%.1000c', 'x') WHERE key = 'clock'");
  EXPECT_EQ(meta.read("clock", 30).size(), 30u);
  EXPECT_EQ(meta.read_integer("seq"), 8);
  EXPECT_EQ(meta.read_integer("clock"), std::nullopt);
  EXPECT_EQ(meta.read_integer("other"), std::nullopt);
  meta.write("watched", std::string("häfen"));
  EXPECT_EQ(meta.read("watched", 3), "hä");
  EXPECT_EQ(meta.read("watched", 2), "h");
}

TEST(ShadowTables, AVirtualTableInPlaceOfOneIsRefusedEvenWhereItIsInUse) {
  Database db;
  sqlite3_foresee_init(db, nullptr, nullptr);
  const ShadowTables tables = alerts(db);
  tables.create();
  db.run("DROP TABLE alerts_log; CREATE VIRTUAL TABLE alerts_log USING moving_objects(id, x)");
  db.run("SELECT * FROM alerts_log");
  expect_store_error(SQLITE_CORRUPT_VTAB,
                     "alerts: alerts_log is a virtual table, where foresee keeps a table",
                     [&] { tables.require_tables(); });
}

TEST(ShadowTables, RowsThatDoNotAscendAreRefused) {
  Database db;
  const std::string table = "alerts";
  const auto read = [&](const std::string& sql) {
    Statement statement(db, sql);
    std::string text;
    read_ascending(statement, {table, "log"}, [&](std::int64_t number, Statement::Run& run) {
      text += std::to_string(number) + run.text(1) + ' ';
    });
    return text;
  };
  EXPECT_EQ(read("VALUES(-3, 'a'), (0, 'b'), (9, 'c')"), "-3a 0b 9c ");
  EXPECT_EQ(read("SELECT 1, 2 WHERE 0"), "");
  expect_store_error(SQLITE_CORRUPT_VTAB, "alerts: alerts_log is damaged: row 4 comes after row 4",
                     [&] { read("VALUES(4, 'a'), (4, 'b')"); });
  expect_store_error(SQLITE_CORRUPT_VTAB, "the number of a row is not an integer",
                     [&] { read("VALUES('x', 1)"); });
}

TEST(ShadowTables, ASuffixIsKnownInUpperAndLowerCase) {
  constexpr std::array<const char*, 2> suffixes{"pair", "log"};
  for (const char* suffix : {"pair", "log", "LOG"}) EXPECT_TRUE(is_one_of(suffix, suffixes)) << suffix;
  for (const char* suffix : {"", "lo", "logs", "meta"}) EXPECT_FALSE(is_one_of(suffix, suffixes)) << suffix;
}

}  // namespace
}  // namespace foresee
