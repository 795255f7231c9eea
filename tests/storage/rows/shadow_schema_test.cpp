// Schema of the shadow tables: names, _meta, and errors where they are not as expected.
#include "storage/rows/shadow_schema.h"

#include <cstdio>
#include <filesystem>

#include "storage/database.h"

namespace foresee {
namespace {

TEST(ShadowSchema, DescribesTheColumnsOfEveryLayout) {
  EXPECT_EQ(describe_columns({.layout = {}}), "id, x");
  EXPECT_EQ(describe_columns(named_ships()), "id, t, x, y, vx, vy, r, +name, +cargo");
  const Layout drones{.axes = 3, .law = Law::accelerated, .shape = Shape::cylinder, .has_until = true};
  EXPECT_EQ(describe_columns({.layout = drones}), "id, x, y, z, vx, vy, vz, ax, ay, az, r, hz, until");
  const Layout forced{.axes = 1, .law = Law::forced, .shape = Shape::box};
  EXPECT_EQ(describe_columns({.layout = forced}), "id, x, vx, fx, m, hx");
  Layout outlined{.axes = 3, .shape = Shape::outline, .has_until = true, .has_heading = true};
  EXPECT_EQ(describe_columns({.layout = outlined}), "id, x, y, z, hz, shape, heading, until");
  outlined.axes = 2;
  outlined.has_radius = true;
  outlined.has_heading = false;
  EXPECT_EQ(describe_columns({.layout = outlined}), "id, x, y, r, shape, until");
  const Layout meshes{.axes = 3, .shape = Shape::mesh, .has_radius = true, .has_heading = true};
  EXPECT_EQ(describe_columns({.layout = meshes}), "id, x, y, z, r, shape, heading");
  const Layout kinds{.axes = 1, .has_until = true, .has_category = true, .has_mask = true};
  EXPECT_EQ(describe_columns({.layout = kinds}), "id, x, until, category, mask");
  const Layout masked{.axes = 1, .has_mask = true};
  EXPECT_EQ(describe_columns({.layout = masked}), "id, x, mask");
}

TEST(ShadowSchema, KnowsItsSuffixes) {
  for (const char* suffix : {"node", "map", "aux", "meta", "shape", "NODE"})
    EXPECT_TRUE(is_shadow_suffix(suffix));
  for (const char* suffix : {"nod", "nodes", "", "rowid"}) EXPECT_FALSE(is_shadow_suffix(suffix));
}

TEST(ShadowSchema, MetaSaysWhatTheTableIs) {
  Database db;
  make_store(db, named_ships());
  EXPECT_EQ(db.text("SELECT group_concat(key || '=' || value, '; ') FROM ships_meta WHERE key <> 'stamp'"),
            "columns=id, t, x, y, vx, vy, r, +name, +cargo; features=blocks; format=2; horizon=60.0; "
            "node_size=4032; objects=0; root=0");
  EXPECT_EQ(db.text("SELECT typeof(value) FROM ships_meta WHERE key = 'stamp'"), "integer");
}

TEST(ShadowSchema, AnyNameInAnySchemaWorks) {
  for (const std::string schema : {"main", "temp", "o'ther \"db\""})
    for (const std::string table :
         {"ships", "two words", "it's", "say \"hi\"", "häfen 港", "a{meta}b", "%s", "x]y"}) {
      Database db;
      db.run(format_sql("ATTACH ':memory:' AS \"%w\"", "o'ther \"db\""));
      auto store = make_store(db, named_ships(), table, schema);
      SqlValues values(db, {"name", "cargo"});
      begin(db, *store);
      store->insert(1, ship(1), values);
      commit(db, *store);
      begin(db, *store);
      store->insert(2, ship(2), values);
      store->rename("re" + table);
      commit(db, *store);
      EXPECT_EQ(Store::open(db, schema, "re" + table, named_ships()), store);
      EXPECT_EQ(contents(*store).size(), 2u);
      EXPECT_EQ(faults(*store), std::vector<std::string>{});
      store->drop();
      EXPECT_EQ(db.number(format_sql("SELECT count(*) FROM \"%w\".sqlite_schema", schema.c_str())), 0);
    }
}

TEST(ShadowSchema, SmallPagesStillHoldFourObjects) {
  Database db;
  db.run("PRAGMA page_size = 512");
  const Layout layout{.axes = 3, .law = Law::forced, .shape = Shape::box, .has_t = true, .has_until = true};
  auto store = make_store(db, {.layout = layout});
  begin(db, *store);
  const std::vector<double> record{0, 1, 2, 3, 0, 0, 0, 1, 1, 1, 2, 1, 1, 1, 9};
  for (int id = 1; id <= 50; ++id) store->insert(id, record, {});
  commit(db, *store);
  EXPECT_EQ(contents(*store).size(), 50u);
  EXPECT_EQ(count_of(*Store::open(db, "main", "ships", {.layout = layout})), 50);
}

TEST(ShadowSchema, AnotherDeclarationIsRefused) {
  Database db;
  make_store(db);
  expect_store_error(SQLITE_CORRUPT_VTAB, "declared with (id, t, x, y, vx, vy, r, +name, +cargo)",
                     [&] { Store::open(db, "main", "ships", named_ships()); });
}

TEST(ShadowSchema, OtherFormatsAreRefused) {
  Database db;
  make_store(db);
  const auto open = [&] { Store::open(db, "main", "ships", ships()); };
  open();
  db.run("UPDATE ships_meta SET value = 1 WHERE key = 'format'");
  expect_store_error(
      SQLITE_ERROR, "ships: stored in format '1', this foresee reads 2; with the version that wrote it, copy",
      open);
  db.run("UPDATE ships_meta SET value = 2 WHERE key = 'format'");
  for (const char* size : {"'4096'", "-1", "NULL", "1e300"}) {
    db.run(std::string("UPDATE ships_meta SET value = ") + size + " WHERE key = 'node_size'");
    expect_store_error(SQLITE_CORRUPT_VTAB, "belongs to no page size", open);
  }
  db.run("DELETE FROM ships_meta");
  expect_store_error(SQLITE_ERROR, "stored in format ''", open);
  db.run("DROP TABLE ships_meta");
  expect_store_error(SQLITE_ERROR, "no such table: main.ships_meta", open);
}

TEST(ShadowSchema, DropGoesOnWithoutAMissingTable) {
  Database db;
  auto store = make_store(db, named_ships());
  db.run("CREATE TABLE other(x); DROP TABLE ships_map; DROP TABLE ships_aux");
  store->drop();
  EXPECT_EQ(db.text("SELECT group_concat(name) FROM sqlite_schema"), "other");
}

TEST(ShadowSchema, DropKeepsATableWithASimilarName) {
  Database db;
  auto store = make_store(db);
  db.run("CREATE TABLE ships_aux(mine)");
  store->drop();
  EXPECT_EQ(db.text("SELECT group_concat(name) FROM sqlite_schema"), "ships_aux");
}

TEST(ShadowSchema, NoStatementIsOpenAfterAnyCall) {
  Database db;
  auto store = make_store(db, named_ships());
  SqlValues values(db, {"name", "cargo"});
  begin(db, *store);
  for (int id = 1; id <= 200; ++id) store->insert(id, ship(id), values);
  commit(db, *store);
  store->read(5);
  store->read_version();
  Node leaf;
  store->next_leaf(0, leaf);
  contents(*store);
  for (sqlite3_stmt* s = sqlite3_next_stmt(db, nullptr); s; s = sqlite3_next_stmt(db, s))
    EXPECT_FALSE(sqlite3_stmt_busy(s)) << sqlite3_sql(s);
  db.run("VACUUM");
  EXPECT_EQ(contents(*store).size(), 200u);
  EXPECT_EQ(faults(*store), std::vector<std::string>{});
}

}  // namespace
}  // namespace foresee
