"""The geographic functions beside GeographicLib's own tools, GeodSolve and CartConvert, where they are installed (Debian:
geographiclib-tools): distances, places on the plane, places and velocities in space."""
import math
import random
import shutil
import subprocess
import unittest

from house import main, shell

COUNT = 2000


def places(seed):
    """Pairs of places up to 450 km apart, some over the date line, some near a pole."""
    rng = random.Random(seed)
    pairs = []
    for i in range(COUNT):
        lat = rng.uniform(-90, 90) if i % 10 else math.copysign(90 - 10 ** rng.uniform(-6, 0), rng.uniform(-1, 1))
        lon = rng.uniform(-180, 180) if i % 7 else math.copysign(180 - 10 ** rng.uniform(-6, 0), rng.uniform(-1, 1))
        reach = 4 * 10 ** rng.uniform(-6, 0)
        other = max(-90, min(90, lat + rng.uniform(-reach, reach)))
        pairs.append((lat, lon, other, lon + rng.uniform(-reach, reach) / max(1e-3, math.cos(math.radians(other)))))
    return pairs


def tool(command, lines):
    done = subprocess.run(command, input="".join(lines), text=True, stdout=subprocess.PIPE, check=True)
    return [list(map(float, line.split())) for line in done.stdout.splitlines()]


def asked(rows, select):
    """What `select` gives for each row of numbers, as columns c0, c1 ... of a table named given."""
    columns = [f"c{i}" for i in range(len(rows[0]))]
    values = ",".join("(" + ",".join(map(repr, row)) + ")" for row in rows)
    status, output = shell(f""".load build/release/foresee
CREATE TABLE given(n INTEGER PRIMARY KEY, {', '.join(columns)});
INSERT INTO given({', '.join(columns)}) VALUES {values};
.mode list
{select};
""", "-bail")
    if status:
        raise AssertionError(output[:1000])
    return [list(map(float, line.split("|"))) for line in output.splitlines()]


def exact(*names):
    return ", ".join(f"printf('%!.17g', {name})" for name in names)


@unittest.skipUnless(shutil.which("GeodSolve"), "GeodSolve is not installed (Debian: geographiclib-tools)")
class BesideGeodSolve(unittest.TestCase):
    def test_distances_and_places_on_the_plane(self):
        pairs = places(1)
        full = tool(["GeodSolve", "-i", "-f", "-p", "10"], (" ".join(map(repr, pair)) + "\n" for pair in pairs))
        got = asked(pairs, f"""SELECT {exact('geo_distance(c0, c1, c2, c3)', 'x', 'y')}
            FROM given, geo_to_plane(c2, c3, NULL, NULL, c0, c1) ORDER BY n""")
        self.assertEqual(len(got), COUNT)
        for pair, (distance, x, y), (_, _, bearing, _, _, _, wanted, *_) in zip(pairs, got, full):
            self.assertAlmostEqual(distance, wanted, delta=1e-8, msg=pair)
            self.assertAlmostEqual(x, wanted * math.sin(math.radians(bearing)), delta=1.5e-8, msg=pair)
            self.assertAlmostEqual(y, wanted * math.cos(math.radians(bearing)), delta=1.5e-8, msg=pair)


@unittest.skipUnless(shutil.which("CartConvert"), "CartConvert is not installed (Debian: geographiclib-tools)")
class BesideCartConvert(unittest.TestCase):
    def test_places_in_space_and_back(self):
        rng = random.Random(2)
        flights = [(lat, lon, rng.uniform(-11000, 4e5)) for lat, lon, *_ in places(3)]
        wanted = tool(["CartConvert", "-p", "10"], (" ".join(map(repr, flight)) + "\n" for flight in flights))
        got = asked(flights, f"SELECT {exact('x', 'y', 'z')} FROM given, geo_to_globe(c0, c1, c2, 0, 0, 0) ORDER BY n")
        back = asked(wanted, f"SELECT {exact('lat', 'lon', 'height')} FROM given, globe_to_geo(c0, c1, c2, 0, 0, 0) ORDER BY n")
        self.assertEqual(len(got), COUNT)
        for flight, point, right, (lat, lon, height) in zip(flights, got, wanted, back):
            for one, other in zip(point, right):
                self.assertAlmostEqual(one, other, delta=1e-8, msg=flight)
            self.assertAlmostEqual(math.radians(lat - flight[0]) * 6.4e6, 0, delta=1e-8, msg=flight)
            turned = math.remainder(lon - flight[1], 360)
            self.assertAlmostEqual(math.radians(turned) * math.hypot(*right[:2]), 0, delta=1e-8, msg=flight)
            self.assertAlmostEqual(height, flight[2], delta=1e-8, msg=flight)


if __name__ == "__main__":
    main()
