// The test database itself: how it prints rows, since all other tests compare printed rows.
#include "database.h"

#include "every_simd.h"

namespace foresee::testing {
namespace {

TEST(TestDatabase, PrintsEveryType) {
  Database db;
  EXPECT_EQ(
      db.rows("SELECT 1, 1.0, 0.1, -0.0, 1e300, NULL, 'text', x'0aff' UNION ALL SELECT 2,2,2,2,2,2,2,2"),
      "1|1.0|0.1|-0.0|1e+300|NULL|text|x'0aff'\n2|2|2|2|2|2|2|2");
}

TEST(TestDatabase, ReportsErrors) {
  Database db;
  EXPECT_EQ(db.error_of("SELECT nonsense"), "no such column: nonsense");
  EXPECT_EQ(db.rows("SELECT nonsense"), "error: no such column: nonsense");
  EXPECT_EQ(db.code_of("SELECT nonsense"), SQLITE_ERROR);
}

TEST(Scalars, AreRegisteredByTheEntryPoint) {
  Database db;
  EXPECT_EQ(db.rows("SELECT foresee_version()"), "0.2.0");
  EXPECT_EQ(db.rows("SELECT instr(foresee_debug(), 'SQLite: ') > 0"), "1");
}

TEST(Scalars, DebugNamesTheInstructionsInUse) {
  Database db;
  for_every_simd([&](Simd simd) {
    const std::string line = std::string("SIMD: ") + name_of(simd) + "\n";
    EXPECT_EQ(db.rows("SELECT instr(foresee_debug(), '" + line + "') > 0"), "1");
  });
}

}  // namespace
}  // namespace foresee::testing
