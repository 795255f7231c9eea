// Versions of the host's SQLite, and how foresee compares schema names.
#include "sqlite/host_sqlite.h"

#include "base/error.h"
#include "sqlite/database.h"
#include "sqlite/version.h"

namespace foresee::testing {
namespace {

TEST(Host, OfAnOldSqliteIsRefusedWithBothVersions) {
  EXPECT_NO_THROW(require_version(3031000, "3.31.0"));
  EXPECT_NO_THROW(require_version(sqlite3_libversion_number(), sqlite3_libversion()));
  try {
    require_version(3030001, "3.30.1");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.what(), "foresee " + std::string(version()) +
                                " needs SQLite 3.31 or newer, and this program has 3.30.1");
  }
}

TEST(Host, ListsSchemasInTheOrderOfSqlitesLookUp) {
  Database db;
  EXPECT_EQ(schema_names(db.handle()), (std::vector<std::string>{"temp", "main"}));
  db.exec("ATTACH ':memory:' AS zebra; ATTACH ':memory:' AS apes");
  EXPECT_EQ(schema_names(db.handle()), (std::vector<std::string>{"temp", "main", "zebra", "apes"}));
}

}  // namespace
}  // namespace foresee::testing
