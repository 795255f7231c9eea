"""Makes src/foresee/page/coast.json, the coast of the map, from npm's world-atlas (Natural Earth, public domain).

    npm pack world-atlas && tar xzf world-atlas-*.tgz
    python3 ext/hosts/python/make_coast.py package ext/hosts/python/src/foresee/page/coast.json

The world is land-50m; boxes with busy harbours are land-10m. A ring is a string: differences of longitude and latitude in
thousandths of a degree, zigzag, five bits per character from '?' on (the encoding of polylines that maps use). Rings of land and of
inland seas are alike: the page fills them by the even-odd rule.
"""
import json
import sys
from pathlib import Path

UNITS = 1000            # per degree: 110 m, finer than the source
WORLD_UNITS = 100       # the world is drawn from far away
SMALLEST = 0.0004       # square degrees: smaller islands of the world are left out
# west, south, east, north
DETAILED = [(-98.0, 24.0, -69.5, 42.6), (-125.0, 32.4, -117.0, 50.0), (-6.0, 49.0, 13.0, 59.0)]


def rings(atlas):
    """The closed rings of a topology, in degrees."""
    scale, shift = atlas["transform"]["scale"], atlas["transform"]["translate"]
    arcs = []
    for arc in atlas["arcs"]:
        x = y = 0
        points = []
        for dx, dy in arc:
            x, y = x + dx, y + dy
            points.append((x * scale[0] + shift[0], y * scale[1] + shift[1]))
        arcs.append(points)
    for geometry in atlas["objects"]["land"]["geometries"]:
        for polygon in geometry["arcs"]:
            for ring in polygon:
                points = []
                for number in ring:
                    part = arcs[number] if number >= 0 else arcs[~number][::-1]
                    points += part[1 if points else 0:]
                yield points


def area(points):
    return abs(sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(points, points[1:] + points[:1]))) / 2


def clipped(points, box):
    """Sutherland and Hodgman's clip against a box."""
    for axis, limit, sign in ((0, box[0], 1), (1, box[1], 1), (0, box[2], -1), (1, box[3], -1)):
        kept = []
        for a, b in zip(points[-1:] + points[:-1], points):
            inside_a, inside_b = sign * (a[axis] - limit) >= 0, sign * (b[axis] - limit) >= 0
            if inside_a != inside_b:
                share = (limit - a[axis]) / (b[axis] - a[axis])
                kept.append(tuple(a[i] + share * (b[i] - a[i]) for i in (0, 1)))
            if inside_b:
                kept.append(b)
        points = kept
    return points


def encoded(points, units):
    text, before = [], (0, 0)
    rounded = [(round(x * units), round(y * units)) for x, y in points]
    for point in [p for i, p in enumerate(rounded) if i == 0 or p != rounded[i - 1]]:
        for new, old in zip(point, before):
            value = (new - old) * 2 if new >= old else (old - new) * 2 - 1
            while value >= 32:
                text.append(chr(63 + (value & 31 | 32)))
                value >>= 5
            text.append(chr(63 + value))
        before = point
    return "".join(text)


def main():
    source, target = Path(sys.argv[1]), Path(sys.argv[2])
    coarse = list(rings(json.loads((source / "land-50m.json").read_text())))
    fine = list(rings(json.loads((source / "land-10m.json").read_text())))
    world = [encoded(ring, WORLD_UNITS) for ring in coarse if area(ring) >= SMALLEST]
    regions = []
    for box in DETAILED:
        cut = [clipped(ring, box) for ring in fine]
        regions.append({"box": box, "rings": [encoded(ring, UNITS) for ring in cut if len(ring) > 2]})
    version = json.loads((source / "package.json").read_text())["version"]
    coast = {"source": f"Natural Earth (public domain), land-50m and land-10m of world-atlas {version}",
             "license_of_world_atlas": " ".join((source / "LICENSE").read_text().split()),
             "units": UNITS, "world_units": WORLD_UNITS, "world": world, "regions": regions}
    target.write_text(json.dumps(coast, separators=(",", ":")).replace('],"', '],\n"').replace('","', '",\n"') + "\n")


if __name__ == "__main__":
    main()
