#!/usr/bin/python3
"""Makes one HTML file of the page, the module, a coast and examples: no server, no requests.

    /usr/bin/python3 ext/hosts/browser/make_page.py build/page build/packages/foresee.html [ships.csv]

ships.csv: the ships of the Lower Mississippi (id, t, x, y, vx, vy, ...), one more example. Those of New York are sql/data's.
"""
import base64
import csv
import gzip
import json
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
PYTHON_PAGE = ROOT / "ext/hosts/python/src/foresee/page"           # the map's coast
SCRIPTS = [PYTHON_PAGE / "coast.js", *(HERE / f"{name}.js" for name in ("module", "rows", "link", "page"))]
KNOTS_AT_REST = 0.5

NEW_YORK = """-- Ships of New York Harbour, one report each (real ones with made-up names). Degrees, knots.
-- Which pairs come within half a nautical mile in the next ten minutes?
SELECT a, b, t_cpa, d_cpa, t, t_end FROM predictive_join(600, 'ships', 926) WHERE dt > 0 ORDER BY t_cpa, a, b;
"""

ZONE = """-- Ships of New York Harbour and a zone, longitude first.
CREATE VIRTUAL TABLE IF NOT EXISTS zones USING moving_objects(id, zone, +name TEXT, origin = '40.7 -74');
DELETE FROM zones;
INSERT INTO zones VALUES
  (1, 'POLYGON((-74.06 40.63, -74.02 40.63, -74.02 40.68, -74.06 40.68, -74.06 40.63))', 'Upper Bay'),
  (2, 'POLYGON((-74.02 40.70, -74.00 40.70, -73.97 40.78, -74.01 40.77, -74.02 40.70))', 'Hudson');

-- Which ships under way enter a zone in the next half an hour, and when do they leave it?
SELECT a, b, t, t_end FROM predictive_join(1800, 'ships', 0, 'zones') WHERE dt > 0 ORDER BY t, a, b;
"""

HARBOUR = """-- Positions in metres, speeds in metres per second; every hull is a circle of 30 m.
CREATE VIRTUAL TABLE IF NOT EXISTS ships USING moving_objects(id, x, y, vx, vy, r, +name TEXT);
DELETE FROM ships;
INSERT INTO ships VALUES
  (1,    0,     0,  6, 0, 30, 'Anna'),     -- eastward
  (2, 1200,     0, -6, 0, 30, 'Bruno'),    -- westward, on Anna's line
  (3,  600, -1600,  0, 8, 30, 'Clara'),    -- northward, across both
  (4,  600,   300,  0, 0, 30, 'Dora');     -- at anchor, on Clara's line

-- Which will touch within 300 s, and exactly when?
SELECT a, b, t, t_end, t_cpa, d_cpa FROM predictive_join(300, 'ships') ORDER BY t, a, b;
"""

HULLS = """-- Hulls with a bow, turned by their headings; a quay around a basin, and a lock whose chamber is a hole.
CREATE VIRTUAL TABLE IF NOT EXISTS ships USING moving_objects(id, x, y, vx, vy, shape, heading, +name TEXT);
CREATE VIRTUAL TABLE IF NOT EXISTS works USING moving_objects(id, x, y, shape, +name TEXT);
DELETE FROM ships; DELETE FROM works;
WITH hull(wkt) AS (VALUES ('POLYGON((-8 -90, 8 -90, 8 60, 0 90, -8 60, -8 -90))'))
INSERT INTO ships
            SELECT 1,    0,   0,  4,   4, wkt,  45, 'Anna'  FROM hull
  UNION ALL SELECT 2,  684, 600, -4,  -4, wkt, 225, 'Bruno' FROM hull
  UNION ALL SELECT 3, 1050,   0,  0,   2, wkt,   0, 'Clara' FROM hull
  UNION ALL SELECT 4, 1220, 110,  0, 0.5, wkt,   0, 'Dora'  FROM hull;
INSERT INTO works VALUES
  (1, 1000, 300, 'POLYGON((0 0, 20 0, 20 180, 80 180, 80 0, 100 0, 100 200, 0 200, 0 0))', 'quay'),
  (2, 1200,   0, 'POLYGON((0 0, 40 0, 40 260, 0 260, 0 0), (10 10, 30 10, 30 250, 10 250, 10 10))', 'lock');

-- What will the ships hit within 300 s?
SELECT a, b, t, t_end FROM predictive_join(300, 'ships', 0, 'works') ORDER BY t, a, b;
"""

CROWD = """-- Two thousand discs whose paths cross.
CREATE VIRTUAL TABLE IF NOT EXISTS crowd USING moving_objects(id, x, y, vx, vy, r);
DELETE FROM crowd;
INSERT INTO crowd
  SELECT value, (value * 7919) % 2000, (value * 104729) % 1300, ((value * 31) % 41 - 20) / 4.0, ((value * 17) % 37 - 18) / 4.0, 3
  FROM generate_series_of(2000);

-- Which touch within 20 s?
SELECT a, b, t, t_end, d_cpa FROM predictive_join(20, 'crowd') ORDER BY t, a, b;
""".replace("FROM generate_series_of(2000)", "FROM (WITH RECURSIVE n(value) AS (VALUES (1) UNION ALL SELECT value + 1 FROM n WHERE value < 2000) SELECT value FROM n)")

SHIPS = """-- 1,135 ships of the Lower Mississippi, one report each (US Coast Guard, NOAA; public domain). Metres, seconds.
-- Which pairs come within half a nautical mile in the next ten minutes?
SELECT a, b, t, t_end, t_cpa, d_cpa FROM predictive_join(600, 'ships', 926) WHERE dt > 0 ORDER BY t, a, b;
"""


def ships_setup(path):
    with open(path, newline="") as file:
        rows = [",".join(row[name] for name in ("id", "t", "x", "y", "vx", "vy")) for row in csv.DictReader(file)]
    return ("CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy);\nINSERT INTO ships VALUES\n("
            + "),\n(".join(rows) + ");")


def new_york_setup():
    """The newest report of each ship; the kinds are those of python3 -m foresee feed: moored ships do not meet one another."""
    newest = {}
    with (ROOT / "sql/data/new_york_20220103.csv").open(newline="") as file:
        for row in csv.DictReader(file):
            speed, course = float(row["SOG"]), float(row["COG"])
            if speed < KNOTS_AT_REST or (speed < 102.2 and course < 360):
                newest[row["MMSI"]] = row
    rows = []
    for number, row in sorted(newest.items()):
        at_rest, name = float(row["SOG"]) < KNOTS_AT_REST, row["VesselName"].replace("'", "''")
        motion = "0,NULL,2,1" if at_rest else f"{row['SOG']},{row['COG']},1,3"
        rows.append(f"({number},unixepoch('{row['BaseDateTime']}'),{row['LAT']},{row['LON']},{motion},'{name}')")
    return ("CREATE VIRTUAL TABLE ships USING moving_objects(id, t, lat, lon, speed, course, category, mask, +name TEXT, origin = '40.7 -74', "
            "speed_unit = knots);\nINSERT INTO ships VALUES\n" + ",\n".join(rows) + ";")


def examples(ships):
    harbour = new_york_setup()
    found = [{"title": "Ships of New York Harbour", "setup": harbour, "sql": NEW_YORK}, {"title": "A zone", "setup": harbour, "sql": ZONE},
             {"title": "A harbour", "sql": HARBOUR}, {"title": "Hulls, a quay and a lock", "sql": HULLS},
             {"title": "A crowd of 2,000", "sql": CROWD}]
    if ships:
        found.insert(2, {"title": "Ships of the Mississippi", "setup": ships_setup(ships), "sql": SHIPS})
    return found


def main():
    module, page = Path(sys.argv[1]), Path(sys.argv[2])
    wasm = gzip.compress((module / "foresee.wasm").read_bytes(), 9, mtime=0)
    parts = {"@EXAMPLES@": json.dumps(examples(sys.argv[3] if len(sys.argv) > 3 else None)).replace("</", "<\\/"),
             "@MODULE@": base64.b64encode(wasm).decode(), "@GLUE@": (module / "foresee.js").read_text(),
             "@COAST@": base64.b64encode(gzip.compress((PYTHON_PAGE / "coast.json").read_bytes(), 9, mtime=0)).decode(),
             "@SCRIPTS@": "\n".join(path.read_text() for path in SCRIPTS)}
    text = (HERE / "page.html").read_text()
    for mark, part in parts.items():
        before, after = text.split(mark)
        text = before + part + after
    page.parent.mkdir(parents=True, exist_ok=True)
    page.write_text(text)


if __name__ == "__main__":
    main()
