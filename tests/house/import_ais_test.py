"""sql/import_ais.sql puts ships where they are, leaves out what is not available, and finds the real encounters."""
import csv
import math
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from house import ROOT, SHARED_DATA, main, shell

MAJOR, FLATTENING = 6378137.0, 1 / 298.257223563     # WGS84
MINOR = MAJOR * (1 - FLATTENING)
MOMENT = 1641168600  # 2022-01-03 00:10:00
CENTRE = (30.0, -90.5)
BUNDLED = ROOT / "sql/data/new_york_20220103.csv"

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


# The reports of other layouts: ship 1 under way, ship 2 at rest, and what does not count.
NOAA = """MMSI,BaseDateTime,LAT,LON,SOG,COG,Heading,VesselName,IMO,CallSign,VesselType,Status,Length,Width,Draft,Cargo,TransceiverClass
1,2022-01-03T00:08:20,30.2,-90.1,12.0,30.0,31,,,,70,0,180,32,,,A
1,2022-01-03T00:09:50,30.21,-90.09,11.0,215.5,215,ANNA,,,70,0,180,32,,,A
1,2022-01-03T00:09:55,,-90.09,11.0,215.5,215,ANNA,,,70,0,180,32,,,A
2,2022-01-03T00:09:40,29.1,-91.3,0.4,360.0,511,,,,,,,,,,B
3,2022-01-03T00:09:40,29.2,-91.3,102.3,10.0,511,,,,,,,,,,B
"""
NOAA_2025 = """mmsi,base_date_time,longitude,latitude,sog,cog,heading,vessel_name,imo,call_sign,vessel_type,status,length,width,draft,cargo,transceiver
1,2022-01-03 00:09:50,-90.09,30.21,11.0,215.5,215,ANNA,,,70,0,180,32,,,A
2,2022-01-03 00:09:40,-91.3,29.1,0.4,360.0,511,,,,,,,,,,B
"""
DMA = """# Timestamp,Type of mobile,MMSI,Latitude,Longitude,Navigational status,ROT,SOG,COG,Heading,IMO,Callsign,Name,Ship type
03/01/2022 00:09:50,Class A,1,30.210000,-90.090000,Under way using engine,0.0,11.0,215.5,215,Unknown,Unknown,ANNA,Cargo
03/01/2022 00:09:40,Class B,2,29.100000,-91.300000,Unknown value,,0.4,,,Unknown,Unknown,,Undefined
03/01/2022 00:09:40,Base Station,4,29.100000,-91.300000,Unknown value,,0.0,,,Unknown,Unknown,,Undefined
03/01/2022 00:09:40,Class A,5,29.100000,-91.300000,Unknown value,,,,,Unknown,Unknown,,Undefined
"""
OWN = """mmsi,t,lat,lon,sog_kn,cog_deg,name
1,1641168590,30.21,-90.09,11.0,215.5,ANNA
2,1641168580,29.1,-91.3,0.4,360,
"""


class Layouts(unittest.TestCase):
    def imported(self, text, *statements, fails=False):
        """(status, output) of the statements after `text` was imported."""
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "reports.csv"
            path.write_text(text)
            script = [".load build/release/foresee", ".mode csv", f".import --csv {path} ais_reports", SET_PARAMETERS, *statements, ""]
            status, output = shell("\n".join(script))
        if (status != 0) != fails:
            raise AssertionError(output)
        return output

    ALL = "SELECT id, t, name, printf('%!.17g,%!.17g,%!.17g,%!.17g', x, y, vx, vy) FROM ais_ships ORDER BY id;"

    def test_every_layout_gives_the_same_ships(self):
        wanted = self.imported(OWN, ".read sql/import_ais.sql", self.ALL)
        self.assertEqual([line.split(",")[:3] for line in wanted.splitlines()], [["1", "1641168590.0", "ANNA"], ["2", "1641168580.0", ""]])
        for name, text in (("NOAA", NOAA), ("NOAA from 2025 on", NOAA_2025), ("DMA", DMA)):
            with self.subTest(name):
                self.assertEqual(self.imported(text, ".read sql/import_ais.sql", self.ALL), wanted)

    def test_missing_columns_are_named_and_change_nothing(self):
        rest = {"mmsi": "ship", "BaseDateTime": "time", "LAT": "latitude", "LON": "longitude", "SOG": "speed", "COG": "course"}
        for column, quantity in rest.items():
            with self.subTest(column):
                text = re.sub(rf"\b{column}\b", "Renamed", NOAA, count=1, flags=re.I)
                output = self.imported(text, "CREATE VIRTUAL TABLE ais_ships USING moving_objects(id, t, x, y, vx, vy, +name TEXT);",
                                       "INSERT INTO ais_ships(id, t, x, y) VALUES (9, 0, 0, 0);", ".read sql/import_ais.sql",
                                       "SELECT id FROM ais_ships;", "SELECT count(*) FROM ais_parameters;", fails=True)
                self.assertIn(f"ais_reports has no column for the {quantity}: ", output)
                self.assertIn(f"ais_reports: no column for the {quantity}; .import a file with", output)
                self.assertEqual(output.splitlines()[-2:], ["9", "3"])

    def test_a_file_whose_middle_is_empty_says_which_parameters_to_set(self):
        far = OWN + "3,1641168590,45.0,-60.0,11.0,215.5,\n"
        output = self.imported(far, "DROP TABLE ais_parameters;", ".read sql/import_ais.sql")
        self.assertIn("no ship within 150 km of 34.77 -80.46 in the 180 s before 2022-01-03 00:09:50", output)
        self.assertIn("UPDATE ais_parameters SET value = … WHERE name = 'centre_lat', and so for centre_lon", output)

    def test_all_missing_columns_are_listed(self):
        output = self.imported(OWN.replace("lat,lon,", "north,east,"), ".read sql/import_ais.sql", fails=True)
        self.assertIn("latitude: lat or Latitude", output)
        self.assertIn("longitude: lon or Longitude", output)

    def test_without_reports_the_import_is_named(self):
        status, output = shell(".load build/release/foresee\n.read sql/import_ais.sql\n", "-bail")
        self.assertEqual(status, 1)
        self.assertIn("ais_reports: there is no such table; .import --csv FILE ais_reports first", output)
        _, output = shell(".load build/release/foresee\n.read sql/import_ais.sql\nSELECT 7;\n")
        first, second, last = output.splitlines()
        self.assertIn("ais_reports: there is no such table; .import --csv FILE ais_reports first", first)
        self.assertIn("no such table: ais_reports", second)
        self.assertEqual(last, "7")


class BundledReports(unittest.TestCase):
    def test_the_file_is_small_and_in_the_layout_of_noaa(self):
        self.assertLessEqual(BUNDLED.stat().st_size, 400_000)
        self.assertEqual(BUNDLED.read_text().splitlines()[0], NOAA.splitlines()[0])

    def test_the_file_is_the_cut_that_its_script_makes(self):
        reports = SHARED_DATA / "ships_us_20220103.csv.gz"
        if not reports.exists():
            self.skipTest(f"no AIS data in {SHARED_DATA}")
        with tempfile.TemporaryDirectory() as folder:
            made = Path(folder) / BUNDLED.name
            subprocess.run([sys.executable, BUNDLED.parent / "make_cut.py", reports, made], check=True)
            self.assertEqual(made.read_bytes(), BUNDLED.read_bytes())


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
