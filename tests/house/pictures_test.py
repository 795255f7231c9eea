"""What docs/how-to/maps_and_pictures.md shows beyond its examples: the files that its recipes print are what maps and charts read, and the picture
of the harbour is what its script draws."""
import csv
import json
import os
import subprocess
import unittest
import xml.etree.ElementTree as xml
from datetime import datetime
from pathlib import Path

from documents import examples
from house import EXTENSION, ROOT, main

PYTHON = "/usr/bin/python3"
PICTURE = ROOT / "docs/pictures/harbour"
PAGE = ROOT / "docs/how-to/maps_and_pictures.md"
SVG = "{http://www.w3.org/2000/svg}"


def printed(word):
    """What the one block with `word` in it prints; that it does so, documents_test.py shows."""
    found, = (block.expected for block in examples(PAGE.read_text()) if word in block.text)
    return found


class Recipes(unittest.TestCase):
    def lines(self, collection):
        self.assertEqual(collection["type"], "FeatureCollection")
        self.assertEqual([feature["properties"]["id"] for feature in collection["features"]], [211, 244])
        for feature in collection["features"]:
            self.assertEqual((feature["type"], feature["geometry"]["type"]), ("Feature", "LineString"))
        return [feature["geometry"]["coordinates"] for feature in collection["features"]]

    def test_geojson_has_longitude_first(self):
        meeting, = json.loads(printed("'Point'"))["features"]
        lon, lat = meeting["geometry"]["coordinates"]
        self.assertTrue(7.8 < lon < 8 and 53.9 < lat < 54, (lon, lat))
        for line in self.lines(json.loads(printed("json_array(lon, lat)) AS line"))):
            self.assertEqual([len(point) for point in line], [2] * 4)

    def test_trips_have_a_timestamp_a_point(self):
        for trip in json.loads(printed("'timestamps'")):
            self.assertEqual(len(trip["path"]), len(trip["timestamps"]))
            self.assertEqual(trip["timestamps"], sorted(trip["timestamps"]))
            self.assertLess(max(trip["timestamps"]), 2 ** 24)  # as 32 bit floats

    def test_kepler_points_have_height_and_time(self):
        for line in self.lines(json.loads(printed("lat, 0, CAST"))):
            self.assertEqual([point[2] for point in line], [0] * 4)
            self.assertEqual([point[3] - line[0][3] for point in line], [0, 300, 600, 900])

    def test_the_csv_has_iso_times(self):
        rows = list(csv.DictReader(printed(".mode csv").splitlines()))
        self.assertEqual([datetime.strptime(row["time"], "%Y-%m-%dT%H:%M:%SZ").minute for row in rows], [0, 0, 5])
        self.assertTrue(all(53.9 < float(row["lat"]) < 54 for row in rows))

    def test_movingpandas_takes_the_rows(self):
        program = next(part.split("```")[0] for part in PAGE.read_text().split("```python\n")[1:])
        try:
            import movingpandas  # noqa: F401
        except ImportError:
            self.skipTest("movingpandas is not installed")
        import sqlite3
        db = sqlite3.connect(":memory:")
        db.execute("CREATE TABLE tracks(id, t, x, y)")
        db.executemany("INSERT INTO tracks VALUES (?, ?, ?, ?)", [(1, 0, 0, 0), (1, 60, 5, 5), (2, 0, 9, 9), (2, 60, 1, 1)])
        names = {"db": db}
        exec(program, names)
        self.assertEqual(len(names["tracks"].trajectories), 2)

    def test_the_svg_moves_within_its_view(self):
        picture = xml.fromstring(printed("group_concat(ship"))
        left, top, width, height = map(float, picture.get("viewBox").split())
        ways = {name: [list(map(float, way.get("values").split(";"))) for way in picture.iter(SVG + "animate")
                       if way.get("attributeName") == name] for name in ("cx", "cy")}
        self.assertEqual([len(way) for way in ways["cx"] + ways["cy"]], [4] * 4)
        self.assertTrue(all(left < x < left + width for way in ways["cx"] for x in way))
        self.assertTrue(all(top < y < top + height for way in ways["cy"] for y in way))


class Harbour(unittest.TestCase):
    maxDiff = None

    def test_the_picture_is_what_the_script_draws(self):
        probe = "import sqlite3; sqlite3.Connection.enable_load_extension"
        if not Path(PYTHON).exists() or subprocess.run([PYTHON, "-c", probe], capture_output=True).returncode:
            self.skipTest(f"there is no {PYTHON} with enable_load_extension")
        done = subprocess.run([PYTHON, PICTURE.with_suffix(".py")], text=True, capture_output=True, cwd=ROOT,
                              env={**os.environ, "FORESEE_EXTENSION": str(EXTENSION)})
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout, PICTURE.with_suffix(".svg").read_text())
        self.assertNotIn("http", done.stdout.replace('xmlns="http://www.w3.org/2000/svg"', ""))


if __name__ == "__main__":
    main()
