// predictive_avoid in SQL: changes written back keep clear, a second table, errors, and NULL for columns that
// the table does not have.
#include "sqlite/database.h"

namespace foresee::testing {
namespace {

struct AvoidInSql : ::testing::Test {
  AvoidInSql() {
    db.exec(
        "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy, r, +name);"
        "INSERT INTO ships VALUES (1, 0, 0, 0, 0, 10, 10, 'Ada'), (2, 0, 0, 1000, 0, -10, 10, 'Bob'),"
        "  (3, 0, 500, 500, -8, 0, 10, 'Eve'), (4, 0, 9000, 9000, 1, 1, 10, 'Far')");
  }
  std::string error(const std::string& call) { return db.error_of("SELECT * FROM " + call); }

  Database db;
};

TEST_F(AvoidInSql, TilesTheRange) {
  EXPECT_EQ(db.rows("SELECT manoeuvre, clear, round(k_from, 6), round(k_to, 6), round(k, 6), below, above "
                    "FROM predictive_avoid(60, 'ships', 1, 50)"),
            "turn|1|-180.0|-8.027974|-8.027974|NULL|2\n"
            "turn|0|-8.027974|20.22329|0.0|2|3\n"
            "turn|1|20.22329|180.0|20.22329|3|NULL\n"
            "speed|1|-10.0|-4.5|-4.5|NULL|2\n"
            "speed|0|-4.5|10.0|0.0|2|2");
  EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_avoid(60, 'ships', 1, 50) WHERE clear = 1"), "3");
}

TEST_F(AvoidInSql, KeepsClearOnceItIsWrittenBack) {
  const std::string write =
      "UPDATE ships SET (t, x, y, vx, vy) = (SELECT t, x, y, vx, vy FROM predictive_avoid(60, 'ships', 1, "
      "50, ";
  EXPECT_EQ(db.rows("SELECT a, b FROM predictive_join(60, 'ships', 50) WHERE a = 1 ORDER BY b"), "1|2");
  db.exec(write + "'turn') WHERE clear ORDER BY abs(k) LIMIT 1) WHERE id = 1");
  EXPECT_EQ(db.rows("SELECT a, b FROM predictive_join(60, 'ships', 50) WHERE a = 1 OR b = 1"), "");
  EXPECT_EQ(db.rows("SELECT round(sqrt(vx * vx + vy * vy), 9), name FROM ships WHERE id = 1"), "10.0|Ada");
}

TEST_F(AvoidInSql, ChangesNothingWhereNothingIsClear) {
  EXPECT_EQ(
      db.error_of("UPDATE ships SET (t, x, y, vx, vy) = (SELECT t, x, y, vx, vy FROM predictive_avoid(60, "
                  "'ships', 1, 50, 'turn', 0, 1) WHERE clear ORDER BY abs(k) LIMIT 1) WHERE id = 1"),
      "ships.t of row 1 is NULL: a declared reference time is needed; write the time at which the position "
      "holds");
  EXPECT_EQ(db.rows("SELECT t, x, y, vx, vy FROM ships WHERE id = 1"), "0.0|0.0|0.0|0.0|10.0");
}

TEST_F(AvoidInSql, JoinsToAllPairs) {
  EXPECT_EQ(db.rows("SELECT j.a, j.b, m.manoeuvre, count(*) FROM predictive_join(60, 'ships', 50) j, "
                    "predictive_avoid(60, 'ships', j.a, 50) m WHERE j.dt > 0 AND m.clear GROUP BY 1, 2, 3"),
            "1|2|speed|1\n1|2|turn|2");
}

TEST_F(AvoidInSql, AvoidsASecondTableAsWell) {
  db.exec(
      "CREATE VIRTUAL TABLE shelves USING moving_objects(id, x, y, hx, hy);"
      "INSERT INTO shelves VALUES (1, -300, 300, 20, 20)");
  const std::string sql =
      "SELECT clear, round(k_from), round(k_to), below, below_tbl FROM predictive_avoid(60, "
      "'ships', 1, 50, 'turn', -90, 0, NULL, 'shelves')";
  EXPECT_EQ(db.rows(sql),
            "1|-90.0|-57.0|NULL|NULL\n0|-57.0|-33.0|1|shelves\n1|-33.0|-8.0|1|shelves\n0|-8.0|0.0|2|ships");
}

TEST_F(AvoidInSql, GivesBackTheStoredRowAtZero) {
  db.exec("UPDATE ships SET t = -0.7, x = 0.1, vx = 0.3 WHERE id = 4");
  EXPECT_EQ(db.rows("SELECT t, x, y, vx, vy, z, ax, fx, heading, until FROM predictive_avoid(9, 'ships', 4, "
                    "0, 'turn', -1, 1)"),
            "-0.7|0.1|9000.0|0.3|1.0|NULL|NULL|NULL|NULL|NULL");
  EXPECT_EQ(db.rows("SELECT t, x, y, vx, vy FROM predictive_avoid(9, 'ships', 4, 0, 'turn', 90, 90)"),
            "0.0|0.31|9000.7|1.0|-0.3");
}

TEST_F(AvoidInSql, ReturnsTheInputsThatItUses) {
  const std::string inputs = "SELECT DISTINCT h, tbl, within, now, touching, schema FROM ";
  EXPECT_EQ(db.rows(inputs + "predictive_avoid(60, NULL, 1)"), "60|ships|0.0|0.0|part|main");
}

TEST_F(AvoidInSql, ComputesNoPlanForOtherOutputs) {
  db.exec(
      "CREATE VIRTUAL TABLE hulls USING moving_objects(id, t, until, x, y, vx, vy, shape, heading, plan);"
      "INSERT INTO hulls(id, t, x, y, vy, shape) VALUES (1, 0, 0, 0, 9, 'POLYGON((0 0, 1 0, 0 1, 0 0))')");
  const std::string from = " FROM predictive_avoid(60, 'hulls', 1, 1, 'turn', -10, 10) WHERE resume = 5";
  EXPECT_EQ(db.rows("SELECT k_from, k_to, course, height, climb" + from), "-10.0|10.0|NULL|NULL|NULL");
  EXPECT_NE(db.error_of("SELECT plan" + from).find("a plan has one heading"), std::string::npos);
}

TEST_F(AvoidInSql, StopsExactlyAndDelays) {
  EXPECT_EQ(
      db.rows("SELECT vx, vy FROM predictive_avoid(60, 'ships', 4, 0, 'speed', NULL, NULL) WHERE k_from < 0"),
      "1.0|1.0");
  EXPECT_EQ(db.rows("SELECT vx, vy FROM predictive_avoid(60, 'ships', 1, 0, 'speed', -10, -10)"), "0.0|0.0");
  db.exec("INSERT INTO ships VALUES (5, 30, 0, -1000, 0, 20, 10, 'Kim')");
  EXPECT_EQ(db.rows("SELECT clear, t FROM predictive_avoid(60, 'ships', 5, 0, 'delay', 5, 5, 0)"), "1|35.0");
  EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_avoid(60, 'ships', 1, 0, 'delay', 5, 5, 0)"), "1");
  EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_avoid(60, 'ships', 1, 0, 'delay', 5, 5, 10)"), "0");
}

TEST_F(AvoidInSql, AnEarlierStartIsALaterOneOfAnEarlierReport) {
  db.exec("INSERT INTO ships VALUES (5, 32, -200, 250, 10, 0, 10, 'Kim')");
  const auto starts = [&](const std::string& t, const std::string& lo, const std::string& hi) {
    return db.rows("SELECT clear, round(k_from + " + t + ", 6), round(k_to + " + t +
                   ", 6), below, above FROM predictive_avoid(90, 'ships', 5, 0, 'delay', " + lo + ", " + hi +
                   ", 0)");
  };
  const std::string earlier = starts("32", "-30", "20");
  EXPECT_GE(std::count(earlier.begin(), earlier.end(), '\n'), 2) << earlier;
  db.exec("UPDATE ships SET t = 2 WHERE id = 5");
  EXPECT_EQ(earlier, starts("2", "0", "50"));
  EXPECT_EQ(db.rows("SELECT clear, t FROM predictive_avoid(90, 'ships', 5, 0, 'delay', -2, -2, 0)"), "1|0.0");
}

TEST_F(AvoidInSql, DoesNotDependOnTheOrderOfInsertion) {
  const std::string columns = "id, t, x, y, vx, vy, r";
  const std::string select =
      "SELECT manoeuvre, clear, k_from, k_to, vx, vy, below, t_below, above FROM predictive_avoid(60, '";
  db.exec("CREATE VIRTUAL TABLE one USING moving_objects(" + columns +
          ");"
          "CREATE VIRTUAL TABLE two USING moving_objects(" +
          columns +
          ");"
          "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 300) INSERT INTO one "
          "SELECT i, 0, i * 7919 % 2003, i * 104729 % 1999, i % 21 - 10, i * 13 % 21 - 10, 10 FROM n;"
          "INSERT INTO two SELECT * FROM one ORDER BY id * 31 % 307;"
          "DELETE FROM two WHERE id = 299; INSERT INTO two SELECT * FROM one WHERE id = 299");
  for (const char* id : {"1", "2", "3", "50", "299"})
    EXPECT_EQ(db.rows(select + "one', " + id + ", 20)"), db.rows(select + "two', " + id + ", 20)"));
}

TEST_F(AvoidInSql, IsInterrupted) {
  sqlite3_progress_handler(
      db.handle(), 1, [](void*) { return 1; }, nullptr);
  EXPECT_NE(db.error_of("SELECT * FROM predictive_avoid(60, 'ships', 1, 50)"), "");
  sqlite3_progress_handler(db.handle(), 0, nullptr, nullptr);
}

TEST_F(AvoidInSql, HasNoRowsForObjectsThatDoNotExist) {
  EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_avoid(60, 'ships', 99)"), "0");
  EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_avoid(60, 'ships', 1, 0, NULL, NULL, NULL, -100)"), "0");
}

TEST_F(AvoidInSql, SaysWhatToWrite) {
  const std::string name = "predictive_avoid", usage =
                                                   "write predictive_avoid(h, tbl, id, within, how, lo, hi, "
                                                   "now, also, within_z, touching, schema, resume)";
  EXPECT_EQ(error(name), name + ": h is missing or NULL: " + usage);
  EXPECT_EQ(error(name + "(60, 'ships')"), name + ": id is missing or NULL: " + usage);
  EXPECT_EQ(error(name + "(60, 'ships', 1.5)"), name + ": id must be a whole number, not 1.5");
  EXPECT_EQ(error(name + "(-1, 'ships', 1)"), name + ": h must be a finite number >= 0, not -1");
  EXPECT_EQ(error(name + "(60, 'ships', 1, -1)"), name + ": within must be a finite number >= 0, not -1");
  EXPECT_EQ(error(name + "(60, 'ships', 1, 0, 'jump')"),
            name + ": how must be 'turn', 'speed', 'climb', 'accelerate', 'delay' or 'wait', not 'jump'");
  EXPECT_EQ(error(name + "(60, 'ships', 1, 0, 'turn', 5)"),
            name + ": hi is missing: give lo and hi together, or leave out both");
  EXPECT_EQ(error(name + "(60, 'ships', 1, 0, NULL, 1, 5)"),
            name +
                ": lo and hi need one manoeuvre; write how = 'turn', 'speed', 'climb', 'accelerate', "
                "'delay' or 'wait'");
  EXPECT_EQ(error(name + "(60, 'ships', 1, 0, 'wait')"),
            name + ": 'wait' has no range of its own: give lo and hi, as in 'wait', 0, 600");
  EXPECT_EQ(error(name + "(60, 'ships', 1, 0, 'wait', -5, 60)"),
            name + ": a 'wait' is not less than 0; write lo = 0 or more, not -5");
  EXPECT_EQ(error(name + "(60, 'ships', 1, 0, 'turn') WHERE resume = 0"),
            name + ": resume must be greater than 0, not 0: write a time");
  EXPECT_EQ(error(name + "(60, 'ships', 1, 0, 'delay', 0, 1, 0) WHERE resume = 5"),
            name + ": resume ends a 'turn', 'speed' or 'climb', not 'delay': leave it out");
  EXPECT_EQ(error(name + "(60, 'ships', 1, 0, 'turn', 5, 1)"),
            name + ": lo must not be greater than hi: lo is 5, hi is 1");
  EXPECT_EQ(error(name + "(60, 'ships', 1, 0, 'turn', -9e999, 1)"),
            name + ": lo must be a finite number, not -inf");
  EXPECT_EQ(error(name + "(60, 'ships', 1, 0, 'speed', -1.7e308, 1.7e308)"),
            name +
                ": hi - lo must be a finite number: lo is -1.7e+308, hi is 1.7e+308; write changes that the "
                "object can make, as in -10, 10");
  EXPECT_EQ(error(name + "(60, 'ships', 1, 0, 'turn', -361, 0)"),
            name + ": a turn is given in degrees from -360 to 360: lo is -361, hi is 0");
  EXPECT_EQ(error(name + "(60, 'ships', 1, 0, 'climb')"),
            name + ": 'climb' has no range of its own: give lo and hi, as in 'climb', -5, 5");
  EXPECT_EQ(error(name + "(60, 'ships', 1, 0, 'climb', -5, 5)"),
            name + ": 'climb' changes vz: ships has no z");
  EXPECT_EQ(error(name + "(60, 'ships', 1, 0, 'accelerate', -1, 1)"),
            name + ": 'accelerate' changes an acceleration or a force: declare ax … or fx … with m in ships");
  EXPECT_EQ(error(name + "(60, 'ships', 1, 0, 'delay', 0, 1)"),
            name + ": 'delay' needs now: nothing can start before it; write WHERE now = ...");
  EXPECT_EQ(
      error(name + "(60, 'ships', 1, 0, 'delay', -1, 1, 0)"),
      name +
          ": 'delay' cannot make an object start before now: lo must not be less than now - t, which is "
          "0; lo is -1");
  EXPECT_EQ(error(name + "(60, 'ships', 1, 0, NULL, NULL, NULL, NULL, NULL, NULL, 'push')"),
            name + ": touching must be 'part' or 'ignore', not 'push'");
  EXPECT_EQ(error(name + "(60, 'ships', 1, 0, NULL, NULL, NULL, NULL, NULL, 5)"),
            name + ": within_z is for tables with x, y and z; leave it out here (within covers every axis)");
}

TEST_F(AvoidInSql, RefusesWhatATableCannotHold) {
  db.exec("CREATE VIRTUAL TABLE trains USING moving_objects(id, x, vx)");
  const std::string name = "predictive_avoid: ";
  EXPECT_EQ(error("predictive_avoid(60, 'trains', 1, 0, 'turn')"),
            name + "a turn needs x and y: trains has one axis; write 'speed'");
  EXPECT_EQ(error("predictive_avoid(60, 'trains', 1, 0, NULL, NULL, NULL, 5)"),
            name +
                "now must be 0 in a table without t: write now = 0, or declare t in trains; a change from 5 "
                "on cannot be stored there");
  EXPECT_EQ(error("predictive_avoid(60, 'trains', 1, 0, 'delay', 0, 1, 0)"),
            name + "'delay' changes t: declare t in trains");
  db.exec(
      "CREATE VIRTUAL TABLE parcels USING moving_objects(id, t, x, y, r, growth);"
      "INSERT INTO parcels VALUES (1, 9, 0, 0, 1, 0.5)");
  EXPECT_EQ(error("predictive_avoid(60, 'parcels', 1, 0, 'delay', -1, 1, 0)"),
            name + "'delay' with lo = -1 is not supported for objects that grow; write lo >= 0 for parcels");
}

TEST_F(AvoidInSql, ClearsNothingWhereSpeedsHaveNoSquares) {
  db.exec(
      "CREATE VIRTUAL TABLE snails USING moving_objects(id, t, x, y, vx, vy);"
      "INSERT INTO snails VALUES (1, 0, 0, 0, 1e-180, 0), (2, 0, 1e-179, 0, 0, 0)");
  EXPECT_EQ(db.rows("SELECT a, b FROM predictive_join(100, 'snails')"), "1|2");
  EXPECT_EQ(db.rows("SELECT clear FROM predictive_avoid(100, 'snails', 1, 0, 'turn', 0, 0)"), "0");
  EXPECT_EQ(db.rows("SELECT clear, k_from, k_to FROM predictive_avoid(100, 'snails', 1, 0, 'turn', -1, 1)"),
            "0|-1.0|1.0");
}

TEST_F(AvoidInSql, RefusesTheDefaultRangeOfASpeedThatCannotBeDoubled) {
  db.exec("UPDATE ships SET vx = 1e308, vy = 0 WHERE id = 4");
  EXPECT_EQ(error("predictive_avoid(60, 'ships', 4, 0, 'speed')"),
            "predictive_avoid: hi - lo must be a finite number: lo is -1e+308, hi is 1e+308; write changes "
            "that the object can make, as in -10, 10");
  EXPECT_EQ(db.rows("SELECT count(*) FROM predictive_avoid(60, 'ships', 4, 0, 'speed', -1, 1)"), "1");
}

struct NearTouching : AvoidInSql {
  /// Rows with ends to six decimals, and the objects named there.
  std::string rows_of(const std::string& call) {
    return db.rows("SELECT clear, round(k_from, 6), round(k_to, 6), below, above FROM predictive_avoid(" +
                   call + ") WHERE k_to - k_from > 1e-6 OR clear = 0 AND k_from = k_to");
  }
};

TEST_F(NearTouching, EveryTurnAwayIsClearBesideANearContact) {
  db.exec(
      "CREATE VIRTUAL TABLE beside USING moving_objects(id, t, x, y, vx, vy, r);"
      "INSERT INTO beside VALUES (1, 0, 0, 0, 8, 0, 5), (2, 0, 0, 10.00000000000090949470177, 8, 0, 5)");
  EXPECT_EQ(rows_of("100, 'beside', 1, 0, 'turn', -60, 90"), "0|-60.0|0.0|2|2\n1|0.0|90.0|NULL|NULL");
  EXPECT_EQ(rows_of("100, 'beside', 1, 0, 'turn', -90, 180"), "0|-90.0|0.0|2|2\n1|0.0|180.0|NULL|NULL");
}

TEST_F(NearTouching, EveryDelayIsClearOfAnObjectAtRestJustBesideTheStart) {
  db.exec(
      "CREATE VIRTUAL TABLE starts USING moving_objects(id, t, x, y, vx, vy, r);"
      "INSERT INTO starts VALUES (1, 0, 0, 0, -4, 0, 5), (2, 16, 10.00000000000090949470177, 0, 0, 0, 5)");
  EXPECT_EQ(rows_of("100, 'starts', 1, 0, 'delay', 0, 20, 0"), "1|0.0|20.0|NULL|NULL");
  // Another object that touches the start, and moves on.
  db.exec(
      "UPDATE starts SET t = 0, x = -10, vx = -8 WHERE id = 2; UPDATE starts SET vx = 0, vy = 3 WHERE id = "
      "1");
  EXPECT_EQ(rows_of("100, 'starts', 1, 0, 'delay', 0, 20, 0"), "1|0.0|20.0|NULL|NULL");
}

TEST_F(NearTouching, TurnsAtWhichTheDistanceOnlyGrowsAreClearOnBentPathsToo) {
  db.exec(
      "CREATE VIRTUAL TABLE bent USING moving_objects(id, t, x, y, vx, vy, ax, ay, r);"
      "INSERT INTO bent VALUES (1, 0, 0, 0, 8, 0, 0, 0, 5), (2, 0, 0, 9, 0, 0, 0, 0.1, 5)");
  EXPECT_EQ(rows_of("100, 'bent', 1, 0, 'turn'"), "0|-180.0|0.0|2|2\n1|0.0|180.0|NULL|NULL");
  EXPECT_EQ(rows_of("100, 'bent', 1, 0, 'turn', -90, -45"), "0|-90.0|-45.0|2|2");
}

TEST_F(NearTouching, WallsWithoutThicknessEndWhereTheyEnd) {
  db.exec(
      "CREATE VIRTUAL TABLE points USING moving_objects(id, t, x, y, vx, vy);"
      "CREATE VIRTUAL TABLE walls USING moving_objects(id, x, y, hx, hy);"
      "INSERT INTO points VALUES (1, 0, 0, 0, 1, 0);"
      "INSERT INTO walls VALUES (1, 10, 0, 0, 5)");
  EXPECT_EQ(rows_of("60, 'points', 1, 0, 'turn', -90, 90, 0, 'walls'"),  // atan(1/2)
            "1|-90.0|-26.565051|NULL|1\n0|-26.565051|26.565051|1|1\n1|26.565051|90.0|1|NULL");
}

TEST_F(AvoidInSql, EndsSoonWherePathsGrazeOrOverflow) {
  db.exec(
      "CREATE VIRTUAL TABLE boxes USING moving_objects(id, t, until, x, y, vx, vy, ax, ay, hx, hy);"
      "INSERT INTO boxes VALUES (1, 100, 140, 175, -25, 6.25, 5, -.25, -.125, 3.75, 0),"
      "  (2, 107, 140, 175, 175, 2.5, -2.5, 0, -.4375, 0, 0),"
      "  (3, 100, NULL, 100, -125, 2.5, 10, 0, .1875, 3.75, 13.125),"
      "  (4, 79.7, 110.73250394298645, -150, -25, -7.5, 8.75, .4375, -.4375, 1.875, 1.875),"
      "  (5, 107, 140, 200, 175, -6.25, 6.25, .1875, .1875, 7.5, 7.5),"
      "  (6, 79.7, 140, 125, 0, 2.5, -1.25, -.1875, 0, 1.875, 7.5);"
      "CREATE VIRTUAL TABLE far USING moving_objects(id, t, x, y, vx, vy, ax, ay, r);"
      "INSERT INTO far VALUES (4, 0, 0, 1000, 10, 0, 0, 0, 1),"
      "  (3, 0, 1e300, 1e300, 1e300, -1e300, 1e300, 0, 1)");
  EXPECT_EQ(db.rows("SELECT clear, round(k_from, 6), round(k_to, 6) FROM "
                    "predictive_avoid(33.3, 'boxes', 1, 0, 'accelerate', -0.2, 1, 103) WHERE k_from > -0.15"),
            "0|-0.143258|-0.118711\n1|-0.118711|1.0");
  EXPECT_EQ(db.rows("SELECT clear, k_from, k_to FROM predictive_avoid(100, 'far', 4, 0, 'turn', -1, 1)"),
            "0|-1.0|0.0\n1|0.0|0.0\n0|0.0|1.0");
}

}  // namespace
}  // namespace foresee::testing
