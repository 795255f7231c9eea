// A test fixture for query plans of predictive_join: the call, and an ordinary table with all its rows.
// SQLite itself applies any condition, order or limit to that table.
//
//   TEST_F(JoinPlanner, ...) { both("WHERE dt > 0 ORDER BY t, a, b LIMIT 10"); }
#pragma once

#include <cctype>
#include <cstdlib>
#include <string>
#include <vector>

#include "sqlite/harbour_scene.h"
#include "sqlite/scene_table.h"

namespace foresee::testing {

struct JoinPlanner : ::testing::Test {
  JoinPlanner() {
    build_table(db, "ships",
                random_scene({.layout = {.axes = 2, .law = Law::uniform, .shape = Shape::ball},
                              .kind = SceneKind::clustered,
                              .count = 400,
                              .seed = 3}));
    db.exec("CREATE TEMP TABLE whole AS SELECT * FROM predictive_join(3)");
  }

  /// The rows of the call, which must equal those of the table that holds all its rows.
  std::string both(const std::string& where) {
    const std::string queried = db.rows("SELECT * FROM predictive_join(3) " + where);
    EXPECT_EQ(queried, db.rows("SELECT * FROM whole " + where)) << where;
    return queried;
  }

  /// As db.rows(), with numbers, texts and NULL bound.
  std::string bound(const std::string& sql, const std::vector<const char*>& values) {
    sqlite3_stmt* statement = nullptr;
    EXPECT_EQ(sqlite3_prepare_v2(db.handle(), sql.c_str(), -1, &statement, nullptr), SQLITE_OK) << sql;
    int place = 0;
    for (const char* value : values)
      if (++place, value && std::isdigit(*value))
        sqlite3_bind_int(statement, place, std::atoi(value));
      else
        sqlite3_bind_text(statement, place, value, -1, SQLITE_STATIC);
    const std::string rows = db.rows_of(statement);
    sqlite3_finalize(statement);
    return rows;
  }

  std::string plan(const std::string& sql) { return db.rows("EXPLAIN QUERY PLAN " + sql); }

  Database db;
};

}  // namespace foresee::testing
