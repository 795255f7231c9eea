// Latitude and longitude in SQL: NULL inputs, errors, and round trips of a report.
#include "sqlite/database.h"

namespace foresee::testing {
namespace {

struct GeoFunctions : ::testing::Test {
  Database db;
};

TEST_F(GeoFunctions, PutReportsOnAPlane) {
  EXPECT_EQ(db.rows("SELECT x, y, vx, vy FROM geo_to_plane(30, -90.5, 10, 90, 30, -90.5)"),
            "0.0|0.0|10.0|0.0");
  // GeodSolve: 44475.695532 m at 59.9994962296 degrees.
  EXPECT_EQ(db.rows("SELECT round(x, 3), round(y, 3), round(vx, 6), round(vy, 6) "
                    "FROM geo_to_plane(30.2, -90.1, 10, 30, 30, -90.5)"),
            "38516.887|22238.186|4.969627|8.677742");
}

TEST_F(GeoFunctions, LeadBackToTheReport) {
  EXPECT_EQ(db.rows("SELECT round(g.lat, 9), round(g.lon, 9), round(g.speed, 9), round(g.course, 7) "
                    "FROM geo_to_plane(30.2, -90.1, 10, 30, 30, -90.5) p, "
                    "plane_to_geo(p.x, p.y, p.vx, p.vy, 30, -90.5) g"),
            "30.2|-90.1|10.0|30.0");
  EXPECT_EQ(
      db.rows("SELECT round(g.lat, 9), round(g.lon, 9), round(g.height, 6), round(g.speed, 9), "
              "round(g.course, 7), round(g.climb, 7) FROM geo_to_globe(47.3, 179.9, 9000, 240, 355, -3) p, "
              "globe_to_geo(p.x, p.y, p.z, p.vx, p.vy, p.vz) g"),
      "47.3|179.9|9000.0|240.0|355.0|-3.0");
}

TEST_F(GeoFunctions, MeasureDistances) {
  EXPECT_EQ(db.rows("SELECT round(geo_distance(40.6, -73.8, 51.6, -0.5), 6)"), "5551759.400319");
  EXPECT_EQ(db.rows("SELECT geo_distance(1, 2, 3, NULL) IS NULL, geo_distance(1, 179, 1, -181)"), "1|0.0");
  EXPECT_EQ(db.error_of("SELECT geo_distance(1, 2, 91, 4)"),
            "geo_distance: lat2 is 91: latitudes lie between -90 and 90; write NULL if it is unknown, as "
            "nullif(lat, 91) does for AIS");
  EXPECT_EQ(db.error_of("SELECT geo_distance(1, 'east', 3, 4)"),
            "geo_distance: lon1 must be a number of degrees, not 'east'");
}

TEST_F(GeoFunctions, APositionThatIsNullGivesOneRowOfNulls) {
  for (const char* call : {"geo_to_plane(NULL, 2, 3, 4, 5, 6)", "geo_to_plane(1, NULL, 3, 4, 5, 6)",
                           "plane_to_geo(NULL, 2, 3, 4, 5, 6)", "geo_to_globe(NULL, 2, 3, 4, 5, 6)",
                           "globe_to_geo(1, 2, NULL, 4, 5, 6)"})
    EXPECT_EQ(db.rows(std::string("SELECT count(*), count(c1), count(c2), count(c3) FROM (SELECT ") +
                      (std::string(call).starts_with("geo_to") ? "x AS c1, y AS c2, vx AS c3"
                                                               : "lat AS c1, lon AS c2, speed AS c3") +
                      " FROM " + call + ")"),
              "1|0|0|0")
        << call;
}

TEST_F(GeoFunctions, ASpeedOrCourseThatIsNullGivesAPositionWithoutVelocity) {
  for (const char* rest : {"NULL, 4", "3, NULL", "NULL, NULL"}) {
    EXPECT_EQ(
        db.rows(std::string("SELECT x IS NULL, y IS NULL, vx IS NULL, vy IS NULL FROM geo_to_plane(1, 2, ") +
                rest + ", 5, 6)"),
        "0|0|1|1");
    EXPECT_EQ(db.rows(std::string("SELECT x IS NULL, vx IS NULL, az IS NULL FROM geo_to_globe(1, 2, 0, ") +
                      rest + ", 0)"),
              "0|1|1");
  }
  EXPECT_EQ(db.rows("SELECT lat IS NULL, speed IS NULL FROM plane_to_geo(10, 20, NULL, 4, 5, 6)"), "0|1");
  EXPECT_EQ(db.rows("SELECT speed, course IS NULL FROM plane_to_geo(10, 20, 0, 0, 5, 6)"), "0.0|1");
}

TEST_F(GeoFunctions, PutNullHeightsAndClimbsAtSeaLevel) {
  EXPECT_EQ(db.rows("SELECT x, vz FROM geo_to_globe(0, 0, NULL, 1, 0, NULL)"), "6378137.0|1.0");
}

TEST_F(GeoFunctions, SayWhatIsWrong) {
  EXPECT_EQ(db.error_of("SELECT * FROM geo_to_plane(91, 181, 3, 4, 5, 6)"),
            "geo_to_plane: in_lat is 91: latitudes lie between -90 and 90; write NULL if it is unknown, as "
            "nullif(lat, 91) does for AIS");
  EXPECT_EQ(db.error_of("SELECT * FROM geo_to_plane(1, 2, 3, 4, NULL, 6)"),
            "geo_to_plane: lat0 is missing or NULL: write geo_to_plane(in_lat, in_lon, in_speed, in_course, "
            "lat0, lon0)");
  EXPECT_EQ(db.error_of("SELECT * FROM geo_to_plane(1, 2, 3, 4, 5)"),
            "geo_to_plane: lon0 is missing or NULL: write geo_to_plane(in_lat, in_lon, in_speed, in_course, "
            "lat0, lon0)");
  EXPECT_EQ(db.error_of("SELECT * FROM geo_to_plane('30 N', 2, 3, 4, 5, 6)"),
            "geo_to_plane: in_lat must be a number, not '30 N': write geo_to_plane(in_lat, in_lon, in_speed, "
            "in_course, lat0, ...)");
  EXPECT_EQ(db.error_of("SELECT * FROM geo_to_plane(1, 2, 9e999, 4, 5, 6)"),
            "geo_to_plane: in_speed is infinite");
  EXPECT_EQ(db.error_of("SELECT * FROM plane_to_geo(3e7, 0, 0, 0, 5, 6)"),
            "plane_to_geo: x, y are 30000000 m from the origin: the farthest place is at 20003931 m");
  EXPECT_EQ(db.error_of("SELECT * FROM globe_to_geo(1, 2, 3, 4, 5, 6)"),
            "globe_to_geo: x, y, z are 3.7416573867739413 m from the centre of the Earth, closer than 100 "
            "km: write "
            "metres, not degrees");
}

TEST_F(GeoFunctions, LeadBackFromAPlaneAboutAPole) {
  for (const char* pole : {"90, 0", "90, 100", "-90, 0", "-90, -180"})
    EXPECT_EQ(
        db.rows(std::string("SELECT round(g.lat, 9), round(g.lon, 9), round(g.speed, 9), round(g.course, 7) "
                            "FROM geo_to_plane(80, 120, 5, 90, ") +
                pole + ") p, plane_to_geo(p.x, p.y, p.vx, p.vy, " + pole + ") g"),
        "80.0|120.0|5.0|90.0")
        << pole;
  EXPECT_EQ(db.rows("SELECT lat, lon FROM plane_to_geo(0, 0, 0, 0, 90, 12)"), "90.0|12.0");
  EXPECT_EQ(db.rows("SELECT round(g.lat, 9) FROM geo_to_plane(-90, 0, 5, NULL, 90, 0) p, "
                    "plane_to_geo(p.x, p.y, NULL, NULL, 90, 0) g"),
            "-90.0");
}

TEST_F(GeoFunctions, GiveCoursesBelow360) {
  EXPECT_EQ(db.rows("SELECT course FROM plane_to_geo(-1e-10, 100, 0, 1, 54, 8)"), "0.0");
  // Ships due north anywhere around the origin: 158 of 2,000 came back with 360.
  db.exec(
      "CREATE TABLE north AS WITH RECURSIVE n(i) AS (SELECT 0 UNION ALL SELECT i + 1 FROM n WHERE i < 1999) "
      "SELECT g.course FROM n, geo_to_plane(53 + i % 50 * 0.04, 7 + i / 50 * 0.05, 7.2, 0, 54, 8) p, "
      "plane_to_geo(p.x, p.y, p.vx, p.vy, 54, 8) g");
  EXPECT_EQ(
      db.rows("SELECT count(*), sum(course >= 0 AND course < 360), sum(min(course, 360 - course) < 1e-9) "
              "FROM north"),
      "2000|2000|2000");
}

TEST_F(GeoFunctions, NameASpeedThatIsTooLargeForTheirResult) {
  EXPECT_EQ(
      db.error_of("SELECT * FROM geo_to_plane(10, 170, 1.79e308, 0, 0, 0)"),
      "geo_to_plane: speed is 1.79e+308: on the plane that is more than a double holds; write metres per "
      "second, or NULL");
  EXPECT_EQ(db.rows("SELECT vx, vy FROM geo_to_plane(0, 0, 1.79e308, 90, 0, 0)"), "1.79e+308|0.0");
  EXPECT_EQ(
      db.error_of("SELECT * FROM plane_to_geo(0, 0, 1.5e308, 1.5e308, 0, 0)"),
      "plane_to_geo: vx, vy are 1.5e+308, 1.5e+308: their speed is more than a double holds; write metres "
      "per second, or NULL");
  EXPECT_EQ(db.error_of("SELECT * FROM geo_to_globe(0, 0, 0, 1e160, 90, 0)"),
            "geo_to_globe: speed, climb are 1e+160, 0: velocity or acceleration is more than a double holds; "
            "write metres per second, or NULL");
  EXPECT_EQ(
      db.error_of("SELECT * FROM geo_to_globe(0, 0, -6378137, 5, 90, 0)"),
      "geo_to_globe: height is -6378137 m: the centre of the Earth is 6.4e6 m down; write metres above the "
      "ellipsoid, or NULL");
}

/// The unqualified columns of a table are inputs: no input of a function has such a name.
TEST_F(GeoFunctions, TakeColumnsOfATableByTheirPlainNames) {
  db.exec(
      "CREATE TABLE reports(id INTEGER PRIMARY KEY, lat, lon, height, speed, course, climb);"
      "INSERT INTO reports VALUES(1, 54, 8, 0, 5, 90, 0);"
      "CREATE TABLE points(id INTEGER PRIMARY KEY, x, y, z, vx, vy, vz);"
      "INSERT INTO points VALUES(1, 6378137, 0, 0, 0, 5, 0)");
  EXPECT_EQ(db.rows("SELECT x, y, vx, vy FROM reports, geo_to_plane(lat, lon, speed, course, 54, 8)"),
            "0.0|0.0|5.0|0.0");
  EXPECT_EQ(db.rows("SELECT round(vx) FROM reports, geo_to_globe(lat, lon, height, speed, course, climb)"),
            "-1.0");
  EXPECT_EQ(db.rows("SELECT lat, lon, speed, course FROM points, globe_to_geo(x, y, z, vx, vy, vz)"),
            "0.0|0.0|5.0|90.0");
  EXPECT_EQ(db.rows("SELECT lat > 0 FROM points, plane_to_geo(x, y, vx, vy, 54, 8)"), "1");
}

TEST_F(GeoFunctions, TakeInputsByName) {
  EXPECT_EQ(db.rows("SELECT x, y, vx, vy FROM geo_to_plane WHERE in_lat = 54 AND in_lon = 8 AND lat0 = 54 "
                    "AND lon0 = 8 AND in_speed = 5 AND in_course = 90"),
            "0.0|0.0|5.0|0.0");
  EXPECT_EQ(
      db.rows("SELECT lat, lon FROM plane_to_geo WHERE in_x = 0 AND in_y = 0 AND lat0 = 54 AND lon0 = 8"),
      "54.0|8.0");
  EXPECT_EQ(db.rows("SELECT x FROM geo_to_globe WHERE in_lat = 0 AND in_lon = 0"), "6378137.0");
  EXPECT_EQ(db.rows("SELECT lat FROM globe_to_geo WHERE in_x = 6378137 AND in_y = 0 AND in_z = 0"), "0.0");
}

TEST_F(GeoFunctions, JoinToReportsOfWhichSomeHaveNoPosition) {
  db.exec(
      "CREATE TABLE reports(id INTEGER PRIMARY KEY, lat REAL, lon REAL, speed REAL, course REAL);"
      "INSERT INTO reports VALUES(1, 54, 8, 5, 90), (2, NULL, NULL, 5, 90), (3, 54.1, 8.1, NULL, 0);"
      "CREATE VIRTUAL TABLE ships USING moving_objects(id, x, y, vx, vy);"
      "INSERT INTO ships SELECT id, x, y, vx, vy FROM reports r, "
      "geo_to_plane(r.lat, r.lon, r.speed, r.course, 54, 8) WHERE x IS NOT NULL");
  EXPECT_EQ(db.rows("SELECT id, round(x), round(y), vx, vy FROM ships"),
            "1|0.0|0.0|5.0|0.0\n3|6542.0|11135.0|0.0|0.0");
  EXPECT_EQ(
      db.rows("SELECT count(*) FROM reports r, geo_to_plane(r.lat, r.lon, 1, 2, 54, 8) p WHERE p.x < 10"),
      "1");
}

}  // namespace
}  // namespace foresee::testing
