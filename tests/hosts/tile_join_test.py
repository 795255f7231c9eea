"""foresee_dask without Dask: tiles of any data together are the single join."""
import math
import random
import shutil
import sqlite3
import subprocess
import sys
import unittest
from contextlib import closing

import fleet
from fleet import EXTENSION, SHIPS, Fleet, here, main, ships

from foresee_dask import plan as plans, tile_join, tiles
from foresee_dask.merge import merge
from foresee_dask.question import Question


class Rectangles(unittest.TestCase):
    def boxes(self, count, size, seed):
        chance = random.Random(seed)
        corners = [(chance.gauss(0, 100), chance.gauss(0, 100)) for _ in range(count)]
        return [(x, x + chance.uniform(0, size), y, y + chance.uniform(0, size), 0) for x, y in corners]

    def test_they_cover_the_plane_without_overlap(self):
        for seed in range(20):
            boxes = self.boxes(300, 20, seed)
            found = tiles.cut(boxes, 16, 300, 1.0)
            self.assertEqual(len(found), 16)
            corners = [(box[0], box[2]) for box in boxes]
            for x, y in corners + [(-math.inf, 5.0), (math.inf, math.inf)] + [(math.nextafter(x, -math.inf), y) for x, y in corners]:
                owners = [tile for tile in found if (tile.x0 is None or tile.x0 <= x) and (tile.x1 is None or x < tile.x1)
                          and (tile.y0 is None or tile.y0 <= y) and (tile.y1 is None or y < tile.y1)]
                self.assertEqual(len(owners), 1, (x, y))

    def test_they_are_about_equally_dear(self):
        found = tiles.cut(self.boxes(4000, 1, 3), 16, 4000, 0.0)
        self.assertLess(max(tile.objects for tile in found), 2.5 * min(tile.objects for tile in found))

    def test_many_pairs_make_small_tiles(self):
        crowd = [(x / 1000, 5 + x / 1000, 0.0, 5.0, 0) for x in range(200)]
        found = tiles.cut(self.boxes(2000, 1, 4) + crowd, 16, 2200, 1.0)
        plain = tiles.cut(self.boxes(2000, 1, 4) + crowd, 16, 2200, 0.0)
        crowded = [tile for tile in found if (tile.x0 or -9e9) < 5 and (tile.x1 or 9e9) > 0 and (tile.y0 or -9e9) < 5 and (tile.y1 or 9e9) > 0]
        before = [tile for tile in plain if (tile.x0 or -9e9) < 5 and (tile.x1 or 9e9) > 0 and (tile.y0 or -9e9) < 5 and (tile.y1 or 9e9) > 0]
        self.assertGreater(len(crowded), len(before))

    def test_what_cannot_be_separated_ends_early(self):
        spot = [(1.0, 2.0, 3.0, 4.0, 0)] * 1000
        endless = [(-math.inf, math.inf, -math.inf, math.inf, 0)] * 1000
        for boxes in (spot, endless, []):
            self.assertEqual(len(tiles.cut(boxes, 16, 1000, 1.0)), 1)
        giants = [(float(i), i + 1e6, float(i), i + 1e6, 0) for i in range(1000)]
        self.assertLess(sum(tile.objects for tile in tiles.cut(giants, 64, 1000, 0.0)), 10_000)
        line = [(float(i), i + 0.5, -math.inf, math.inf, 0) for i in range(1000)]
        self.assertTrue(all(tile.y0 is None and tile.y1 is None for tile in tiles.cut(line, 8, 1000, 1.0)))

    def test_ties_are_cut_between(self):
        found = tiles.cut([(float(i % 3), i % 3 + 0.5, 0.0, 1.0, 0) for i in range(999)], 16, 999, 0.0)
        self.assertEqual(sorted(tile.x0 for tile in found if tile.x0 is not None), [1.0, 2.0])


class Whole(Fleet):
    """Tiles of shards, and tiles of one file, give the rows of the single join, to the bit."""

    def check(self, question, count=5, **tables):
        expected = self.single(question, **tables)
        self.assertGreater(len(expected), 20)
        three = [self.shard(f"part-{i}.db", **{name: (of, rows[i::3]) for name, (of, rows) in tables.items()}) for i in range(3)]
        for name, paths in (("one", [self.shard("one.db", **tables)]), ("three", three)):
            out = self.folder / name
            plan = plans.make(out, question, paths, EXTENSION, count, here)
            for tile in plan.tiles:
                tile_join.all_of(plan, tile)
            self.assertGreater(len(plan.tiles), 3)
            self.assertEqual(self.of_tiles(out), expected, name)
            merge(out, self.folder / f"{name}-merged.db")
            with closing(sqlite3.connect(self.folder / f"{name}-merged.db")) as db:
                self.assertEqual(db.execute("SELECT * FROM pairs").fetchall(), expected, name)

    def test_discs_and_what_they_carry(self):
        self.check(Question("ships", 60.0, within=30.0, now=60.0, columns=("t", "t_end", "d_cpa", "a.name", "b.name")),
                   ships=(SHIPS, ships(400)))

    def test_accelerated_boxes(self):
        rows = [(i, x, y, vx, vy, vy / 10, vx / 10, 15, 25) for i, _, x, y, vx, vy, _, _ in ships(300)]
        self.check(Question("ships", 30.0), ships=("id, x, y, vx, vy, ax, ay, hx, hy", rows))

    def test_movers_with_plans(self):
        rows = []
        for i, t, x, y, vx, vy, *_ in ships(300):
            far = x + 40 * vx, y + 40 * vy
            knots = (x, y, t), (*far, t + 40), (*far, t + 55), (x, y, t + 110)
            rows.append((i, None, None, "LINESTRING M(" + ", ".join("%r %r %r" % knot for knot in knots) + ")", 12))
        self.check(Question("ships", 40.0, within=8.0, now=60.0, columns=("t", "t_end", "d_cpa")), ships=("id, x, y, plan, r", rows))

    def test_two_tables(self):
        crates = [(i, x, y, 30, 20) for i, _, x, y, *_ in ships(300, seed=2)]
        self.check(Question("ships", 30.0, within=5.0, other="crates", now=60.0, columns=("t", "t_cpa")),
                   ships=(SHIPS, ships(300)), crates=("id, x, y, hx, hy", crates))

    def test_a_table_with_itself(self):
        self.check(Question("ships", 20.0, other="ships", now=60.0), ships=(SHIPS, ships(300)))

    def test_one_axis(self):
        rows = [(i, x, vx, 5) for i, _, x, _, vx, *_ in ships(200)]
        self.check(Question("ships", 20.0), ships=("id, x, vx, r", rows))

    def test_three_axes_with_within_z(self):
        rows = [(i, x, y, vx + vy, vx, vy, 0, 20, 5) for i, _, x, y, vx, vy, *_ in ships(300)]
        self.check(Question("ships", 30.0, within=10.0, within_z=8.0), ships=("id, x, y, z, vx, vy, vz, r, hz", rows))

    def test_outlines_that_end(self):
        outline = "POLYGON((-20 -20, 20 -20, 0 30, -20 -20))"
        rows = [(i, t, x, y, vx, vy, outline, 10 * (i % 36), t + 70) for i, t, x, y, vx, vy, *_ in ships(200)]
        self.check(Question("ships", 60.0, now=60.0, within=5.0), ships=("id, t, x, y, vx, vy, shape, heading, until", rows))

    def test_discs_that_grow(self):
        rows = [(*row[:7], (i % 5) / 10) for i, row in enumerate(ships(300))]
        self.check(Question("ships", 60.0, now=60.0), ships=("id, t, x, y, vx, vy, r, growth", rows))

    def test_degrees(self):
        about = "origin = '54 8', speed_unit = knots"
        rows = [(i, t, 54 + y / 1e5, 8 + x / 6e4, abs(vx), 22 * abs(vy), 20, name) for i, t, x, y, vx, vy, _, name in ships(300)]
        zones = [(i, 54 + y / 1e5, 8 + x / 6e4, 40) for i, _, x, y, *_ in ships(100, seed=2)]
        self.check(Question("ships", 60.0, now=60.0, columns=("t", "d_cpa", "a.name")),
                   ships=(f"id, t, lat, lon, speed, course, r, +name TEXT, {about}", rows))
        shutil.rmtree(self.folder)
        self.folder.mkdir()
        self.check(Question("ships", 60.0, other="zones", now=60.0),
                   ships=(f"id, t, lat, lon, speed, course, r, +name TEXT, {about}", rows), zones=(f"id, lat, lon, r, {about}", zones))

    def test_the_globe(self):
        about = "origin = globe, speed_unit = knots"
        rows = [(i, t, 89.99 - y / 1e5, x / 5 % 360 - 180, 0, abs(vx), 22 * abs(vy), 0, 20, name) for i, t, x, y, vx, vy, _, name in ships(300)]
        self.check(Question("ships", 60.0, now=60.0, within=50.0, columns=("t", "d_cpa", "a.name")),
                   ships=(f"id, t, lat, lon, z, speed, course, vz, r, +name TEXT, {about}", rows))
        shutil.rmtree(self.folder)
        self.folder.mkdir()
        self.check(Question("ships", 60.0, other="buoys", now=60.0, within=50.0),
                   ships=(f"id, t, lat, lon, speed, course, r, {about}", [(*row[:4], *row[5:7], 20) for row in rows]),
                   buoys=(f"id, lat, lon, r, {about}", [(row[0], *row[2:4], 40) for row in rows]))

    def test_kinds(self):
        rows = [(*row[:7], 1 << i % 3, (3, 6, 0, 7)[i % 4]) for i, row in enumerate(ships(500))]
        self.check(Question("ships", 60.0, now=60.0, within=20.0), ships=("id, t, x, y, vx, vy, r, category, mask", rows))

    def test_numbers_on_edges_and_beyond(self):
        lattice = [(i, 10.0 * (i % 12), 10.0 * (i // 12), 5, 5) for i in range(144)]
        self.check(Question("ships", 0.0), ships=("id, x, y, hx, hy", lattice))
        shutil.rmtree(self.folder)
        self.folder.mkdir()
        extreme = [(i, x, y, vx * (1e300 if i % 50 == 0 else 1), vy, 20) for i, _, x, y, vx, vy, *_ in ships(200)]
        self.check(Question("ships", 30.0), ships=("id, x, y, vx, vy, r", extreme))


class Tiles(Fleet):
    def plan(self, paths, count=8, question=Question("ships", 60.0), **options):
        return plans.make(self.out, question, paths, EXTENSION, count, here, **options)

    def test_columns_with_plus_travel_only_if_they_are_asked_for(self):
        paths = self.shards(ships(100))
        self.assertNotIn("name", " ".join(self.plan(paths).columns("ships")))
        for path in paths:
            with closing(sqlite3.connect(path)) as db:
                db.execute("DROP TABLE ships_aux")
        plan = plans.read(self.out)
        self.assertGreater(sum(result["rows"] for tile in plan.tiles for result in tile_join.all_of(plan, tile)), 20)
        named = plans.make(self.folder / "named", Question("ships", 60.0, columns=("t", "b.name")), paths, EXTENSION, 4, here)
        self.assertIn('"name"', named.columns("ships"))
        with self.assertRaises(sqlite3.Error):
            tile_join.join_tile(named, named.tiles[0])

    def test_a_shard_that_goes_missing_on_the_way(self):
        rows = ships(300)
        paths = self.shards(rows)
        plan = self.plan(paths)
        done = [tile_join.join_tile(plan, tile) for tile in plan.tiles[:3]]
        before = self.bytes_of(self.out)
        paths[1].rename(self.folder / "away.db")
        said = self.refused(self.out, before=("-m", "foresee_dask.tile_join"))
        self.assertIn(f"{paths[1]} cannot be opened: there is no such file", said)
        self.assertEqual(self.bytes_of(self.out), before)
        self.assertEqual(len(done), 3)
        (self.folder / "away.db").rename(paths[1])
        self.assertEqual(self.command(self.out, before=("-m", "foresee_dask.tile_join")).returncode, 0)
        self.assertEqual(self.of_tiles(), self.single(Question("ships", 60.0, now=60.0), ships=(SHIPS, rows)))

    def test_folders_of_any_name_and_shards_that_are_written_to_in_wal(self):
        rows = ships(300)
        self.out = self.folder / "pairs #1%20?"
        paths = [path.rename(path.with_name(f"{path.stem} %41?#.db")) for path in self.shards(rows)]
        with closing(self.open(paths[0])) as writer:
            writer.execute("PRAGMA journal_mode = WAL")
            writer.execute("UPDATE ships SET name = 'Anna' WHERE id = 0")
            plan = self.plan(paths)
            for tile in plan.tiles:
                tile_join.all_of(plan, tile)
        expected = self.single(Question("ships", 60.0, now=60.0), ships=(SHIPS, rows))
        merge(self.out, self.folder / "all.db")
        with closing(sqlite3.connect(self.folder / "all.db")) as db:
            self.assertEqual(db.execute("SELECT * FROM pairs").fetchall(), expected)

    def test_no_objects_are_no_rows(self):
        plan = self.plan(self.shards([]))
        self.assertEqual([result["rows"] for tile in plan.tiles for result in tile_join.all_of(plan, tile)], [0])

    def test_a_retry_within_a_handler_ships_as_much(self):
        plan = self.plan(self.shards(ships(300)), 1)
        try:
            raise ValueError("the engine's own failure")
        except ValueError:
            again = tile_join.join_tile(plan, plan.tiles[0])
        self.assertEqual(again["objects"], 300)

    def test_a_tile_over_twice_its_share_is_cut_and_asked_again(self):
        rows = ships(600)
        question = Question("ships", 60.0, now=60.0)
        plan = self.plan(self.shards(rows), 4, question, sample=12)
        plan.share, plan.tiles = 40.0, [tile._replace(objects=20.0) for tile in plan.tiles]
        for tile in plan.tiles:
            tile_join.all_of(plan, tile)
        self.assertTrue(list(self.out.glob("cut-*.json")))
        leaves = list(plan.leaves())
        self.assertGreater(len(leaves), len(plan.tiles))
        self.assertEqual({plan.pairs(tile) for tile in leaves}, set(self.out.glob("pairs-*.db")))
        self.assertEqual(self.of_tiles(), self.single(question, ships=(SHIPS, rows)))
        before = self.bytes_of(self.out)
        for tile in plan.tiles:
            tile_join.all_of(plan, tile)
        self.assertEqual(self.bytes_of(self.out), before)

    def test_a_tile_of_one_spot_is_joined_whole(self):
        plan = self.plan([self.shard(f"spot-{part}.db", ships=("id, x, y, r", [(10 * part + i, 5, 5, 1) for i in range(10)])) for part in (0, 1)])
        plan.share = 1.0
        self.assertEqual([result["rows"] for tile in plan.tiles for result in tile_join.all_of(plan, tile)], [190])

    def test_two_writers_of_a_tile_write_the_same(self):
        plan = self.plan(self.shards(ships(300)), 1)
        command = [sys.executable, "-m", "foresee_dask.tile_join", self.out, "00000"]
        both = [subprocess.Popen(command, env=fleet.environment(), stdout=subprocess.DEVNULL) for _ in range(2)]
        self.assertEqual([one.wait(60) for one in both], [0, 0])
        first = self.bytes_of(self.out)
        plan.pairs(plan.tiles[0]).unlink()
        tile_join.join_tile(plan, plan.tiles[0])
        self.assertEqual(self.bytes_of(self.out), first)
        self.assertEqual(sorted(file.name for file in self.out.iterdir()), ["pairs-00000.db", "plan.json"])


if __name__ == "__main__":
    main()
