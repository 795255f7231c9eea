// A watch of format 2, with indexes in place of key tables, is read, updated, renamed and dropped; its rows and its log
// are those of a watch that is new.
#include "scenes.h"
#include "sqlite/watch/older_watch.h"
#include "sqlite/watch/watch_reader.h"

namespace foresee::testing {
namespace {

std::string shown(double number) {
  return std::to_string(number);
}

/// An UPDATE or two of random ships at this time, or an INSERT, a DELETE, or all of them.
std::string random_change(Random& random, double t) {
  const auto id = [&] { return std::to_string(1 + random.below(80)); };
  const std::string where = " WHERE id = " + id();
  switch (random.below(8)) {
    case 0:
      return "DELETE FROM ships" + where;
    case 1:
      return "UPDATE ships SET x = x + vx * (" + shown(t) + " - t), y = y + vy * (" + shown(t) +
             " - t), t = " + shown(t);
    case 2:
      return "UPDATE ships SET t = " + shown(t) + where;
    default:
      return "INSERT OR REPLACE INTO ships VALUES (" + id() + ", " + shown(t) + ", " +
             shown(random.in(0, 100)) + ", " + shown(random.in(0, 100)) + ", " + shown(random.in(-2, 2)) +
             ", " + shown(random.in(-2, 2)) + ", 1)";
  }
}

class WatchOfFormat2 : public ::testing::TestWithParam<const char*> {};

TEST_P(WatchOfFormat2, HasTheRowsAndTheLogOfANewOne) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    Database db;
    Random random(seed);
    db.exec("CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy, r)");
    for (int i = 0; i < 120; ++i) db.exec(random_change(random, 0));
    for (const char* watch : {"alerts", "fresh"})
      db.exec(std::string("CREATE VIRTUAL TABLE ") + watch + " USING predictive_watch(ships, " + GetParam() +
              ")");
    EXPECT_EQ(db.rows("SELECT value FROM fresh_meta WHERE key = 'format'"), "3");
    make_format_2(db, "alerts");
    const std::string columns = "SELECT op, a, b, t, now FROM predictive_changes('";
    double t = 0;
    for (int step = 0; step < 80 && !HasFailure(); ++step) {
      t += random.in(0, step % 20 == 19 ? 40 : 2);
      db.exec(random.below(3) == 0
                  ? "BEGIN;" + random_change(random, t) + ";" + random_change(random, t) + "; COMMIT"
                  : random_change(random, t));
      ASSERT_EQ(db.rows("SELECT * FROM alerts ORDER BY a, b"), db.rows("SELECT * FROM fresh ORDER BY a, b"));
      ASSERT_EQ(db.rows(columns + "alerts', 1)"), db.rows(columns + "fresh', 1)"));
      expect_up_to_date(db);
      ASSERT_EQ(db.error_of("INSERT INTO fresh(fresh) VALUES('integrity-check')"), "");
      const std::string where = " WHERE a = " + std::to_string(1 + step);
      ASSERT_EQ(db.rows("SELECT b, t FROM alerts" + where), db.rows("SELECT b, t FROM fresh" + where));
    }
    EXPECT_EQ(db.rows("SELECT value FROM alerts_meta WHERE key = 'format'"), "3");
    EXPECT_EQ(
        db.rows("SELECT name FROM sqlite_schema WHERE name LIKE 'alerts_back' OR name LIKE 'alerts_due'"),
        "");
    db.exec("ALTER TABLE alerts RENAME TO warnings; INSERT INTO warnings(warnings) VALUES('rebuild')");
    EXPECT_EQ(db.error_of("INSERT INTO warnings(warnings) VALUES('integrity-check')"), "");
    db.exec("DROP TABLE warnings");
    EXPECT_EQ(db.rows("SELECT name FROM sqlite_schema WHERE name LIKE 'warnings%'"), "");
    db.exec("ALTER TABLE fresh RENAME TO alerts; UPDATE ships SET x = x + 1 WHERE id < 20");
    expect_up_to_date(db);
  }
}

INSTANTIATE_TEST_SUITE_P(Options, WatchOfFormat2,
                         ::testing::Values("horizon = 20", "horizon = 5, within = 1, tolerance = 0.5",
                                           "horizon = 20, other = ships"));

TEST(WatchFormats, AnotherConnectionMayCreateTheWatchAnew) {
  const TemporaryFile file;
  Database db(file.path());
  db.exec(
      "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, vx, r);"
      "INSERT INTO ships VALUES (1, 0, 0, 1, 10), (2, 0, 120, -1, 10), (3, 0, 900, 1, 1);"
      "CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 100)");
  make_format_2(db, "alerts");
  db.exec("UPDATE ships SET x = 121 WHERE id = 2");
  expect_up_to_date(db);
  {
    Database other(file.path());
    other.exec("DROP TABLE alerts; CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 100)");
  }
  db.exec("UPDATE ships SET x = 60 WHERE id = 3");
  expect_joined(db, "h = 100");
  expect_up_to_date(db);
}

}  // namespace
}  // namespace foresee::testing
