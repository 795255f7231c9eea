// Watches with `ahead`: the clock follows the reports of most objects, whatever a few wrong clocks send.
#include "sqlite/database.h"

namespace foresee {
namespace {

using testing::Database;

struct WatchAhead : ::testing::Test {
  WatchAhead() {
    db.exec(
        "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy, r);"
        "INSERT INTO ships VALUES (1, 0, 0, 0, 1, 0, 10), (2, 0, 120, 0, -1, 0, 10), (3, 0, 0, 9000, 0, 0, "
        "10)");
  }
  double now() { return std::stod(db.rows("SELECT now FROM predictive_watches")); }
  void report(int id, double t) {
    db.exec("UPDATE ships SET t = " + std::to_string(t) + " WHERE id = " + std::to_string(id));
  }
  /// Ships in place of those of the fixture, each with its first report at t = 0, and a watch of them.
  void make_fleet(int ships) {
    db.exec(
        "DELETE FROM ships; INSERT INTO ships WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n "
        "WHERE i < " +
        std::to_string(ships) +
        ") SELECT i, 0, 100 * i, 0, 0, 0, 10 FROM n;"
        "CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 100, ahead = 60)");
  }

  Database db;
};

// After a pause of the feed every report is beyond `ahead`.
TEST_F(WatchAhead, TheClockFollowsAMajorityBeyondAhead) {
  db.exec(
      "INSERT INTO ships VALUES (4, 0, 0, 8000, 0, 0, 10), (5, -500, 0, 7000, 0, 0, 10);"
      "CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 100, ahead = 60);"
      "UPDATE ships SET t = 1000 WHERE id = 1; UPDATE ships SET t = 5e9 WHERE id = 4");
  EXPECT_EQ(db.rows("SELECT now, early FROM predictive_watches"),
            "0.0|2");  // as many as have reported in time
  db.exec("UPDATE ships SET t = 1020 WHERE id = 2");
  EXPECT_EQ(db.rows("SELECT now, early, fault FROM predictive_watches"), "1020.0|3|NULL");
  EXPECT_EQ(db.rows("SELECT * FROM alerts"),
            db.rows("SELECT * FROM predictive_join(100, 'ships') WHERE now = 1020"));
  db.exec("UPDATE ships SET t = 1050 WHERE id = 3");
  EXPECT_EQ(db.rows("SELECT now, early FROM predictive_watches"), "1050.0|3");
}

/// Zones are always there: they say nothing about the time, however many they are.
TEST_F(WatchAhead, ZonesWithoutATimeDoNotHoldTheClock) {
  db.exec(
      "CREATE VIRTUAL TABLE zones USING moving_objects(id, x, y, r);"
      "INSERT INTO zones VALUES (1, 9, 0, 5), (2, 900, 0, 5), (3, 950, 0, 5), (4, 990, 0, 5)");
  const std::string watch = " USING predictive_watch(ships, other = zones, horizon = 100, ahead = 60)";
  db.exec("UPDATE ships SET t = 1000; CREATE VIRTUAL TABLE entries" + watch);
  EXPECT_EQ(db.rows("SELECT now, early FROM predictive_watches WHERE name = 'entries'"), "1000.0|0");
  db.exec("DROP TABLE entries; DELETE FROM ships; CREATE VIRTUAL TABLE entries" + watch +
          "; INSERT INTO ships VALUES (1, 1000, 0, 0, 1, 0, 1)");
  EXPECT_EQ(db.rows("SELECT now, pairs, fault FROM predictive_watches WHERE name = 'entries'"),
            "1000.0|1|NULL");
  db.exec("UPDATE zones SET x = x + 1; UPDATE ships SET t = 1030");
  EXPECT_EQ(db.rows("SELECT now, pairs FROM predictive_watches WHERE name = 'entries'"), "1030.0|1");
}

// Each of two fast clocks takes the clock with it, by less than `ahead`: then all other ships are late.
TEST_F(WatchAhead, AFewFastClocksDoNotTakeItFar) {
  make_fleet(40);
  for (int round = 1; round <= 30; ++round)
    for (int id = 1; id <= 40; ++id) {
      const double fast = id <= 2 ? 50.0 * id : id <= 5 ? 3e9 + id : 0;
      report(id, round * 10 + fast);
      ASSERT_LE(now(), round * 10 + 100) << "ship " << id;
    }
  EXPECT_GE(now(), 300);
}

// The others do not come back after the pause.
TEST_F(WatchAhead, ItFollowsFewerShipsAfterAPause) {
  make_fleet(40);
  for (int round = 0; round < 8; ++round)
    for (int id = 1; id <= 10; ++id) report(id, 5000 + round * 10);
  EXPECT_EQ(now(), 5070);
  for (int round = 0; round < 50; ++round) report(1, 9000 + round);
  EXPECT_GE(now(), 9047) << "a ship alone";
}

// Ships at anchor report every three minutes, the boat every two seconds.
TEST_F(WatchAhead, AFastClockThatReportsOftenDoesNotOutweighTheOthers) {
  make_fleet(21);
  for (int s = 1; s <= 1200; ++s) {
    if (s % 9 == 0) report(1 + s / 9 % 20, s);
    if (s % 2 == 0) report(21, s < 600 ? s + 7200 : s * 1000.0);
    ASSERT_LE(now(), s);
  }
  EXPECT_EQ(now(), 1197);
}

// The t of a plan is its start, which may be planned for later, so the clock does not follow.
TEST_F(WatchAhead, AClockThatStandsInATableWithPlansIsAFault) {
  db.exec(
      "CREATE VIRTUAL TABLE ferries USING moving_objects(id, t, x, y, plan);"
      "INSERT INTO ferries(id, t, x, y) VALUES (1, 0, 0, 0), (2, 0, 9, 0);"
      "CREATE VIRTUAL TABLE alerts USING predictive_watch(ferries, horizon = 100, ahead = 60)");
  const auto report = [this](int t) { db.exec("UPDATE ferries SET t = " + std::to_string(t)); };
  report(30);
  const std::string state = "SELECT now, fault FROM predictive_watches";
  EXPECT_EQ(db.rows(state), "30.0|NULL");
  for (int i = 0; i < 10; ++i) report(9000 + i);
  EXPECT_EQ(db.rows(state),
            "30.0|its clock stands at 30, and reports are later by more than ahead: INSERT INTO "
            "alerts(alerts, now) "
            "VALUES('advance', ...) with the present time");
  db.exec("INSERT INTO alerts(alerts, now) VALUES('advance', 9009)");
  report(9010);
  EXPECT_EQ(db.rows(state), "9010.0|NULL");
}

TEST_F(WatchAhead, OneWrongTimeMovesNothing) {
  make_fleet(3);
  for (int round = 1; round < 30; ++round) {
    report(1 + round % 3, round == 10 ? 1.7e12 : round * 40);
    ASSERT_LE(now(), round * 40) << round;
  }
}

}  // namespace
}  // namespace foresee
