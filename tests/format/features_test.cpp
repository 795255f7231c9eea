// Features of a stored table beyond version 0.1: known by name, or refused by name.
#include "format/features.h"

#include <array>

#include "sqlite/foresee.h"
#include "storage/database.h"
#include "storage/rows/shadow_schema.h"

namespace foresee {
namespace {

constexpr std::array<Feature, 2> two{
    {{"long", [](const Declaration& declaration) { return declaration.horizon > 100; }},
     {"named", [](const Declaration& declaration) { return !declaration.auxiliaries.empty(); }}}};

TEST(Features, OfATableAreSeparatedByCommas) {
  Declaration declaration = ships();
  EXPECT_EQ(features_of(declaration, two), "");
  declaration.horizon = 200;
  EXPECT_EQ(features_of(declaration, two), "long");
  declaration.auxiliaries = {{"name", ""}};
  EXPECT_EQ(features_of(declaration, two), "long,named");
}

TEST(Features, TheFirstUnknownOneIsFound) {
  for (const char* names : {"", "long", "named", "long,named", "named,long"})
    EXPECT_EQ(unknown_feature(names, two), "") << names;
  EXPECT_EQ(unknown_feature("growth", two), "growth");
  EXPECT_EQ(unknown_feature("long,growth,tiles", two), "growth");
  EXPECT_EQ(unknown_feature("longer", two), "longer");
  EXPECT_EQ(unknown_feature("long, named", two), " named");
  EXPECT_EQ(unknown_feature("Long", two), "Long");
  EXPECT_EQ(unknown_feature(",long", two), ",");
}

// Without this feature an older library would take the bounds of objects at rest for constant.
TEST(Features, GrowthIsOne) {
  Declaration declaration{.layout = {.axes = 2, .shape = Shape::box}};
  EXPECT_EQ(features_of(declaration), "blocks");
  for (bool Layout::*grows : {&Layout::has_growth, &Layout::has_growth_z}) {
    declaration.layout = {.axes = 3, .shape = Shape::box};
    declaration.layout.*grows = true;
    EXPECT_EQ(features_of(declaration), "blocks,growth");
  }
}

// Without this feature an older library would join objects whose kinds may not meet.
TEST(Features, KindsAreOne) {
  for (bool Layout::*kinds : {&Layout::has_category, &Layout::has_mask}) {
    Declaration declaration{.layout = {.axes = 2, .shape = Shape::box}};
    declaration.layout.*kinds = true;
    EXPECT_EQ(features_of(declaration), "blocks,kinds");
  }
  EXPECT_EQ(unknown_feature("blocks,kinds", two), "blocks");
}

// Without this feature an older library would read bounds of three axes as bounds of two.
TEST(Features, MeshesAreRefusedByALibraryThatKnowsOutlinesOnly) {
  Declaration declaration{.layout = {.axes = 3, .shape = Shape::mesh}};
  EXPECT_EQ(features_of(declaration), "blocks,shapes,meshes");
  EXPECT_EQ(unknown_feature(features_of(declaration)), "");
  EXPECT_EQ(unknown_feature(features_of(declaration), known_features().first(2)), "meshes");
  declaration.layout.shape = Shape::outline;
  EXPECT_EQ(features_of(declaration), "blocks,shapes");
}

// Without this feature an older library would show metres in columns of degrees.
TEST(Features, DegreesAndNamedFramesAreRefusedByALibraryThatKnowsThePlaneOnly) {
  Declaration declaration{.layout = {.axes = 2}, .frame = {.kind = FrameKind::degrees}};
  EXPECT_EQ(features_of(declaration), "blocks,degrees");
  EXPECT_EQ(unknown_feature(features_of(declaration)), "");
  EXPECT_EQ(unknown_feature(features_of(declaration), known_features().first(4)), "degrees");
  declaration.frame = {.text = "harbour"};
  EXPECT_EQ(features_of(declaration), "blocks,frame");
  EXPECT_EQ(unknown_feature(features_of(declaration), known_features().first(4)), "frame");
}

TEST(Features, OneIsFoundAmongTheNames) {
  for (const char* names : {"blocks", "blocks,growth", "growth,blocks", "a,blocks,b"})
    EXPECT_TRUE(has_feature(names, "blocks")) << names;
  for (const char* names : {"", ",", "block", "blocksgrowth", "growth", "Blocks"})
    EXPECT_FALSE(has_feature(names, "blocks")) << names;
}

TEST(Features, EveryNewTableHasBlocks) {
  Database db;
  make_store(db, named_ships());
  EXPECT_EQ(db.text("SELECT value FROM ships_meta WHERE key = 'features'"), "blocks");
}

TEST(Features, UnknownOnesAreRefusedByName) {
  Database db;
  make_store(db);
  const auto open = [&] {
    const ShadowTables tables = shadow_tables(db, {"main", "ships"}, ships());
    MetaRows meta(tables);
    read_node_format(tables, meta, ships());
  };
  for (const char* known : {"''", "'blocks'"}) {
    db.run(std::string("UPDATE ships_meta SET value = ") + known + " WHERE key = 'features'");
    open();
  }
  db.run("UPDATE ships_meta SET value = 'tides,tiles' WHERE key = 'features'");
  expect_store_error(SQLITE_ERROR,
                     "ships: written with 'tides', which this foresee does not know: use a newer one", open);
  for (const char* value : {"7", "x'00'", "'a' || char(0) || 'b'", "zeroblob(1000000)"}) {
    db.run(std::string("UPDATE ships_meta SET value = ") + value + " WHERE key = 'features'");
    expect_store_error(SQLITE_ERROR, "which this foresee does not know", open);
  }
}

class UnknownFeature : public ::testing::Test {
 protected:
  UnknownFeature() {
    sqlite3_foresee_init(db, nullptr, nullptr);
    db.run("CREATE VIRTUAL TABLE ships USING moving_objects(id, x, r); INSERT INTO ships VALUES(1, 2, 3)");
    db.run("UPDATE ships_meta SET value = 'blocks,tides' WHERE key = 'features'");
  }
  std::string error_of(const std::string& sql) {
    char* message = nullptr;
    sqlite3_exec(db, sql.c_str(), nullptr, nullptr, &message);
    const std::string text = message ? message : "";
    sqlite3_free(message);
    return text;
  }
  void reload_schema() { db.run("PRAGMA writable_schema = RESET"); }

  Database db;
  const std::string refusal =
      "ships: written with 'tides', which this foresee does not know: use a newer one";
};

TEST_F(UnknownFeature, IsRefusedForReadingAndWriting) {
  reload_schema();
  for (const char* sql :
       {"SELECT x FROM ships", "SELECT * FROM ships WHERE id = 1", "INSERT INTO ships VALUES(2, 0, 0)",
        "UPDATE ships SET x = 0", "DELETE FROM ships", "INSERT INTO ships(ships) VALUES('rebuild')",
        "SELECT * FROM predictive_join(1)", "SELECT * FROM predictive_window(1, 'ships')"})
    EXPECT_NE(error_of(sql).find(refusal), std::string::npos) << sql << ": " << error_of(sql);
  db.run("DROP TABLE ships");
  EXPECT_EQ(db.number("SELECT count(*) FROM sqlite_schema"), 0);
}

TEST_F(UnknownFeature, IsTheReasonAlsoWhereTheColumnsCannotBeRead) {
  db.run("PRAGMA writable_schema = ON");
  db.run("UPDATE sqlite_schema SET sql = replace(sql, 'id, x, r', 'id, x, r, tide') WHERE name = 'ships'");
  reload_schema();
  EXPECT_EQ(error_of("SELECT x FROM ships"), refusal);
  db.run("DELETE FROM ships_meta WHERE key = 'features'");
  EXPECT_NE(error_of("SELECT x FROM ships").find("tide"), std::string::npos);
  EXPECT_EQ(error_of("SELECT x FROM ships").find("newer"), std::string::npos);
}

}  // namespace
}  // namespace foresee
