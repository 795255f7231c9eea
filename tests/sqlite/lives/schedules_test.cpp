// Schedules through SQL: rows that exist during [t, until]. Every method gives the same rows and the integrity
// check passes, however the rows were written: in one transaction or many, changed, deleted, read from a file.
#include <cmath>

#include "sanitized.h"
#include "scenes.h"
#include "sqlite/database.h"

namespace foresee::testing {
namespace {

std::string sql_number(double value) {
  char text[40];
  sqlite3_snprintf(sizeof text, text, "%!.17g", value);
  return std::isinf(value) ? "NULL" : text;
}

/// VALUES of one row of legs(id, t, x, y, vx, vy, r, until); one in three has an odd life.
std::string values_of_leg(int id, Random& random) {
  double t = 10.0 * static_cast<double>(random.below(40)), until = t + 10;
  switch (random.below(18)) {
    case 0:
      until = HUGE_VAL;
      break;
    case 1:
      until = t;
      break;
    case 2:
      t = 1e9, until = std::nextafter(t, HUGE_VAL);
      break;
    case 3:
      until = t + 1e12;
      break;
    case 4:
      t = -1e15, until = 1e15;
      break;
    case 5:
      until = t + 200 * random.unit();
      break;
  }
  std::string values = "(" + std::to_string(id) + ", " + sql_number(t);
  for (int i = 0; i < 2; ++i) values += ", " + sql_number(std::round(random.in(0, 150)));
  for (int i = 0; i < 2; ++i) values += ", " + sql_number(t < -1e14 ? 0 : random.in(-1.5, 1.5));
  return values + ", 1, " + sql_number(until) + ")";
}

struct Schedules : ::testing::Test {
  Schedules() { open(); }
  void open() {
    db.reset();
    db = std::make_unique<Database>(file.path());
  }
  void write(int first, int last) {
    for (int id = first; id < last; ++id)
      db->exec("INSERT OR REPLACE INTO legs VALUES" + values_of_leg(id, random));
  }
  void expect_equal_answers() {
    ASSERT_EQ(db->error_of("INSERT INTO legs(legs) VALUES('integrity-check')"), "");
    for (const char* now : {"0", "95", "200", "1000000000", "390"})
      for (const char* h : {"0", "10", "1000"}) {
        const std::string when = std::string(" AND now = ") + now + " AND h = " + h;
        const auto agree = [&](const std::string& sql, std::initializer_list<const char*> methods) {
          const std::string scanned = db->rows(sql + when + " AND method = 'scan' ORDER BY 1, 2");
          EXPECT_FALSE(scanned.starts_with("error")) << scanned;
          for (const char* method : methods)
            EXPECT_EQ(db->rows(sql + when + " AND method = '" + method + "' ORDER BY 1, 2"), scanned) << when;
          found += scanned.size();
        };
        agree("SELECT * FROM predictive_join WHERE tbl = 'legs'", {"grid", "tree", "gpcd"});
        agree(
            "SELECT * FROM predictive_window WHERE tbl = 'legs' AND x0 = 40 AND x1 = 75 AND y0 = 20 AND y1 = "
            "60",
            {"tree"});
        agree(
            "SELECT distance, id FROM predictive_nearest WHERE tbl = 'legs' AND k = 5 AND x = 70 AND y = 70",
            {"tree"});
      }
  }

  TemporaryFile file;
  std::unique_ptr<Database> db;
  Random random{31};
  std::size_t found = 0;
};

constexpr int leg_count = sanitized ? 150 : 400;

TEST_F(Schedules, EveryMethodGivesTheSameRows) {
  for (const bool in_one_transaction : {false, true}) {
    db->exec("PRAGMA synchronous = OFF");
    db->exec("CREATE VIRTUAL TABLE legs USING moving_objects(id, t, x, y, vx, vy, r, until)");
    if (in_one_transaction) db->exec("BEGIN");
    write(0, leg_count);
    if (in_one_transaction) db->exec("COMMIT");
    expect_equal_answers();
    db->exec("BEGIN");
    write(leg_count / 2, leg_count + leg_count / 2);
    db->exec("SAVEPOINT s; DELETE FROM legs WHERE id % 2 = 0; ROLLBACK TO s");
    db->exec("DELETE FROM legs WHERE id % 7 = 0; COMMIT");
    expect_equal_answers();
    open();
    db->exec("PRAGMA synchronous = OFF");
    db->exec("UPDATE legs SET until = t + 3 WHERE id % 5 = 0");
    db->exec("UPDATE legs SET until = NULL WHERE id % 11 = 0");
    db->exec("UPDATE legs SET t = t + 20, until = until + 20 WHERE id % 3 = 0");
    expect_equal_answers();
    db->exec("INSERT INTO legs(legs) VALUES('optimize')");
    expect_equal_answers();
    db->exec("DROP TABLE legs");
  }
  EXPECT_GT(found, 50000u);
}

}  // namespace
}  // namespace foresee::testing
