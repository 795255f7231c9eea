"""sql/import_ais.sql puts ships where they are, leaves out what is not available, and finds the real encounters."""
import csv
import math
import tempfile
import unittest
from pathlib import Path

from house import SHARED_DATA, main, shell

MAJOR, FLATTENING = 6378137.0, 1 / 298.257223563     # WGS84
MINOR = MAJOR * (1 - FLATTENING)
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


# Vincenty's formulas (Survey Review 23, 1975), right to half a millimetre: an independent look at what Karney's geodesics give.
def series(u2):
    a = 1 + u2 / 16384 * (4096 + u2 * (-768 + u2 * (320 - 175 * u2)))
    return a, u2 / 1024 * (256 + u2 * (-128 + u2 * (74 - 47 * u2)))


def correction(b, sin_s, cos_s, cos_2m):
    return b * sin_s * (cos_2m + b / 4 * (cos_s * (2 * cos_2m**2 - 1) - b / 6 * cos_2m * (4 * sin_s**2 - 3) * (4 * cos_2m**2 - 3)))


def longer(sin_a, sigma, sin_s, cos_s, cos_2m):
    """By how much the longitude on the auxiliary sphere is more."""
    cos2_a = 1 - sin_a**2
    c = FLATTENING / 16 * cos2_a * (4 + FLATTENING * (4 - 3 * cos2_a))
    return (1 - c) * FLATTENING * sin_a * (sigma + c * sin_s * (cos_2m + c * cos_s * (2 * cos_2m**2 - 1)))


def projected(lat, lon):
    """As far from CENTRE and in that direction."""
    if (lat, lon) == CENTRE:
        return 0.0, 0.0
    u1, u2 = (math.atan((1 - FLATTENING) * math.tan(math.radians(degrees))) for degrees in (CENTRE[0], lat))
    l = wanted = math.radians(lon - CENTRE[1])
    for _ in range(50):
        east = math.cos(u2) * math.sin(l)
        north = math.cos(u1) * math.sin(u2) - math.sin(u1) * math.cos(u2) * math.cos(l)
        sin_s, cos_s = math.hypot(east, north), math.sin(u1) * math.sin(u2) + math.cos(u1) * math.cos(u2) * math.cos(l)
        sigma, sin_a = math.atan2(sin_s, cos_s), math.cos(u1) * east / sin_s
        cos_2m = cos_s - 2 * math.sin(u1) * math.sin(u2) / (1 - sin_a**2)
        l = wanted + longer(sin_a, sigma, sin_s, cos_s, cos_2m)
    a, b = series((1 - sin_a**2) * (MAJOR**2 - MINOR**2) / MINOR**2)
    metres = MINOR * a * (sigma - correction(b, sin_s, cos_s, cos_2m))
    return metres * east / sin_s, metres * north / sin_s


def along_geodesic(lat, lon, course, metres):
    """Where a ship is after so many metres straight on."""
    u, c = math.atan((1 - FLATTENING) * math.tan(math.radians(lat))), math.radians(course)
    sin_a, start = math.cos(u) * math.sin(c), math.atan2(math.tan(u), math.cos(c))
    a, b = series((1 - sin_a**2) * (MAJOR**2 - MINOR**2) / MINOR**2)
    sigma = straight = metres / (MINOR * a)
    for _ in range(50):
        sin_s, cos_s, cos_2m = math.sin(sigma), math.cos(sigma), math.cos(2 * start + sigma)
        sigma = straight + correction(b, sin_s, cos_s, cos_2m)
    north = math.sin(u) * math.cos(sigma) + math.cos(u) * math.sin(sigma) * math.cos(c)
    across = math.hypot(sin_a, math.sin(u) * math.sin(sigma) - math.cos(u) * math.cos(sigma) * math.cos(c))
    l = math.atan2(math.sin(sigma) * math.sin(c), math.cos(u) * math.cos(sigma) - math.sin(u) * math.sin(sigma) * math.cos(c))
    l -= longer(sin_a, sigma, math.sin(sigma), math.cos(sigma), math.cos(2 * start + sigma))
    return math.degrees(math.atan2(north, (1 - FLATTENING) * across)), lon + math.degrees(l)


def velocity(lat, lon, sog, course):
    """By differences, 500 m ahead and behind."""
    ahead, behind = (projected(*along_geodesic(lat, lon, course, metres)) for metres in (500, -500))
    return tuple((a - b) / 1000 * sog * 1852 / 3600 for a, b in zip(ahead, behind))


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
                self.assertAlmostEqual(got, wanted, delta=1e-3)
            for got, wanted in zip((vx, vy), velocity(lat, lon, sog, cog)):
                self.assertAlmostEqual(got, wanted, delta=1e-5)

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
            # The known answers are of a sphere, whose distances are off by up to 0.6 %.
            f"""SELECT count(*), max(abs(s.x - e.x)) < 900, max(abs(s.y - e.y)) < 900, max(abs(s.vx - e.vx)) < 0.15,
                       max(abs(s.vy - e.vy)) < 0.15, max(abs(s.t - 1641168000 - e.t)) = 0
                  FROM ais_ships s JOIN expected e ON e.id = CAST(s.id AS TEXT);""",
            "SELECT count(*) FROM ais_ships;")
        pairs = int(rows[0][0])
        self.assertLessEqual(abs(pairs - 3993), 0.01 * 3993)
        self.assertEqual(rows[1:], [["1135", "1", "1", "1", "1", "1"], ["1135"]])


if __name__ == "__main__":
    main()
