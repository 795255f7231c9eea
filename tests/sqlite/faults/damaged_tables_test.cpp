// Damaged shadow tables, and pages of a file that point at one another: every statement ends, with an error
// that names the table.
#include <array>
#include <fstream>
#include <iterator>

#include "sqlite/database.h"

namespace foresee::testing {
namespace {

constexpr const char* statements[] = {
    "SELECT count(*), sum(x) FROM ships",
    "UPDATE ships SET x = x + 1",
    "DELETE FROM ships WHERE x > 2",
    "SELECT count(*) FROM predictive_join(20, 'ships')",
    "INSERT INTO ships(ships) VALUES('rebuild')",
    "INSERT INTO ships(ships) VALUES('optimize')",
    "INSERT INTO ships(ships) VALUES('integrity-check')",
};

void build(Database& db) {
  db.exec(
      "PRAGMA page_size = 512;"
      "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy, r, +name);"
      "WITH n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 300)"
      "INSERT INTO ships SELECT i, i % 5, i * 37 % 100, i * 53 % 90, i % 7 - 3, i % 5 - 2, 0.5, 'a' || i "
      "FROM n");
}

/// A statement without an end fails with "interrupted".
void give_up_in_time(Database& db) {
  static int calls;
  calls = 0;
  sqlite3_progress_handler(
      db.handle(), 1000, [](void*) { return ++calls > 1000 ? 1 : 0; }, nullptr);
}

/// Every statement ends with an error; the error of a scan contains these words.
void expect_errors(Database& db, const std::string& words) {
  give_up_in_time(db);
  for (const char* statement : statements) {
    const std::string error = db.error_of(statement);
    EXPECT_NE(error.find("ships"), std::string::npos) << statement << " says '" << error << "'";
  }
  EXPECT_NE(db.error_of(statements[0]).find(words), std::string::npos) << db.error_of(statements[0]);
}

/// Points every cell of a root page to its first child, so that a scan never ends.
void point_all_cells_to_the_first_child(const std::string& path, std::size_t page) {
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  std::array<unsigned char, 512> bytes;
  const auto place = static_cast<std::streamoff>((page - 1) * bytes.size());
  file.seekg(place);
  file.read(reinterpret_cast<char*>(bytes.data()), bytes.size());
  constexpr unsigned char inner_page = 5;
  constexpr std::size_t count_at = 3, last_child_at = 8, cells_at = 12;
  ASSERT_EQ(bytes[0], inner_page);
  const auto two_bytes = [&](std::size_t at) { return std::size_t{bytes[at]} << 8 | bytes[at + 1]; };
  const std::size_t first_child = two_bytes(cells_at);
  std::copy_n(bytes.begin() + first_child, 4, bytes.begin() + last_child_at);
  for (std::size_t cell = 0; cell < two_bytes(count_at); ++cell)
    std::copy_n(bytes.begin() + first_child, 4, bytes.begin() + two_bytes(cells_at + 2 * cell));
  file.seekp(place);
  file.write(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

TEST(DamagedTables, PagesThatLeadBackEndEveryStatement) {
  for (const std::string table : {"ships_node", "ships_map", "ships_aux"}) {
    TemporaryFile file;
    std::size_t root;
    {
      Database db(file.path());
      build(db);
      root = std::stoul(db.rows("SELECT rootpage FROM sqlite_schema WHERE name = '" + table + "'"));
    }
    point_all_cells_to_the_first_child(file.path(), root);
    Database db(file.path());
    db.exec("BEGIN");
    if (table == "ships_node") {
      expect_errors(db, "ships_node is damaged: row 1 comes after row ");
    } else {
      give_up_in_time(db);
      EXPECT_NE(
          db.error_of("INSERT INTO ships(ships) VALUES('integrity-check')").find(table + " is damaged: row "),
          std::string::npos);
    }
  }
}

TEST(DamagedTables, NodeNumbersThatAreNoIntegersEndEveryStatement) {
  for (const std::string number : {"'a' || nodeno", "nodeno + 0.5", "CAST(nodeno AS TEXT)", "x'00'"}) {
    Database db;
    build(db);
    db.exec(
        "ALTER TABLE ships_node RENAME TO n; CREATE TABLE ships_node(nodeno, data);"
        "INSERT INTO ships_node SELECT " +
        number + ", data FROM n");
    expect_errors(db, "ships_node is damaged: the number of a row is not an integer");
  }
}

/// Reopens a database after `change`, as another program would, and calls `look` with it.
void reopen(const TemporaryFile& file, const std::string& change, const auto& look) {
  {
    Database db(file.path());
    build(db);
    db.exec(change);
  }
  Database db(file.path());
  give_up_in_time(db);
  look(db);
}

TEST(DamagedTables, AViewInPlaceOfAShadowTableIsRefused) {
  const std::string without_end = "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) ";
  for (const auto& [table, rows] : {std::pair{"ships_meta", "SELECT 'key' || i AS key, i AS value FROM n"},
                                    std::pair{"ships_node", "SELECT i AS nodeno, x'00' AS data FROM n"},
                                    std::pair{"ships_map", "SELECT i AS id, 1 AS leaf FROM n"},
                                    std::pair{"ships_aux", "SELECT i AS id, 1 AS a0 FROM n"}}) {
    const std::string name = table;
    TemporaryFile file;
    reopen(file, "DROP TABLE " + name + "; CREATE VIEW " + name + " AS " + without_end + rows,
           [&](Database& db) {
             const std::string words = "ships: " + name +
                                       " is a view, where foresee keeps a table of its own: DROP VIEW " +
                                       name + ", then DROP TABLE ships";
             EXPECT_NE(db.error_of("SELECT * FROM ships").find(words), std::string::npos);
             EXPECT_NE(db.error_of("SELECT * FROM predictive_join(1, 'ships')").find(words),
                       std::string::npos);
             db.exec("DROP VIEW " + name + "; DROP TABLE ships");
             EXPECT_EQ(db.rows("SELECT count(*) FROM sqlite_schema"), "0");
           });
  }
}

TEST(DamagedTables, AVirtualTableInPlaceOfAShadowTableIsRefused) {
  TemporaryFile file;
  reopen(file, "DROP TABLE ships_map; CREATE VIRTUAL TABLE ships_map USING moving_objects(id, x)",
         [](Database& db) {
           EXPECT_NE(db.error_of("SELECT * FROM ships").find("ships: ships_map is a virtual table, where"),
                     std::string::npos);
           db.exec("DROP TABLE ships_map; DROP TABLE ships");
         });
}

TEST(DamagedTables, ALongValueInMetaIsReadOnlyUpToItsExpectedLength) {
  TemporaryFile file;
  reopen(file, "UPDATE ships_meta SET value = printf('%.*c', 1000000, 'x') WHERE key = 'columns'",
         [](Database& db) {
           const std::string error = db.error_of("SELECT * FROM ships");
           EXPECT_NE(error.find("ships: stored with the columns (xxxx"), std::string::npos);
           EXPECT_NE(error.find("but declared with (id, t, x, y, vx, vy, r, +name)"), std::string::npos);
           EXPECT_LT(error.size(), 2000u);
         });
}

/// Keys that no query depends on do no harm; all others give an error that names the table.
TEST(DamagedTables, AValueInMetaOfAnotherTypeOrRangeIsAnErrorOrDoesNoHarm) {
  const std::string join = "SELECT a, b, t FROM predictive_join(20, 'ships') ORDER BY a, b",
                    scan = "SELECT id, x, name FROM ships ORDER BY id";
  Database sound;
  build(sound);
  const std::string joined = sound.rows(join), scanned = sound.rows(scan);
  for (const std::string key :
       {"format", "columns", "node_size", "horizon", "root", "stamp", "objects", "features"})
    for (const std::string value : {"'abc'", "x'616263'", "-1", "0", "9e999", "1.5", "NULL", "missing"}) {
      const std::string change =
          value == "missing" ? "DELETE FROM ships_meta WHERE key = '" + key + "'"
                             : "UPDATE ships_meta SET value = " + value + " WHERE key = '" + key + "'";
      const bool harmless = key == "horizon" || key == "objects" ||
                            (key == "features" && (value == "NULL" || value == "missing")) ||
                            (key == "stamp" && (value == "-1" || value == "0"));
      TemporaryFile file;
      reopen(file, "PRAGMA synchronous = OFF;" + change, [&](Database& db) {
        const std::string error = db.error_of(join);
        EXPECT_EQ(error.empty(), harmless) << change << ": " << error;
        EXPECT_TRUE(harmless || error.find("ships: ") != std::string::npos) << change << ": " << error;
        if (harmless) {
          EXPECT_EQ(db.rows(join), joined) << change;
        }
        const std::string rows = db.rows(scan);
        EXPECT_TRUE(rows == scanned || (!harmless && rows.starts_with("error"))) << change << ": " << rows;
        EXPECT_EQ(db.error_of("UPDATE ships SET x = x + 1 WHERE id = 7").empty(), harmless) << change;
      });
    }
}

TEST(DamagedTables, AReadOfAllObjectsComparesTheirNumberWithTheMap) {
  const std::string words = "ships: the leaves hold 300 objects, the map 236";
  for (const char* statement :
       {"SELECT count(*) FROM ships", "UPDATE ships SET x = 1", "DELETE FROM ships WHERE x > 50",
        "SELECT count(*) FROM predictive_join(20, 'ships', 0, NULL, 0, 'grid')",
        "SELECT count(*) FROM predictive_join(20, 'ships', 0, NULL, 0, 'tree')"}) {
    TemporaryFile file;
    reopen(file, "DELETE FROM ships_map WHERE id = 128", [&](Database& db) {
      EXPECT_NE(db.error_of(statement).find(words), std::string::npos) << statement;
      EXPECT_EQ(db.rows("SELECT id FROM ships WHERE id = 8"), "8");
    });
  }
}

}  // namespace
}  // namespace foresee::testing
