// Files of released versions are read without changing a byte, can be written at once, and stay sound.
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "format/node_format.h"
#include "sqlite/foresee.h"
#include "storage/database.h"

namespace foresee {
namespace {

const std::string files = FORESEE_SOURCE_DIR "/tests/storage/files/";
std::string content(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// A copy of a released file, opened with foresee.
class ReleasedFile : public ::testing::Test {
 protected:
  ReleasedFile(const std::string& name, std::vector<std::string> names_of_tables)
      : original(files + name),
        tables(std::move(names_of_tables)),
        path(std::filesystem::path(FORESEE_BINARY_DIR) / ("copy_of_" + name)),
        db((copy(), path)) {
    sqlite3_foresee_init(db, nullptr, nullptr);
  }
  ~ReleasedFile() override { std::filesystem::remove(path); }
  void copy() const {
    std::filesystem::remove(path);
    std::filesystem::copy_file(original, path);
    using std::filesystem::perms;
    std::filesystem::permissions(path, perms::owner_read | perms::owner_write);
  }

  static std::string rows(Database& db, const std::string& sql) {
    std::string text;
    sqlite3_stmt* select = nullptr;
    EXPECT_EQ(sqlite3_prepare_v2(db, sql.c_str(), -1, &select, nullptr), SQLITE_OK) << sqlite3_errmsg(db);
    for (; sqlite3_step(select) == SQLITE_ROW; text += '\n')
      for (int i = 0; i < sqlite3_column_count(select); ++i) {
        const void* bytes = sqlite3_column_blob(select, i);
        text.append(static_cast<const char*>(bytes),
                    static_cast<std::size_t>(sqlite3_column_bytes(select, i)));
        text += '|';
      }
    EXPECT_EQ(sqlite3_finalize(select), SQLITE_OK);
    return text;
  }
  void expect_sound() {
    for (const std::string& table : tables)
      db.run("INSERT INTO " + table + "(" + table + ") VALUES('integrity-check')");
  }

  std::string original;
  std::vector<std::string> tables;
  std::string path;
  Database db;
};

class VersionZeroOne : public ReleasedFile {
 protected:
  VersionZeroOne() : ReleasedFile("version_0_1.db", {"ships", "crates", "drones"}) {}
  /// The shadow tables without the map, without the stamp, which is random, and without keys that version 0.1
  /// lacks.
  static std::string stored_apart_from_map(Database& db, const std::string& table) {
    std::string text =
        rows(db, "SELECT * FROM " + table + "_node") +
        rows(db, "SELECT * FROM " + table + "_meta WHERE key NOT IN ('stamp', 'objects', 'features')");
    return table == "crates" ? text + rows(db, "SELECT * FROM crates_aux") : text;
  }
  static std::string stored(Database& db, const std::string& table) {
    return stored_apart_from_map(db, table) + rows(db, "SELECT * FROM " + table + "_map");
  }
};

TEST_F(VersionZeroOne, IsReadWithoutChangingAByte) {
  EXPECT_EQ(rows(db, "SELECT count(*), sum(id), sum(t), sum(x) FROM ships"), "180|18020|18185.25|85711.0|\n");
  EXPECT_EQ(rows(db, "SELECT count(*), sum(x), count(cargo) FROM crates"), "40|-170.0|32|\n");
  EXPECT_EQ(rows(db, "SELECT count(*), sum(z), count(until) FROM drones"), "40|500.0|20|\n");
  const std::string pairs = "SELECT count(*), sum(a), sum(b) FROM predictive_join";
  EXPECT_EQ(rows(db, pairs + "(60, 'ships', 20)"), "68|2906|10663|\n");
  EXPECT_EQ(rows(db, pairs + "(30, 'crates')"), "1|-5|5|\n");
  EXPECT_EQ(rows(db, pairs + "(30, 'drones')"), "7|96|211|\n");
  expect_sound();
  EXPECT_TRUE(content(path) == content(original));
}

// A write converts the rows of the map to blocks, and adds a feature that version 0.1 does not know.
TEST_F(VersionZeroOne, IsWrittenWithItsNodesAndMigratesItsMap) {
  const std::string crates = stored(db, "crates"), drones = stored(db, "drones");
  const std::string meta =
                        "SELECT * FROM ships_meta WHERE key NOT IN ('stamp', 'root', 'objects', 'features')",
                    before = rows(db, meta);
  db.run("BEGIN; UPDATE ships SET x = x + 0.5, vx = 2 WHERE id % 3 = 0; DELETE FROM ships WHERE id = 12");
  db.run("INSERT INTO ships VALUES(500, 102, 1.5, 2.5, 0, 0, 1); COMMIT");
  expect_sound();
  EXPECT_EQ(rows(db, meta), before);
  EXPECT_EQ(rows(db, "SELECT value FROM ships_meta WHERE key = 'features'"), "blocks|\n");
  EXPECT_EQ(rows(db, "SELECT DISTINCT typeof(leaf) FROM ships_map ORDER BY 1"), "blob|\n");
  EXPECT_EQ(rows(db, "SELECT DISTINCT length(data), hex(substr(data, 2, 1)) FROM ships_node"), "4032|02|\n");
  EXPECT_EQ(rows(db, "SELECT count(*), sum(id), sum(vx) FROM ships WHERE vx = 2"), "75|7742|150.0|\n");
  EXPECT_TRUE(stored(db, "crates") == crates);
  EXPECT_TRUE(stored(db, "drones") == drones);
  db.run("INSERT INTO ships VALUES(501, 102, 1.5, 2.5, 0, 0, 1)");  // changes the number of objects
  EXPECT_EQ(rows(db, "SELECT value FROM ships_meta WHERE key = 'objects'"),
            rows(db, "SELECT count(*) FROM ships"));
  expect_sound();
}

/// The bytes of each object's record, by id, from all leaves of a table.
std::map<std::int64_t, std::string> stored_records(Database& db, const std::string& table,
                                                   const Layout& layout) {
  std::map<std::int64_t, std::string> records;
  Statement nodes(db, "SELECT data FROM " + table + "_node");
  Statement::Run run(nodes);
  while (run.step()) {
    const auto node = run.blob(0);
    const NodeFormat format(layout, node.size());
    if (load_number<std::uint8_t>(node.data() + NodeFormat::level_at) != 0) continue;
    const auto count = load_number<std::uint16_t>(node.data() + NodeFormat::count_at);
    for (std::size_t i = 0; i < count; ++i)
      records[load_number<std::int64_t>(node.data() + NodeFormat::ids_at + 8 * i)].assign(
          reinterpret_cast<const char*>(node.data()) + format.records_at + i * format.record_size,
          format.record_size);
  }
  return records;
}

// Ships were changed after their load, and drones are separated in time by later versions. Of both the records
// of the leaves are compared: the format does not define how nodes share them.
TEST_F(VersionZeroOne, CreatedAgainHasTheSameBytes) {
  Database fresh;
  sqlite3_foresee_init(fresh, nullptr, nullptr);
  const std::string sql = content(files + "version_0_1.sql");
  fresh.run(sql.substr(0, sql.find("VACUUM INTO")));
  const std::string schema = "SELECT name, sql FROM sqlite_schema ORDER BY name";
  EXPECT_EQ(rows(fresh, schema), rows(db, schema));
  for (const std::string& table : tables) {
    if (table == "crates") {
      EXPECT_TRUE(stored_apart_from_map(fresh, table) == stored_apart_from_map(db, table)) << table;
    }
    const std::string all = "SELECT * FROM " + table + " ORDER BY id";
    EXPECT_EQ(rows(fresh, all), rows(db, all));
  }
  const Layout drones{
      .axes = 3, .law = Law::forced, .shape = Shape::cylinder, .has_t = true, .has_until = true};
  EXPECT_EQ(stored_records(fresh, "drones", drones).size(), 40u);
  EXPECT_TRUE(stored_records(fresh, "drones", drones) == stored_records(db, "drones", drones));
  EXPECT_TRUE(stored_records(fresh, "ships", ships().layout) == stored_records(db, "ships", ships().layout));
}

class VersionZeroTwo : public ReleasedFile {
 protected:
  VersionZeroTwo() : ReleasedFile("version_0_2.db", {"ships", "hulls", "bodies"}) {}
  /// The pairs of the watch are those of a join at its own clock.
  void expect_watch_equals_join() {
    EXPECT_EQ(rows(db, "SELECT a, b, t FROM near ORDER BY a, b"),
              rows(db,
                   "SELECT a, b, t FROM predictive_join WHERE h = 60 AND tbl = 'ships' AND within = 5 AND "
                   "now = (SELECT value FROM near_meta WHERE key = 'now') ORDER BY a, b"));
  }
};

TEST_F(VersionZeroTwo, IsReadWithoutChangingAByte) {
  EXPECT_EQ(rows(db, "SELECT count(*), sum(id), sum(t), sum(x), sum(growth) FROM ships"),
            "180|18020|18185.25|85711.0|32.5|\n");
  EXPECT_EQ(rows(db, "SELECT count(*), sum(x), count(DISTINCT shape) FROM hulls"), "40|8420.0|2|\n");
  EXPECT_EQ(rows(db, "SELECT count(*), sum(z), count(DISTINCT shape) FROM bodies"), "24|108.0|2|\n");
  const std::string pairs = "SELECT count(*), sum(a), sum(b) FROM predictive_join";
  EXPECT_EQ(rows(db, pairs + "(60, 'ships', 5)"), "66|3614|9481|\n");
  EXPECT_EQ(rows(db, pairs + "(60, 'hulls')"), "57|772|1508|\n");
  EXPECT_EQ(rows(db, pairs + "(20, 'bodies')"), "5|53|73|\n");
  EXPECT_EQ(rows(db, "SELECT count(*), sum(a), sum(b) FROM near"), "66|3614|9481|\n");
  expect_watch_equals_join();
  expect_sound();
  EXPECT_TRUE(content(path) == content(original));
}

TEST_F(VersionZeroTwo, IsWrittenWithItsWatchOfFormatOne) {
  db.run("BEGIN; UPDATE ships SET t = 104, x = x + 0.5, growth = 0.25 WHERE id % 3 = 0");
  db.run(
      "DELETE FROM ships WHERE id = 12; INSERT INTO ships VALUES(500, 104, 1.5, 2.5, 0, 0, 1, 0, 'new'); "
      "COMMIT");
  EXPECT_EQ(rows(db, "SELECT value FROM near_meta WHERE key = 'format'"), "3|\n");
  expect_watch_equals_join();
  db.run(
      "INSERT INTO hulls SELECT 100 + id, t, x + 7, y, vx, vy, shape, heading, r FROM hulls WHERE id % 4 = "
      "0");
  db.run("UPDATE bodies SET heading = 90, z = z + 1 WHERE id % 2 = 0; DELETE FROM bodies WHERE id = 3");
  expect_sound();
  for (const char* join : {"(60, 'ships', 5)", "(60, 'hulls')", "(20, 'bodies')"}) {
    const std::string from = std::string("SELECT a, b, t FROM predictive_join") + join;
    EXPECT_EQ(rows(db, from + " WHERE method = 'tree' ORDER BY a, b"),
              rows(db, from + " WHERE method = 'scan' ORDER BY a, b"));
  }
}

// Each shape is stored once, with the bytes of version 0.2.
TEST_F(VersionZeroTwo, CreatedAgainHasTheSameRowsAndShapes) {
  Database fresh;
  sqlite3_foresee_init(fresh, nullptr, nullptr);
  const std::string sql = content(files + "version_0_2.sql");
  fresh.run(sql.substr(0, sql.find("VACUUM INTO")));
  for (const std::string& table : tables) {
    const std::string all = "SELECT * FROM " + table + " ORDER BY id";
    EXPECT_EQ(rows(fresh, all), rows(db, all));
  }
  for (const char* shapes : {"hulls_shape", "bodies_shape"}) {
    const std::string all = std::string("SELECT * FROM ") + shapes + " ORDER BY number";
    EXPECT_TRUE(rows(fresh, all) == rows(db, all)) << shapes;
  }
}

}  // namespace
}  // namespace foresee
