// Tables of zones: a column `zone` in longitude and latitude, geofences by join and by watch, and what is refused.
#include <algorithm>

#include "sqlite/database.h"

namespace foresee::testing {
namespace {

constexpr const char* shoal = "POLYGON((7.8 53.85, 8 53.85, 7.95 53.95, 7.8 53.9, 7.8 53.85))";
constexpr const char* lock =
    "MULTIPOLYGON(((7.6 53.8, 7.7 53.8, 7.7 53.9, 7.6 53.9, 7.6 53.8), (7.62 53.82, 7.68 53.82, 7.68 53.88, "
    "7.62 53.88, "
    "7.62 53.82)), ((8.05 53.9, 8.1 53.9, 8.05 54, 8.05 53.9)))";

struct ZoneColumns : ::testing::Test {
  ZoneColumns() {
    db.exec(
        "CREATE VIRTUAL TABLE zones USING moving_objects(id, zone, +name TEXT, origin = '53.9 7.9');"
        "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, lat, lon, speed, course, r, origin = '53.9 "
        "7.9', "
        "speed_unit = knots)");
    db.exec(std::string("INSERT INTO zones VALUES (1, '") + shoal + "', 'shoal'), (2, '" + lock +
            "', 'lock')");
  }
  void fill_ships() {
    db.exec(
        "WITH n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 400) INSERT INTO ships "
        "  SELECT i, i % 7 * 10.0, 53.75 + i * 37 % 397 / 1600.0, 7.5 + i * 53 % 391 / 600.0, "
        "    i * 7 % 25, i * 11 % 360, i % 5 * 20.0 FROM n");
  }
  std::string refusal(const std::string& columns) {
    return db.error_of("CREATE VIRTUAL TABLE z USING moving_objects(id, " + columns + ")");
  }

  Database db;
};

TEST_F(ZoneColumns, ReadBackTheirText) {
  EXPECT_EQ(db.rows("SELECT * FROM zones"), std::string("1|") + shoal + "|shoal\n2|" + lock + "|lock");
  db.exec("UPDATE zones SET zone = 'SRID=4326; polygon((7.80 5.39e1,8 53.9, 8 54 ,7.8 53.9))' WHERE id = 1");
  EXPECT_EQ(db.rows("SELECT zone FROM zones WHERE id = 1"), "POLYGON((7.8 53.9, 8 53.9, 8 54, 7.8 53.9))");
}

TEST_F(ZoneColumns, KeepTheirStoredBits) {
  const auto stored = [&] {
    return db.rows("SELECT number, data FROM zones_shape UNION ALL SELECT nodeno, data FROM zones_node");
  };
  const std::string before = stored();
  db.exec("UPDATE zones SET zone = zone; UPDATE zones SET name = name || '!'");
  db.exec(std::string("UPDATE zones SET zone = '") + lock + "' WHERE id = 2");
  db.exec("UPDATE zones SET (zone, name) = (SELECT zone, name FROM zones z WHERE z.id = zones.id)");
  EXPECT_EQ(stored(), before);
}

/// A zone of a table is the zone of a window: the same times, bit for bit.
TEST_F(ZoneColumns, JoinAsWindowsDo) {
  fill_ships();
  const std::string windows = db.rows(
      "SELECT w.id, z.id, w.t, w.t_end FROM zones z JOIN predictive_window w ON w.h = 600 AND w.tbl = "
      "'ships' AND "
      "w.zone = z.zone ORDER BY 1, 2");
  EXPECT_GT(std::count(windows.begin(), windows.end(), '\n'), 50);
  for (const char* method : {"auto", "grid", "tree", "scan"})
    EXPECT_EQ(
        db.rows(std::string("SELECT a, b, t, t_end FROM predictive_join(600, 'ships', 0, 'zones', NULL, '") +
                method + "') ORDER BY 1, 2"),
        windows)
        << method;
  EXPECT_EQ(db.rows("SELECT b, a, t, t_end FROM predictive_join(600, 'zones', 0, 'ships') ORDER BY 1, 2"),
            windows);
}

/// Beside outlines of a plain table, whose corners went through geo_to_plane.
TEST_F(ZoneColumns, JoinAsPlainOutlinesDo) {
  fill_ships();
  db.exec(
      "CREATE VIRTUAL TABLE plain USING moving_objects(id, t, x, y, vx, vy, r);"
      "INSERT INTO plain SELECT id, t, x, y, vx, vy, r FROM ships;"
      "CREATE VIRTUAL TABLE outlines USING moving_objects(id, x, y, shape);"
      "INSERT INTO outlines SELECT 1, 0, 0, 'POLYGON((' || group_concat(printf('%!.17g %!.17g', x, y), ', ') "
      "|| '))' "
      "  FROM json_each('[[7.8,53.85],[8,53.85],[7.95,53.95],[7.8,53.9],[7.8,53.85]]') c, "
      "  geo_to_plane(c.value ->> 1, c.value ->> 0, NULL, NULL, 53.9, 7.9)");
  for (const char* within : {"0", "500"}) {
    const std::string plain = db.rows(std::string("SELECT * FROM predictive_join(600, 'plain', ") + within +
                                      ", 'outlines') ORDER BY a");
    EXPECT_GT(std::count(plain.begin(), plain.end(), '\n'), 50);
    EXPECT_EQ(db.rows(std::string("SELECT * FROM predictive_join(600, 'ships', ") + within +
                      ", 'zones') WHERE b = 1 ORDER BY a"),
              plain);
  }
}

TEST_F(ZoneColumns, AreWatched) {
  db.exec(
      "INSERT INTO ships VALUES (211, 0, 53.88, 7.72, 14, 90, 0), (244, 0, 53.98, 7.9, 10, 0, 0);"
      "CREATE VIRTUAL TABLE geofence USING predictive_watch(ships, horizon = 1800, other = zones, within = "
      "0)");
  const auto joined = [&] {
    return db.rows("SELECT a, b, t, t_end FROM predictive_join(1800, 'ships', 0, 'zones') ORDER BY a, b");
  };
  EXPECT_EQ(db.rows("SELECT a, b, round(t) FROM geofence"), "211|1|730.0");
  EXPECT_EQ(db.rows("SELECT a, b, t, t_end FROM geofence ORDER BY a, b"), joined());
  db.exec("UPDATE ships SET t = 60, course = 180 WHERE id = 244");
  EXPECT_EQ(db.rows("SELECT count(*) FROM geofence"), "2");
  EXPECT_EQ(db.rows("SELECT a, b, t, t_end FROM geofence ORDER BY a, b"), joined());
  EXPECT_EQ(db.rows("SELECT op, a, b FROM predictive_changes('geofence', 1)"), "+|244|1");
  db.exec("DELETE FROM zones WHERE id = 1");
  EXPECT_EQ(db.rows("SELECT count(*) FROM geofence"), "0");
  EXPECT_EQ(db.error_of("CREATE VIRTUAL TABLE bad USING moving_objects(id, zone, origin = '54 8');"
                        "SELECT * FROM predictive_join(60, 'ships', 0, 'bad')"),
            "predictive_join: ships has origin '53.9 7.9', bad has '54 8': their coordinates do not match; "
            "create bad "
            "with origin = "
            "'53.9 7.9'");
}

TEST_F(ZoneColumns, AreAirspacesWithHeights) {
  db.exec(
      "CREATE VIRTUAL TABLE drones USING moving_objects(id, lat, lon, z, speed, course, vz, origin = '53.9 "
      "7.9');"
      "INSERT INTO drones VALUES (1, 53.88, 7.79, 50, 10, 90, 0), (2, 53.88, 7.79, 500, 10, 90, 0);"
      "CREATE VIRTUAL TABLE airspaces USING moving_objects(id, zone, z, hz, origin = '53.9 7.9')");
  db.exec(std::string("INSERT INTO airspaces VALUES (1, '") + shoal + "', 60, 60)");
  EXPECT_EQ(db.rows("SELECT a, b, round(t) FROM predictive_join(600, 'drones', 0, 'airspaces')"), "1|1|66.0");
  EXPECT_EQ(db.rows("SELECT z, hz FROM airspaces"), "60.0|60.0");
}

TEST_F(ZoneColumns, OutliveTheConnection) {
  const TemporaryFile file;
  std::string before;
  {
    Database first(file.path());
    first.exec(
        "CREATE VIRTUAL TABLE zones USING moving_objects(id, zone, r, until, +name, origin = '53.9 7.9')");
    first.exec(std::string("INSERT INTO zones VALUES (5, '") + lock + "', 20, NULL, 'lock')");
    before = first.rows("SELECT * FROM zones");
    EXPECT_EQ(first.rows("SELECT value FROM zones_meta WHERE key IN ('columns', 'features') ORDER BY key"),
              "id, r, zone, until, +name\nblocks,shapes,degrees,zones");
  }
  Database second(file.path());
  EXPECT_EQ(second.rows("SELECT * FROM zones"), before);
  EXPECT_EQ(second.rows("PRAGMA integrity_check"), "ok");
  second.exec("INSERT INTO zones(zones) VALUES ('rebuild'); VACUUM");
  EXPECT_EQ(second.rows("SELECT * FROM zones"), before);
  second.exec("ALTER TABLE zones RENAME TO areas");
  EXPECT_EQ(second.rows("SELECT * FROM areas"), before);
}

TEST_F(ZoneColumns, AreAtTheOriginOfTheirTable) {
  EXPECT_EQ(
      db.rows("SELECT x, y, round(lat, 9), round(lon, 9) FROM predictive_position(0, 'zones') WHERE id = 1"),
      "0.0|0.0|53.9|7.9");
  EXPECT_EQ(db.error_of("SELECT x FROM zones"), "no such column: x");
}

TEST_F(ZoneColumns, RefuseWhatIsNoZone) {
  const auto error = [&](const std::string& value) {
    return db.error_of("INSERT INTO zones VALUES (9, " + value + ", 'x')");
  };
  EXPECT_EQ(error("7"),
            "zones.zone of row 9: 7 is no text: write well-known text as in 'POLYGON((7.8 53.9, 8 53.9, 7.9 "
            "54, 7.8 "
            "53.9))'");
  EXPECT_EQ(error("'POLYGON((53.85 7.8, 53.85 8, 53.95 7.9, 53.85 7.8))'"),
            "zones.zone of row 9: corner (53.85 7.8) is 6552 km from the origin '53.9 7.9'; write longitude "
            "first, and an "
            "origin within 1500 km");
  EXPECT_EQ(error("NULL"),
            "zones.zone of row 9: NULL is no place: write well-known text as in 'POLYGON((7.8 53.9, 8 53.9, "
            "7.9 54, "
            "7.8 53.9))', or leave the row out");
  EXPECT_EQ(db.error_of("UPDATE zones SET zone = '' WHERE id = 1"),
            "zones.zone of row 1: '' is no place: write well-known text as in 'POLYGON((7.8 53.9, 8 53.9, "
            "7.9 54, "
            "7.8 53.9))', or leave the row out");
  EXPECT_EQ(error("'POINT(7 53)'"),
            "zones.zone of row 9: at character 1: expected POLYGON or MULTIPOLYGON, found 'POINT'");
  EXPECT_EQ(db.rows("SELECT count(*) FROM zones"), "2");
  EXPECT_EQ(db.rows("SELECT count(*) FROM zones_shape"), "2");
}

TEST_F(ZoneColumns, RefuseOtherColumns) {
  EXPECT_EQ(refusal("zone"),
            "z: \"zone\": a table of zones needs the origin of the tables beside it; write for example "
            "origin = '53.9 "
            "7.9'");
  const std::string origin = ", origin = '53.9 7.9'";
  for (const char* column : {"lat", "x", "y"})
    EXPECT_EQ(refusal(std::string("zone, ") + column + origin),
              std::string("z: \"") + column + "\": the corners of a zone place it; leave " + column +
                  " out, or write shape in place of zone");
  for (const char* column : {"vx", "speed", "vz", "ax", "fx", "m"})
    EXPECT_EQ(refusal(std::string("zone, ") + column + origin),
              std::string("z: \"") + column + "\": a zone is at rest; leave " + column +
                  " out, or write lat, lon and shape in place of zone");
  for (const char* column : {"shape", "heading", "hx"})
    EXPECT_EQ(refusal(std::string("zone, ") + column + origin),
              std::string("z: \"") + column + "\": the corners of a zone are all of its shape; leave " +
                  column + " out");
  EXPECT_EQ(refusal("zone, z" + origin),
            "z: \"zone\": a zone with z is an upright prism; add hz, half of its height, or leave z out");
  EXPECT_EQ(refusal("zone, speed_unit = knots" + origin),
            "z: \"speed_unit = knots\": a zone has no speed; leave speed_unit out");
  EXPECT_EQ(refusal("zone, frame = 'f'" + origin),
            "z: \"frame = 'f'\": the frame of a table of zones is its origin; leave frame out");
  EXPECT_EQ(refusal("zone BLOB" + origin),
            "z: \"zone BLOB\": zone holds well-known text; write zone or zone TEXT");
}

}  // namespace
}  // namespace foresee::testing
