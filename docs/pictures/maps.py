"""Maps: real ships with their coast, and a river drawn by the tracks of its ships. Coast: Natural Earth, as the wheel ships it."""
import csv
import gzip
import json
import math
import os
import sys
import time
from pathlib import Path

from scenes import ROOT, animate, arrow, connect, scale_bar
from svg import Picture, number

sys.path.insert(0, str(ROOT / "ext/hosts/python"))
from make_coast import clipped  # noqa: E402

COAST = ROOT / "ext/hosts/python/src/foresee/page/coast.json"
HARBOUR = ROOT / "sql/data/new_york_20220103.csv"
SHARED = Path(os.environ.get("FORESEE_SHARED_DATA", ROOT.parent / "shared/data")) / "ships_us_20220103.csv.gz"
HALF_MILE, TEN_MINUTES = 926, 600


def rings(box):
    """Rings of land about this box, in degrees (the encoding is that of ext/hosts/python/make_coast.py)."""
    coast = json.loads(COAST.read_text())
    region, = (region for region in coast["regions"] if region["box"][0] <= box[0] and region["box"][1] <= box[1]
               and box[2] <= region["box"][2] and box[3] <= region["box"][3])
    for text in region["rings"]:
        points, place, axis, value, shift = [], [0, 0], 0, 0, 0
        for letter in text:
            bits = ord(letter) - 63
            value, shift = value | (bits & 31) << shift, shift + 5
            if bits < 32:
                place[axis] += (value >> 1) ^ -(value & 1)
                value = shift = 0
                if axis == 1:
                    points.append((place[0] / coast["units"], place[1] / coast["units"]))
                axis = 1 - axis
        yield points


class Map:
    """A plane chart of a box of degrees, in a frame of the picture."""

    def __init__(self, picture, box, left, top, width):
        self.picture, self.box, self.left, self.top, self.width = picture, box, left, top, width
        self.squeeze = math.cos(math.radians((box[1] + box[3]) / 2))
        self.scale = width / ((box[2] - box[0]) * self.squeeze)  # pixels per degree of latitude
        self.height = (box[3] - box[1]) * self.scale

    def pixel(self, lat, lon):
        return self.left + (lon - self.box[0]) * self.squeeze * self.scale, self.top + (self.box[3] - lat) * self.scale

    def holds(self, lat, lon):
        return self.box[1] < lat < self.box[3] and self.box[0] < lon < self.box[2]

    def metres(self, length):
        return length / 111200 * self.scale

    def open(self):
        self.picture.add(f'<svg x="{number(self.left)}" y="{number(self.top)}" width="{number(self.width)}" height="{number(self.height)}" '
                         f'viewBox="{number(self.left)} {number(self.top)} {number(self.width)} {number(self.height)}">')
        self.picture.rect(self.left, self.top, self.width, self.height, "water")

    def land(self):
        """Only what the frame can show."""
        around = (self.box[0] - 0.02, self.box[1] - 0.02, self.box[2] + 0.02, self.box[3] + 0.02)
        for ring in rings(self.box):
            shown = clipped(ring, around)
            if shown:
                d = "M" + "L".join(f"{number(x)} {number(y)}" for x, y in (self.pixel(lat, lon) for lon, lat in shown)) + "Z"
                self.picture.add(f'<path class="f-land s-coast" d="{d}" stroke-width="0.8"/>')

    def close(self, bar, label):
        scale_bar(self.picture, self.left + self.width - 24 - self.metres(bar), self.top + self.height - 16, self.metres(bar), label)
        self.picture.add("</svg>")


def newest_of(path):
    """(mmsi, t, lat, lon, speed, course or None, name): the newest report of each ship that says its speed."""
    os.environ["TZ"] = "UTC"
    time.tzset()
    ships = {}
    with path.open(newline="") as file:
        for row in csv.DictReader(file):
            if float(row["SOG"]) == 102.3:
                continue
            t = int(time.mktime(time.strptime(row["BaseDateTime"], "%Y-%m-%dT%H:%M:%S")))
            course = None if float(row["COG"]) == 360 else float(row["COG"])
            speed = float(row["SOG"]) if course is not None else 0
            if row["MMSI"] not in ships or ships[row["MMSI"]][1] <= t:
                ships[row["MMSI"]] = (int(row["MMSI"]), t, float(row["LAT"]), float(row["LON"]), speed, course, row["VesselName"].title())
    return list(ships.values())


def is_free(chart, box, spots, ring, labels):
    """Whether a label in this box covers no ring and no other label, and is within the chart."""
    left, top, right, bottom = box
    within = chart.left < left and right < chart.left + chart.width and chart.top < top and bottom < chart.top + chart.height - 30
    return (within and not any(left - ring < x < right + ring and top - ring < y < bottom + ring for x, y in spots if not (
                math.isclose(y, (top + bottom) / 2 - 1) and min(abs(left + 4 - x), abs(right - x)) < 18))
            and not any(left < other[2] and other[0] < right and top < other[3] and other[1] < bottom for other in labels))


def new_york():
    """Real ships of New York Harbour: where they are, where they will be in ten minutes, and who will come close to whom."""
    db = connect()
    db.execute("CREATE VIRTUAL TABLE ships USING moving_objects(id, t, lat, lon, speed, course, +name TEXT, origin = '40.6 -74.0', speed_unit = knots)")
    db.executemany("INSERT INTO ships VALUES (?, ?, ?, ?, ?, ?, ?)", newest_of(HARBOUR))
    (count, now), = db.execute("SELECT count(*), max(t) FROM ships").fetchall()
    pairs = db.execute("SELECT a.name, b.name, j.dt_cpa, j.d_cpa, j.t_cpa, j.a, j.b FROM predictive_join(?, 'ships', ?) j "
                       "JOIN ships a ON a.id = j.a JOIN ships b ON b.id = j.b WHERE j.dt > 0 ORDER BY j.dt_cpa, j.a, j.b",
                       (TEN_MINUTES, HALF_MILE)).fetchall()
    message = f"New York Harbour: {len(pairs)} pairs of {count} ships will come within half a nautical mile in 10 minutes"
    box = (-74.22, 40.565, -73.88, 40.775)
    picture = Picture(900, 960, message, "A map of ships with their paths of ten minutes; rings mark where two come close.")
    picture.heading(message, "blue: AIS reports of 3 January 2022, with ten minutes ahead; orange: closest approaches that are still to come")
    chart = Map(picture, box, 20, 62, 860)
    picture.cut(chart.top + chart.height + 30)
    chart.open()
    chart.land()
    places = dict((row[0], row[1:]) for row in db.execute("SELECT id, lat, lon FROM predictive_position(?, 'ships') ORDER BY id", (now,)))
    later = dict((row[0], row[1:]) for row in db.execute("SELECT id, lat, lon FROM predictive_position(?, 'ships') ORDER BY id", (now + TEN_MINUTES,)))
    close = {ship for pair in pairs for ship in pair[5:7]}
    for ship, place in places.items():
        start, end = chart.pixel(*place), chart.pixel(*later[ship])
        length = math.dist(start, end)
        if length > 8:
            picture.line(*start, *end, "foresee", 1.4, extra=' stroke-opacity="0.55"')
            arrow(picture, *(b - 6 * (b - a) / length for a, b in zip(start, end)), end[0] - start[0], end[1] - start[1], "foresee", 3)
    for ship, place in places.items():
        start, end = chart.pixel(*place), chart.pixel(*later[ship])
        picture.circle(*start, 3.4 if ship in close else 2.3, "foresee")
        if math.dist(start, end) > 8:
            picture.moving(animate("cx", [0, 1], [start[0], end[0]], 15) + animate("cy", [0, 1], [start[1], end[1]], 15))
    spots = []
    for one, other, dt, d, t, a, b in pairs:
        ends = db.execute("SELECT lat, lon FROM predictive_position(?, 'ships') WHERE id IN (?, ?)", (t, a, b)).fetchall()
        spots.append(chart.pixel(*(sum(end[axis] for end in ends) / 2 for axis in (0, 1))))
        picture.circle(*spots[-1], chart.metres(HALF_MILE / 2), "meet", hollow=True)
    labels, ring = [], chart.metres(HALF_MILE / 2)
    for (x, y), (one, other, dt, d, *_) in zip(spots, pairs):
        name, numbers = f"{one} / {other}", f"{d:.0f} m in {dt / 60:.0f} min"
        width = 6.6 * len(name)
        for shift, side in ((shift, side) for shift in (17, 35, 55, 75) for side in (1, -1)):
            start = x + shift if side > 0 else x - shift - width
            box = start - 4, y - 16, start + width, y + 18
            if is_free(chart, box, spots, ring, labels):
                labels.append(box)
                if shift > 17:
                    picture.line(x + side * ring, y, x + side * (shift - 4), y, "meet", 0.8)
                picture.halo(start, y - 2, name, size=11, weight="bold")
                picture.halo(start, y + 12, numbers, size=11)
                break
    chart.close(5000, "5 km")
    picture.text(20, chart.top + chart.height + 18, "Ships: NOAA MarineCadastre, names made up. Coast: Natural Earth. Not for navigation.", "soft", size=11)
    return picture


def mississippi():
    """The poster: 25 minutes of reports between New Orleans and the sea draw the river; the hour ahead is what the extension computes."""
    if not SHARED.exists():
        return None
    box = (-91.35, 28.85, -89.0, 30.6)
    tracks = {}
    with gzip.open(SHARED, "rt", newline="") as file:
        for row in csv.DictReader(file):
            lat, lon = float(row["lat"]), float(row["lon"])
            if box[1] < lat < box[3] and box[0] < lon < box[2]:
                tracks.setdefault(row["mmsi"], []).append((int(row["t"]), lat, lon, float(row["sog_kn"]), float(row["cog_deg"])))
    db = connect()
    db.execute("CREATE VIRTUAL TABLE ships USING moving_objects(id, t, lat, lon, speed, course, origin = '30 -90.5', speed_unit = knots)")
    for mmsi, reports in tracks.items():
        t, lat, lon, speed, course = max(reports)
        if speed != 102.3:
            db.execute("INSERT INTO ships VALUES (?, ?, ?, ?, ?, ?)",
                       (int(mmsi), t, lat, lon, speed if course != 360 else 0, course if course != 360 else None))
    (count, now), = db.execute("SELECT count(*), max(t) FROM ships").fetchall()
    pairs = db.execute("SELECT dt_cpa, d_cpa, t_cpa, a FROM predictive_join(3600, 'ships', ?) WHERE dt > 0 ORDER BY a, b", (HALF_MILE,)).fetchall()
    message = f"The Mississippi hour: {count:,} ships draw the river, {len(pairs):,} pairs will come within half a nautical mile"
    picture = Picture(1180, 1100, message, "Tracks of ships on the lower Mississippi, and the places of coming encounters in the next hour.")
    picture.heading(message, "blue: AIS reports of 25 minutes, 3 January 2022; orange: closest approaches of the next hour, if all keep course and speed")
    chart = Map(picture, box, 20, 62, 1140)
    picture.cut(chart.top + chart.height + 30)
    chart.open()
    chart.land()
    for reports in tracks.values():
        points = [chart.pixel(lat, lon) for _, lat, lon, _, _ in sorted(reports)]
        kept = points[:1]
        for point in points[1:]:
            if math.dist(point, kept[-1]) > 2:
                kept.append(point)
        if len(kept) > 1:
            picture.path(kept, "foresee", 2.4, extra=' stroke-opacity="0.85" stroke-linecap="round"')
        else:
            picture.circle(*kept[0], 1.6, "foresee")
    placed = set()
    for dt, d, t, a in pairs:
        (lat, lon), = db.execute("SELECT lat, lon FROM predictive_position(?, 'ships') WHERE id = ?", (t, a)).fetchall()
        x, y = chart.pixel(lat, lon)
        if chart.holds(lat, lon) and (round(x / 3), round(y / 3)) not in placed:
            placed.add((round(x / 3), round(y / 3)))
            picture.circle(x, y, 2.8, "meet", hollow=True)
    for name, lat, lon in (("New Orleans", 29.95, -90.07), ("Baton Rouge", 30.45, -91.18), ("Gulf of Mexico", 28.95, -90.4), ("Port Fourchon", 29.11, -90.2)):
        picture.halo(*chart.pixel(lat, lon), name, size=14)
    chart.close(20000, "20 km")
    picture.text(20, chart.top + chart.height + 18, "Ships: NOAA MarineCadastre. Coast: Natural Earth; it has no rivers. Not for navigation.", "soft", size=11)
    return picture
