"""Zones and shapes as rings of (longitude, latitude), for a map: what a column `zone` holds, and a `shape` at its place on the plane.

    areas = Areas(db, table)                     # of tables.py
    areas.at(now)                                # [[number, name, [ring, …]], …], a ring being [longitude, latitude, …]

An edge of a zone is the shortest line on the Earth: a long one gets more corners. Meshes have no rings here.
"""
import math
import re

from .encounters import printable
from .files import quoted

MAX_AREAS = 2000        # that a map draws of a table
LONG_EDGE = 0.05        # degrees between two corners of an edge


class Areas:
    def __init__(self, db, table):
        self.db, self.table, self.known = db, table, {}
        self.is_zone = "zone" in table.columns

    def at(self, now):
        rows = self.zones() if self.is_zone else self.shapes(now) if "shape" in self.table.columns else []
        areas, used = [], {}
        for number, name, key, rings in rows:
            used[key] = self.known[key] if key in self.known else rings()
            if used[key]:
                areas.append([number, printable(str(name)) if name else str(number), used[key]])
        self.known = used                   # those that were drawn last, so that nothing is computed again
        return areas

    def columns(self, *more):
        return ", ".join(["id", self.table.named or "NULL", *more])

    def zones(self):
        for number, name, text in self.db.execute(f"SELECT {self.columns('zone')} FROM {quoted(self.table.name)} LIMIT {MAX_AREAS}").fetchall():
            yield number, name, text, lambda text=text: [self.edges(ring) for ring in rings_of(text)]

    def shapes(self, now):
        if self.table.in_degrees() is None or self.table.globe:     # the globe has points and balls alone
            return
        heading = "heading" if "heading" in self.table.columns else "0"
        rows = self.db.execute(f"SELECT {self.columns('shape', heading)}, p.x, p.y FROM {quoted(self.table.name)} JOIN "
                               f"(SELECT id AS mover, x, y FROM predictive_position(?, ?)) p ON p.mover = id LIMIT {MAX_AREAS}",
                               (now, self.table.name)).fetchall()
        for number, name, text, turn, x, y in rows:
            yield number, name, (text, turn, x, y), lambda shape=(text or "", turn or 0.0, x, y): self.placed(*shape)

    def placed(self, text, turn, x, y):
        """A shape turned clockwise and moved to its place on the plane."""
        s, c = math.sin(math.radians(turn)), math.cos(math.radians(turn))
        rings = [[self.degrees(x + u * c + v * s, y - u * s + v * c) for u, v in ring] for ring in rings_of(text)]
        return [[round(value, 6) for lat, lon in ring for value in (lon, lat)] for ring in rings]

    def degrees(self, x, y):
        return self.db.execute("SELECT lat, lon FROM plane_to_geo(?, ?, 0, 0, ?, ?)", (x, y, *self.table.origin)).fetchone()

    def edges(self, ring):
        """The corners of a ring, and those between the ends of long edges. The plane about an edge's start has the geodesic straight."""
        line = []
        for (lon, lat), (to_lon, to_lat) in zip(ring, ring[1:]):
            line += [lon, lat]
            across = abs((to_lon - lon + 180) % 360 - 180)
            steps = min(256, math.ceil(max(across, abs(to_lat - lat)) / LONG_EDGE))
            if steps > 1:
                x, y = self.db.execute("SELECT x, y FROM geo_to_plane(?, ?, 0, 0, ?, ?)", (to_lat, to_lon, lat, lon)).fetchone()
                for step in range(1, steps):
                    north, east = self.db.execute("SELECT lat, lon FROM plane_to_geo(?, ?, 0, 0, ?, ?)",
                                                  (x * step / steps, y * step / steps, lat, lon)).fetchone()
                    line += [round(east, 6), round(north, 6)]
        return unbroken([*line, *ring[-1]])


def unbroken(line):
    """Longitudes without a jump at the date line: they may pass 180."""
    for i in range(2, len(line), 2):
        line[i] -= 360 * round((line[i] - line[i - 2]) / 360)
    return line


def rings_of(text):
    """The rings of a POLYGON or MULTIPOLYGON on the plane, each a list of (x, y); of a mesh none."""
    if not re.match(r"(SRID=\d+;)?\s*(MULTI)?POLYGON\s*\(", text, re.I):
        return []
    return [[tuple(map(float, corner.split()[:2])) for corner in ring.split(",")] for ring in re.findall(r"\(([^()]+)\)", text)]
