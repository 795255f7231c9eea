"""What docs/how-to/maps_and_pictures.md shows beyond its examples: the files that its recipes print are what maps and charts read. And every
picture of the pages is what docs/pictures/draw.py draws, with the palette, a title and a text for those who do not see it."""
import csv
import json
import math
import os
import re
import subprocess
import sys
import unittest
import xml.etree.ElementTree as xml
from datetime import datetime
from pathlib import Path

from documents import examples
from house import EXTENSION, ROOT, SHARED_DATA, main

sys.path.insert(0, str(ROOT / "docs/pictures"))
import charts  # noqa: E402
import draw  # noqa: E402
import svg  # noqa: E402

PYTHON = "/usr/bin/python3"
DRAW = ROOT / "docs/pictures/draw.py"
PAGE = ROOT / "docs/how-to/maps_and_pictures.md"
SVG = "{http://www.w3.org/2000/svg}"
GREYS = ("grey1", "grey2", "grey3", "grey4")
# Linear red, green and blue as eyes see them (Machado, Oliveira and Fernandes, 2009, severity 1).
EYES = {"all colours": ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
        "no red": ((0.152286, 1.052583, -0.204868), (0.114503, 0.786281, 0.099216), (-0.003882, -0.048116, 1.051998)),
        "no green": ((0.367322, 0.860646, -0.227968), (0.280085, 0.672501, 0.047413), (-0.011820, 0.042940, 0.968881)),
        "no blue": ((1.255528, -0.076749, -0.178779), (-0.078411, 0.930809, 0.147602), (0.004733, 0.691367, 0.303900))}


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


def drawn(name):
    done = subprocess.run([PYTHON, DRAW, "--print", name], text=True, capture_output=True, cwd=ROOT,
                          env={**os.environ, "FORESEE_EXTENSION": str(EXTENSION)})
    if done.returncode:
        raise AssertionError(done.stderr)
    return done.stdout


def pictures():
    """Every SVG of docs/."""
    return sorted((ROOT / "docs").rglob("*.svg"))


def linear(shade):
    """Red, green and blue of #rrggbb as amounts of light."""
    parts = (int(shade[i:i + 2], 16) / 255 for i in (1, 3, 5))
    return [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in parts]


def weighted(weights, light):
    return sum(weight * part for weight, part in zip(weights, light))


def contrast(one, other):
    """The ratio of two luminances (WCAG 2.1)."""
    low, high = sorted(weighted((0.2126, 0.7152, 0.0722), linear(shade)) for shade in (one, other))
    return (high + 0.05) / (low + 0.05)


def lab(shade, eyes):
    """CIE L*, a*, b* of a colour as these eyes see it; a distance of 2.3 is just noticeable."""
    light = [min(1, max(0, weighted(row, linear(shade)))) for row in EYES[eyes]]
    x, y, z = (weighted(row, light) for row in ((0.4339, 0.3762, 0.1899), (0.2126, 0.7152, 0.0722), (0.0178, 0.1094, 0.8728)))
    x, y, z = (t ** (1 / 3) if t > 216 / 24389 else (24389 / 27 * t + 16) / 116 for t in (x, y, z))
    return 116 * y - 16, 500 * (x - y), 200 * (y - z)


class Drawn(unittest.TestCase):
    maxDiff = None

    def require_extension(self):
        probe = "import sqlite3; sqlite3.Connection.enable_load_extension"
        if not Path(PYTHON).exists() or subprocess.run([PYTHON, "-c", probe], capture_output=True).returncode:
            self.skipTest(f"there is no {PYTHON} with enable_load_extension")

    def test_every_picture_of_the_pages_is_drawn_by_the_script(self):
        known = {folder / f"{name}.svg" for name, (folder, _) in draw.CHARTS.items()} | {draw.PICTURES / f"{name}.svg" for name in draw.SCENES}
        self.assertEqual(set(pictures()), known)

    def test_charts_are_what_their_tables_say(self):
        for name, (folder, chart) in draw.CHARTS.items():
            with self.subTest(name):
                self.assertEqual(chart(folder).written(), (folder / f"{name}.svg").read_text())

    def test_scenes_and_maps_are_what_the_extension_says(self):
        self.require_extension()
        for name in draw.SCENES:
            if name == "mississippi" and not (SHARED_DATA / "ships_us_20220103.csv.gz").exists():
                continue
            with self.subTest(name):
                self.assertEqual(drawn(name), (draw.PICTURES / f"{name}.svg").read_text())

    def test_each_says_what_it_shows_in_light_and_dark_and_asks_nobody(self):
        for path in pictures():
            with self.subTest(path.name):
                text = path.read_text()
                picture = xml.fromstring(text)
                self.assertGreater(len(picture.find(SVG + "title").text), 20)
                self.assertGreater(len(picture.find(SVG + "desc").text), 20)
                self.assertIn("prefers-color-scheme: dark", text)
                self.assertNotIn("http", text.replace('xmlns="http://www.w3.org/2000/svg"', ""))
                classes = {word for place in picture.iter() for word in place.get("class", "").split()}
                self.assertLessEqual(classes, {f"{kind}-{name}" for kind in "fs" for name in svg.PALETTE})
                self.assertIsNone(re.search(r'(?:fill|stroke)="#', text), "a colour that is not of the palette")

    def test_each_stands_on_a_page_with_a_text_for_those_who_do_not_see_it(self):
        shown = {}
        for page in [ROOT / "README.md", *(ROOT / "docs").rglob("*.md")]:
            for words, target in re.findall(r"!\[([^\]]*)\]\(([^)]+\.svg)\)", page.read_text()):
                shown[(page.parent / target).resolve()] = words
        self.assertEqual(set(pictures()), set(shown))
        self.assertTrue(all(len(words) > 10 for words in shown.values()), shown)

    def test_the_programs_lines_become_the_table_of_pairs(self):
        lines = ["ships, 600 s: 1000 pairs, 35 touch; 2 exact",
                 "    foresee                           98 ns decide       167 ns t       209 ns t, t_end",
                 "    plain double                     481 ns: 4.9x 2.88x 2.3x; of 35 in 1000 pairs misses 0, invents 0, t off by 6e-13 s",
                 "    FCL, 10 samples                 1619 ns: 17x 9.7x 7.7x; of 35 in 1000 pairs misses 25, invents 0, t off by 32 s",
                 "… within 50 m: 1000 pairs, 90 touch; 2 exact",
                 "    foresee                          105 ns decide       456 ns t       730 ns t, t_end"]
        self.assertEqual(charts.pairs_of(lines), [("ships, 600 s", "foresee", "167", ""), ("ships, 600 s", "plain double", "481", ""),
                                                  ("ships, 600 s", "FCL, 10 samples", "1619", "misses 25 of 35, 32 s late")])

    def test_text_and_marks_have_contrast(self):
        """What WCAG 2.1 requires: 4.5 for text, 3 for marks."""
        for scheme in (0, 1):
            for name in ("ink", "soft", "foresee", "meet", *GREYS):
                with self.subTest(name, scheme=scheme):
                    self.assertGreater(contrast(svg.PALETTE[name][scheme], svg.PALETTE["ground"][scheme]), 3 if name in GREYS else 4.5)

    def test_foresee_and_what_meets_differ_from_rivals_for_all_eyes(self):
        for scheme in (0, 1):
            for eyes in EYES:
                for one, other in [("foresee", "meet"), *((one, grey) for one in ("foresee", "meet") for grey in GREYS)]:
                    with self.subTest(f"{one}, {other}", scheme=scheme, eyes=eyes):
                        self.assertGreater(math.dist(*(lab(svg.PALETTE[name][scheme], eyes) for name in (one, other))), 20)

    def test_greys_differ_in_grey_print(self):
        for scheme in (0, 1):
            for one, next_one in zip(GREYS, GREYS[1:]):
                with self.subTest(f"{one}, {next_one}", scheme=scheme):
                    self.assertGreater(contrast(svg.PALETTE[one][scheme], svg.PALETTE[next_one][scheme]), 1.4)


if __name__ == "__main__":
    main()
