// Changes of a watch by its clock alone: ends of horizons and of contacts, at the exact time, and a second
// contact. Steps back and far ahead, and tables without a clock of their own.
#include "sqlite/watch/older_watch.h"
#include "sqlite/watch/watch_reader.h"

namespace foresee::testing {
namespace {

struct WatchTime : ::testing::Test {
  void create(const std::string& columns, const std::string& options) {
    db.exec("CREATE VIRTUAL TABLE ships USING moving_objects(id, " + columns + ")");
    db.exec("CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, " + options + ")");
  }
  void advance(const std::string& now) {
    db.exec("INSERT INTO alerts(alerts, now) VALUES('advance', " + now + ")");
  }
  /// The changes after the position of the last call.
  std::string changes() {
    const std::string rows = db.rows("SELECT op, a, b, t, now FROM predictive_changes('alerts', " +
                                     std::to_string(position_) + ")");
    position_ = std::stoi(db.rows("SELECT seq FROM predictive_watches"));
    return rows;
  }

  Database db;

 private:
  int position_ = 0;
};

TEST_F(WatchTime, APairIsShownFromTheTickWhoseHorizonEndsAtItsStart) {
  create("x, vx", "horizon = 10, within = 1");
  db.exec("INSERT INTO ships VALUES (1, 0, 1), (2, 31, 0)");  // they touch from 30 to 32
  advance("19.999999999999996");
  EXPECT_EQ(changes(), "");
  advance("20");
  EXPECT_EQ(changes(), "+|1|2|30.0|20.0");
  advance("32");
  EXPECT_EQ(db.rows("SELECT t, t_end FROM alerts"), "32.0|32.0");
  advance("32.00000000000001");
  EXPECT_EQ(changes(), "-|1|2|NULL|32.00000000000001");
}

TEST_F(WatchTime, EveryTickOfAWholeNumberSceneIsTheJoin) {
  create("x, y, vx, vy, hx, hy", "horizon = 7, within = 1");
  db.exec(
      "WITH n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 60)"
      "INSERT INTO ships SELECT i, i * 37 % 101 - 50, i * 53 % 41 - 20, i % 7 - 3, i % 5 - 2, i % 2, i % 3 "
      "FROM n");
  WatchReader reader;
  for (int tick = 0; tick < 70 && !HasFailure(); ++tick) {
    for (const char* by : {" - 1e-14", "", " + 1e-14"}) {
      advance(std::to_string(tick) + by);
      expect_joined(db, "h = 7 AND within = 1", " at " + std::to_string(tick) + by);
    }
    reader.read(db);
    reader.expect_rows(db);
  }
  expect_up_to_date(db);
}

// With x = 7 - 6t + t² for the second, they touch from 3 - sqrt(3) to 2, and from 4 to 3 + sqrt(3).
TEST_F(WatchTime, APairThatMeetsAgainIsLoggedWithItsNextTime) {
  create("x, vx, ax", "horizon = 20, within = 1");
  db.exec("INSERT INTO ships VALUES (1, 0, 0, 0), (2, 7, -6, 2)");
  EXPECT_EQ(db.rows("SELECT round(t, 2), t_end FROM alerts"), "1.27|2.0");
  changes();
  advance("2");
  EXPECT_EQ(changes(), "");
  advance("3");
  EXPECT_EQ(changes(), "~|1|2|4.0|3.0");
  expect_joined(db, "h = 20 AND within = 1");
  advance("6");
  EXPECT_EQ(changes(), "-|1|2|NULL|6.0");
}

TEST_F(WatchTime, APairThatMeetsAgainBeyondTheHorizonIsANewPair) {
  create("x, vx, ax", "horizon = 0.5, within = 1");
  db.exec("INSERT INTO ships VALUES (1, 0, 0, 0), (2, 7, -6, 2)");
  std::string ops;
  for (const char* now : {"0.7", "0.8", "2", "2.5", "3.4", "3.5", "5"}) {
    advance(now);
    const std::string change = changes();
    ops += change.empty() ? '.' : change[0];
    expect_joined(db, "h = 0.5 AND within = 1", now);
  }
  EXPECT_EQ(ops, ".+.-.+-");
}

TEST_F(WatchTime, AnObjectThatEndsLeavesItsPairsByTheClockAlone) {
  create("t, x, r, until", "horizon = 10");
  db.exec("INSERT INTO ships VALUES (1, 0, 0, 5, NULL), (2, 0, 3, 5, 50), (3, 0, 4, 5, 12)");
  changes();
  advance("12");
  EXPECT_EQ(changes(), "");
  advance("12.5");
  EXPECT_EQ(changes(), "-|1|3|NULL|12.5\n-|2|3|NULL|12.5");
  advance("60");
  EXPECT_EQ(changes(), "-|1|2|NULL|60.0");
}

TEST_F(WatchTime, AContactThatTheClockSkipsIsNotStored) {
  create("x, vx", "horizon = 10, within = 1");
  db.exec("INSERT INTO ships VALUES (1, 0, 1), (2, 31, 0), (3, 500, 0)");
  advance("100");
  EXPECT_EQ(changes(), "");
  advance("495");
  EXPECT_EQ(changes(), "+|1|3|499.0|495.0");
  advance("20");
  EXPECT_EQ(changes(), "+|1|2|30.0|20.0\n-|1|3|NULL|20.0");
  advance("1e300");
  EXPECT_EQ(changes(), "-|1|2|NULL|1e+300");
  advance("-1e300");
  EXPECT_EQ(changes(), "");
  advance("29");
  EXPECT_EQ(changes(), "+|1|2|30.0|29.0");
  expect_up_to_date(db);
}

// In contact since 0: a reader that starts at 100 must not take 100 for the start of the contact.
TEST_F(WatchTime, AReaderThatStartsLateFollowsAClockThatGoesBack) {
  create("x, r", "horizon = 10, clock = manual");
  db.exec("INSERT INTO ships VALUES (1, 0, 5), (2, 8, 5)");
  advance("100");
  WatchReader reader;
  reader.read(db);
  reader.expect_rows(db);
  for (const char* now : {"50", "70", "20", "300", "5", "0"}) {
    advance(now);
    EXPECT_EQ(db.rows("SELECT t FROM alerts"), std::string(now) + ".0");
    reader.read(db, now);
    reader.expect_rows(db, now);
    reader.expect_whole(db, now);
    expect_joined(db, "h = 10", now);
  }
}

TEST_F(WatchTime, WithoutAHorizonItSaysEnterAndLeave) {
  create("t, x, vx", "horizon = 0, within = 1");
  db.exec("INSERT INTO ships VALUES (1, 0, 0, 1), (2, 0, 10, 0)");
  std::string ops;
  for (const char* now : {"8.5", "9", "10", "11", "11.5"}) {
    advance(now);
    const std::string change = changes();
    ops += change.empty() ? '.' : change[0];
    expect_joined(db, "h = 0 AND within = 1", now);
  }
  EXPECT_EQ(ops, ".+..-");
}

TEST_F(WatchTime, SmallMovesAddUpUntilTheyAreLogged) {
  create("t, x, vx, r", "horizon = 100, tolerance = 3");
  db.exec("INSERT INTO ships VALUES (1, 0, 0, 1, 0), (2, 0, 50, 0, 0)");
  changes();
  std::string ops;
  for (const char* x : {"52", "53", "54", "52", "51", "50.5"}) {
    db.exec(std::string("UPDATE ships SET x = ") + x + " WHERE id = 2");
    const std::string change = changes();
    ops += change.empty() ? '.' : change[0];
    expect_joined(db, "h = 100", x);
  }
  EXPECT_EQ(ops, "..~..~");
}

TEST_F(WatchTime, AnEmptyTableHasAClockFromItsFirstRowOn) {
  create("t, x, r", "horizon = 10");
  EXPECT_EQ(db.rows("SELECT * FROM alerts"), "");
  EXPECT_EQ(db.rows("SELECT seq, pairs, fault FROM predictive_watches"), "0|0|NULL");
  db.exec("INSERT INTO ships VALUES (1, 70, 0, 5), (2, 80, 0, 5)");
  EXPECT_EQ(changes(), "+|1|2|80.0|80.0");
  db.exec("DELETE FROM ships");
  EXPECT_EQ(changes(), "-|1|2|NULL|80.0");
  EXPECT_EQ(db.rows("SELECT now FROM predictive_watches"), "80.0");
  db.exec("INSERT INTO ships VALUES (1, 7, 0, 5), (2, 8, 0, 5)");
  EXPECT_EQ(changes(), "+|1|2|80.0|80.0");
  expect_up_to_date(db);
}

TEST_F(WatchTime, ClocksOfNegativeTimesAdvanceAsWell) {
  create("t, x, r", "horizon = 10");
  db.exec("INSERT INTO ships VALUES (1, -70, 0, 5), (2, -80, 0, 5)");
  EXPECT_EQ(changes(), "+|1|2|-70.0|-70.0");
  db.exec("UPDATE ships SET t = -60 WHERE id = 1");
  EXPECT_EQ(db.rows("SELECT now FROM predictive_watches"), "-60.0");
}

TEST_F(WatchTime, TheNewestRowMovesTheClockOnlyForward) {
  create("t, x, r", "horizon = 10");
  db.exec("INSERT INTO ships VALUES (1, 0, 0, 5), (2, 30, 0, 5)");
  db.exec("DELETE FROM ships WHERE id = 2");
  EXPECT_EQ(db.rows("SELECT now FROM predictive_watches"), "30.0");
  db.exec("INSERT INTO ships VALUES (2, 10, 0, 5)");
  EXPECT_EQ(db.rows("SELECT t FROM alerts"), "30.0");
  expect_up_to_date(db);
}

TEST_F(WatchTime, AGiantThatTouchesAllLogsNothingWhileItsContactsLast) {
  create("t, x, y, r", "horizon = 10");
  db.exec(
      "WITH n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 2000)"
      "INSERT INTO ships SELECT i, 0, i % 45 * 10, i / 45 * 10, 1 FROM n; INSERT INTO ships VALUES (0, 0, 0, "
      "0, 1e4)");
  EXPECT_EQ(db.rows("SELECT count(*) FROM alerts WHERE a = 0"), "2000");
  changes();
  for (int tick = 1; tick <= 5; ++tick) {
    db.exec("UPDATE ships SET t = t + 1, x = x + 7 WHERE id = 0");
    EXPECT_EQ(changes(), "");
  }
  expect_joined(db, "h = 10");
  db.exec("UPDATE ships SET r = 55 WHERE id = 0");
  EXPECT_EQ(db.rows("SELECT count(*) FROM alerts"),
            db.rows("SELECT 2000 - count(*) FROM predictive_changes('alerts', 2000)"));
  expect_up_to_date(db);
}

TEST_F(WatchTime, ReportsOfShipsInLastingContactWriteNoPair) {
  create("t, x, vx", "horizon = 100, within = 10");
  db.exec("INSERT INTO ships VALUES (1, 0, 0, 0), (2, 0, 5, 0), (3, 0, 3, 0.0001)");
  const std::string pairs = "SELECT a, b, t, due, state FROM alerts_pair";
  const std::string before = db.rows(pairs);
  for (int t = 1; t <= 20; ++t) db.exec("UPDATE ships SET t = " + std::to_string(t) + ", x = x + vx");
  EXPECT_EQ(db.rows(pairs), before);
  expect_up_to_date(db);
}

// Two side by side, the second slower: they separate at 1024. The watch computes this end in the update whose
// interval reaches so far.
TEST_F(WatchTime, ALongContactIsDueOnceItsEndIsKnown) {
  create("x, vx", "horizon = 10, within = 1");
  db.exec("INSERT INTO ships VALUES (1, 0, 1), (2, 0, 0.9990234375)");
  const std::string due = "SELECT due FROM alerts_pair";
  EXPECT_EQ(db.rows(due), "NULL");
  bool was_due = false;
  for (int t = 1; t <= 1023; t += 2) {
    advance(std::to_string(t));
    const bool is_due = db.rows(due) != "NULL";
    EXPECT_TRUE(is_due || !was_due) << t;
    was_due = is_due;
  }
  expect_up_to_date(db);
  changes();
  advance("1024");
  EXPECT_EQ(changes(), "");
  advance("1024.5");
  EXPECT_EQ(changes(), "-|1|2|NULL|1024.5");
}

// Files of older versions have a due time at or before the end, for contacts of any length.
TEST_F(WatchTime, AContactMayBeDueEarlierThanItEnds) {
  create("x, vx", "horizon = 10, within = 1");
  db.exec("INSERT INTO ships VALUES (1, 0, 1), (2, 0, 0.9990234375)");
  make_format_2(db, "alerts");
  for (int t = 1; t <= 1025; ++t) {
    if (t % 100 == 50) db.exec("UPDATE alerts_pair SET due = " + std::to_string(std::min(t + 70, 1024)));
    advance(std::to_string(t));
    EXPECT_EQ(db.rows("SELECT count(*) FROM alerts"), t <= 1024 ? "1" : "0") << t;
  }
  expect_up_to_date(db);
}

TEST_F(WatchTime, AllObjectsMayChangeAtOnce) {
  create("t, x, y, vx, vy, r", "horizon = 5, within = 2");
  db.exec(
      "WITH n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 600)"
      "INSERT INTO ships SELECT i, 0, i * 37 % 401, i * 53 % 307, i % 7 - 3, i % 5 - 2, 1 FROM n");
  WatchReader reader;
  for (const char* change : {"x = x + vx", "vx = -vx, t = t + 1", "id = -id", "r = 3"}) {
    db.exec(std::string("UPDATE ships SET ") + change);
    expect_joined(db, "h = 5 AND within = 2", change);
    reader.read(db, change);
    reader.expect_rows(db, change);
  }
  expect_up_to_date(db);
}

}  // namespace
}  // namespace foresee::testing
