"""sql/import_ais.sql puts ships where they are, leaves out what is not available, and finds the real encounters."""
import csv
import math
import tempfile
import unittest
from pathlib import Path

from house import SHARED_DATA, main, shell

RADIUS = 6371008.8
MOMENT = 1641168600  # 2022-01-03 00:10:00
CENTRE = (30.0, -90.5)

# mmsi, t - MOMENT, lat, lon, sog_kn, cog_deg
REPORTS = [
    (1, -100, 30.2, -90.1, 12.0, 30.0),
    (1, -10, 30.21, -90.09, 11.0, 215.5),   # the newest of ship 1
    (1, 5, 30.3, -90.0, 11.0, 215.5),       # after the moment
    (2, -20, 29.1, -91.3, 0.4, 360),        # slow: at rest, whatever its course
    (3, -20, 29.2, -91.3, 8.0, 360),        # no course
    (4, -20, 29.3, -91.3, 102.3, 90),       # no speed
    (5, -20, 91, 181, 5, 90),               # no position
    (6, -181, 30, -90, 5, 90),              # too old
    (7, -180, 30.0, -90.5, 20, 0),          # old enough, at the centre, northward
    (8, -20, 32.0, -90.5, 5, 90),           # 222 km away
    (9, -30, 29.9, -90.4, 7, 90),
    (9, -20, 29.9, -90.4, 102.3, 90),       # its newest report says nothing: the one before counts
    (10, -20, 29.9, -90.4, "", ""),         # nothing sent
]


def projected(lat, lon):
    """Stereographic projection about CENTRE, by the textbook formula."""
    p, l, p0 = math.radians(lat), math.radians(lon - CENTRE[1]), math.radians(CENTRE[0])
    k = 2 * RADIUS / (1 + math.sin(p0) * math.sin(p) + math.cos(p0) * math.cos(p) * math.cos(l))
    return (k * math.cos(p) * math.sin(l),
            k * (math.cos(p0) * math.sin(p) - math.sin(p0) * math.cos(p) * math.cos(l)))


def along_great_circle(lat, lon, course, metres):
    """Where a ship is after so many metres on its great circle."""
    p, c, d = math.radians(lat), math.radians(course), metres / RADIUS
    q = math.asin(math.sin(p) * math.cos(d) + math.cos(p) * math.sin(d) * math.cos(c))
    l = math.atan2(math.sin(c) * math.sin(d) * math.cos(p), math.cos(d) - math.sin(p) * math.sin(q))
    return math.degrees(q), lon + math.degrees(l)


def velocity(lat, lon, sog, course):
    """By differences, 1 m ahead and behind: an independent look at what the script derives."""
    ahead, behind = (projected(*along_great_circle(lat, lon, course, metres)) for metres in (1, -1))
    return tuple((a - b) / 2 * sog * 1852 / 3600 for a, b in zip(ahead, behind))


SET_PARAMETERS = f"""CREATE TABLE ais_parameters(name TEXT PRIMARY KEY, value REAL);
INSERT INTO ais_parameters VALUES ('moment', {MOMENT}), ('centre_lat', {CENTRE[0]}), ('centre_lon', {CENTRE[1]});"""


def import_and_ask(reports, *questions, parameters=SET_PARAMETERS):
    """The lines that `questions` print after `reports` (a path or what .import takes) were imported."""
    script = "\n".join([".load build/release/foresee", ".mode csv", f".import --csv \"{reports}\" ais_reports", parameters,
                        ".read sql/import_ais.sql", *questions, ""])
    status, output = shell(script, "-bail")
    if status:
        raise AssertionError(output)
    return list(csv.reader(output.splitlines()))


class MadeUpReports(unittest.TestCase):
    ALL = "SELECT id, t, printf('%!.17g,%!.17g,%!.17g,%!.17g', x, y, vx, vy) FROM ais_ships ORDER BY id;"

    def ships(self, *more, reports=REPORTS, parameters=SET_PARAMETERS):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "reports.csv"
            with path.open("w", newline="") as file:
                writer = csv.writer(file)
                writer.writerow(["mmsi", "t", "lat", "lon", "sog_kn", "cog_deg"])
                writer.writerows((mmsi, MOMENT + dt, *rest) for mmsi, dt, *rest in reports)
            rows = import_and_ask(path, *more, self.ALL, parameters=parameters)
        return {int(id): (float(t), *map(float, numbers.split(","))) for id, t, numbers in rows}

    def test_what_is_not_available_is_left_out(self):
        self.assertEqual(sorted(self.ships()), [1, 2, 7, 9])

    def test_positions_and_velocities_are_projected(self):
        ships = self.ships()
        for id, report in ((1, REPORTS[1]), (7, REPORTS[8]), (9, REPORTS[10])):
            t, x, y, vx, vy = ships[id]
            _, dt, lat, lon, sog, cog = report
            self.assertEqual(t, MOMENT + dt)
            for got, wanted in zip((x, y), projected(lat, lon)):
                self.assertAlmostEqual(got, wanted, delta=1e-6)
            for got, wanted in zip((vx, vy), velocity(lat, lon, sog, cog)):
                self.assertAlmostEqual(got, wanted, delta=1e-6)

    def test_slow_ships_lie_still(self):
        self.assertEqual(self.ships()[2][3:], (0, 0))

    def test_reading_the_script_again_makes_the_table_anew(self):
        again = self.ships("UPDATE ais_parameters SET value = value + 5 WHERE name = 'moment';", ".read sql/import_ais.sql")
        self.assertEqual(sorted(again), [1, 2, 9])
        self.assertEqual(again[1][0], MOMENT + 5)

    def test_without_parameters_the_reports_say_when_and_where(self):
        reports = [(1, 0, 30, -90, 10, 0), (2, -60, 30, -91, 10, 0), (3, -181, 30, -90.5, 10, 0)]
        ships = self.ships(reports=reports, parameters="")
        self.assertEqual(sorted(ships), [1, 2])  # the newest report is the moment: 3 was heard too long ago
        self.assertAlmostEqual(ships[1][1], -ships[2][1], delta=1e-6)  # the plane's centre is in the middle


class RealReports(unittest.TestCase):
    def test_the_encounters_on_the_lower_mississippi(self):
        reports, ships = SHARED_DATA / "ships_us_20220103.csv.gz", SHARED_DATA / "ships_mississippi.csv"
        if not reports.exists() or not ships.exists():
            self.skipTest(f"no AIS data in {SHARED_DATA}")
        rows = import_and_ask(
            f"|gzip -dc {reports}",
            f"SELECT count(*) FROM predictive_join(600, 'ais_ships', 926, NULL, {MOMENT});", ".mode csv",
            f".import --csv {ships} expected",
            f"""SELECT count(*), max(abs(s.x - e.x)) < 1e-6, max(abs(s.y - e.y)) < 1e-6, max(abs(s.vx - e.vx)) < 1e-6,
                       max(abs(s.vy - e.vy)) < 1e-6, max(abs(s.t - 1641168000 - e.t)) = 0
                  FROM ais_ships s JOIN expected e ON e.id = CAST(s.id AS TEXT);""",
            "SELECT count(*) FROM ais_ships;")
        pairs = int(rows[0][0])
        self.assertLessEqual(abs(pairs - 3993), 0.02 * 3993)
        self.assertEqual(rows[1:], [["1135", "1", "1", "1", "1", "1"], ["1135"]])


if __name__ == "__main__":
    main()
