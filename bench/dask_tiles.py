#!/usr/bin/python3
"""Joins in tiles by foresee_dask against one join of one file: time, memory, and that the rows are the same to the bit.

    /usr/bin/python3 bench/dask_tiles.py [--objects 2000000] [--shards 4] [--workers 1,2] [--tiles 16] [--scene boxes | hulls]

The scene is S of workloads.h: a plane of side sqrt(14 n), |v| <= 3, horizon 3, half extents 0.5 and |a| <= 0.5, or 50 hulls of that size
that turn instead; about a pair an object. Each step is a process of its own: seconds by the clock, seconds of all its processors, megabytes of
the largest process. `speed-up` is the first row of workers against each; with fewer free cores than workers it says nothing, and the seconds of
processors still say what workers cost. `tile` compares shipping and joining one tile with loading its rows from a plain table and joining them.
Ends with status 1 if rows differ. --folder keeps the files in a folder, and uses those that it finds.
"""
import argparse
import os
import random
import shutil
import sqlite3
import sys
import tempfile
import time
from contextlib import closing
from heapq import merge
from math import cos, pi, sin, sqrt
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
SOURCES = ROOT / "ext/hosts/python/src"
sys.path.insert(0, str(SOURCES))
from foresee_dask import plan as plans, tile_join  # noqa: E402
from foresee_dask.question import Question  # noqa: E402

DECLARED = {"boxes": "id, x, y, vx, vy, ax, ay, hx, hy", "hulls": "id, x, y, vx, vy, shape, heading"}
QUESTION = Question("ships", 3.0, now=0.0)


def hull(number):
    corners = [(0.7 * cos(2 * pi * k / 7) * (1 + number / 200), 0.3 * sin(2 * pi * k / 7)) for k in (*range(7), 0)]
    return f"POLYGON(({', '.join(f'{x:.6f} {y:.6f}' for x, y in corners)}))"


def ships(scene, first, end, objects):
    """The objects first to end - 1: the same whichever others are asked for, drawn in blocks of 10000."""
    side, hulls = sqrt(14 * objects), [hull(number) for number in range(50)]
    for block in range(first // 10000, (end + 9999) // 10000):
        draw = random.Random(block).random
        for i in range(10000 * block, 10000 * (block + 1)):
            place = i, side * draw(), side * draw(), 6 * draw() - 3, 6 * draw() - 3
            more = (draw() - 0.5, draw() - 0.5, 0.5, 0.5) if scene == "boxes" else (hulls[int(50 * draw())], 360 * draw())
            if first <= i < end:
                yield (*place, *more)


class Bench:
    def __init__(self, given, folder):
        self.given, self.folder, self.wrong = given, folder, False
        self.shards = [folder / f"ships-{i}.db" for i in range(given.shards)]

    def open(self, path):
        db = sqlite3.connect(path, isolation_level=None)
        db.enable_load_extension(True)
        db.load_extension(str(Path(self.given.extension).resolve()))
        return db

    def step(self, what, function, *arguments):
        """Runs it in a process of its own; seconds by the clock, of processors, megabytes."""
        sys.stdout.flush()
        begun = time.monotonic()
        child = os.fork()
        if child == 0:
            try:
                function(*arguments)
                sys.stdout.flush()
                os._exit(0)
            except BaseException as error:
                print(f"{what}: {error}", file=sys.stderr, flush=True)
                os._exit(1)
        _, status, used = os.wait4(child, 0)
        if status != 0:
            sys.exit(f"{what} failed: {self.folder}/log may say why")
        clock, processor, memory = time.monotonic() - begun, used.ru_utime + used.ru_stime, used.ru_maxrss / 1024
        print(f"{what:<28} {clock:8.1f} s  {processor:8.1f} s of processors  {memory:7.0f} MB", flush=True)
        return clock, processor

    def load(self, path, first, end):
        if path.exists():
            return
        unfinished = path.with_suffix(".part")
        unfinished.unlink(missing_ok=True)
        with closing(self.open(unfinished)) as db:
            db.execute("PRAGMA synchronous = OFF")
            db.execute("BEGIN")
            columns = DECLARED[self.given.scene]
            db.execute(f"CREATE VIRTUAL TABLE ships USING moving_objects({columns})")
            db.executemany(f"INSERT INTO ships VALUES ({', '.join('?' * len(columns.split(',')))})",
                           ships(self.given.scene, first, end, self.given.objects))
            db.execute("COMMIT")
        unfinished.rename(path)

    def load_shards(self):
        n, k = self.given.objects, self.given.shards
        for i, path in enumerate(self.shards):
            self.load(path, n * i // k, n * (i + 1) // k)

    def whole(self, source, target):
        """The rows of one join, written as a tile's are."""
        target.unlink(missing_ok=True)
        with closing(self.open(source)) as db:
            self.write(db, target, (None,) * 4)

    def write(self, db, target, bounds):
        db.execute("ATTACH ? AS answer", (str(target),))
        db.execute("PRAGMA answer.synchronous = OFF")
        db.execute(QUESTION.pairs_table("answer"))
        select, inputs = QUESTION.rows("main", bounds)
        db.execute(f"INSERT INTO answer.pairs {select}", inputs)

    def in_tiles(self, workers, out, shards, tiles):
        command = [sys.executable, "-m", "foresee_dask", "join", "--extension", self.given.extension, "--table", "ships", "--horizon", "3",
                   "--now", "0", "--tiles", tiles, "--workers", workers, "--out", out, *shards]
        shutil.rmtree(out, ignore_errors=True)
        log = os.open(self.folder / "log", os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
        os.dup2(log, 1)
        os.dup2(log, 2)
        os.environ["PYTHONPATH"] = str(SOURCES)
        os.execv(sys.executable, [str(part) for part in command])

    def compare(self, out, target):
        """Row by row, in order."""
        plan = plans.read(out)

        def rows(path):
            db = sqlite3.connect(f"file:{path}?mode=ro", uri=True)
            return db.execute("SELECT * FROM pairs ORDER BY a, b")
        count = 0
        for ours, single in zip(merge(*(rows(plan.pairs(tile)) for tile in plan.leaves())), rows(target)):
            count += 1
            if ours != single:
                raise ValueError(f"{ours} in tiles, {single} in the whole")
        of_whole = sqlite3.connect(target).execute("SELECT count(*) FROM pairs").fetchone()[0]
        of_tiles = sum(tile_join.done(plan, tile)["rows"] for tile in plan.leaves())
        if not count == of_whole == of_tiles:
            raise ValueError(f"{of_tiles} rows in tiles, {of_whole} in the whole")
        copies = sum(tile_join.done(plan, tile)["objects"] or 0 for tile in plan.leaves()) / self.given.objects
        print(f"   {count} rows, the same in {len(list(plan.leaves()))} tiles; an object is in {copies:.3f} of them")

    def ship(self, plan, tile):
        plan.pairs(tile).unlink(missing_ok=True)
        result = tile_join.join_tile(plan, tile)
        print(f"   tile {tile.name}: {result['objects']} objects, {result['rows']} rows")

    def collect(self, plan, tile, path):
        """The tile's rows as a plain table: what somebody would load who had them."""
        path.unlink(missing_ok=True)
        with closing(self.open(path)) as db:
            collected = tile_join._collected("ships")
            tile_join._collect(plan, tile, db)
            db.execute(f"ALTER TABLE {collected} RENAME TO rows")

    def load_and_join(self, rows, bounds):
        with closing(self.open(":memory:")) as db:
            columns = DECLARED[self.given.scene]
            db.execute("ATTACH ? AS had", (str(rows),))
            db.execute(f"CREATE VIRTUAL TABLE ships USING moving_objects({columns})")
            db.execute(f"INSERT INTO ships SELECT {columns} FROM had.rows ORDER BY id")
            target = self.folder / "loaded.db"
            target.unlink(missing_ok=True)
            self.write(db, target, bounds)

    def run(self):
        given = self.given
        print(f"{given.objects} {given.scene}, {given.shards} shards, {given.tiles} tiles, {os.cpu_count()} cores, load {os.getloadavg()[0]:.1f}")
        single, target = self.folder / "single.db", self.folder / "whole.db"
        self.step("load the shards", self.load_shards)
        self.step("load one file", self.load, single, 0, given.objects)
        whole = self.step("the whole, one file", self.whole, single, target)
        first = None
        for workers in given.workers:
            out = self.folder / f"pairs-{workers}"
            cost = self.step(f"tiles, {workers} workers", self.in_tiles, workers, out, self.shards, given.tiles)
            first = first or cost
            print(f"   speed-up {first[0] / cost[0]:.2f}; processors {cost[1] / first[1]:.2f} x those of {given.workers[0]},"
                  f" {cost[1] / whole[1]:.2f} x the whole's")
        self.step("compare", self.compare, out, target)
        cost = self.step("tiles of one file", self.in_tiles, given.workers[-1], self.folder / "pairs-one", [single], given.tiles)
        print(f"   processors {cost[1] / whole[1]:.2f} x the whole's")
        self.step("compare", self.compare, self.folder / "pairs-one", target)
        plan = plans.read(out)
        tile, rows = plan.tiles[len(plan.tiles) // 2], self.folder / "rows.db"
        self.step("collect a tile's rows", self.collect, plan, tile, rows)
        ratios = []
        for _ in range(3):
            shipped = self.step("tile: ship and join", self.ship, plan, tile)
            loaded = self.step("tile: load and join", self.load_and_join, rows, tile.bounds())
            ratios.append(shipped[1] / loaded[1])
        print(f"   shipped and joined: {sorted(ratios)[1]:.2f} x loaded and joined (processors, median of 3)")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--objects", type=int, default=2_000_000)
    parser.add_argument("--shards", type=int, default=4)
    parser.add_argument("--tiles", type=int, default=16)
    parser.add_argument("--workers", type=lambda text: [int(n) for n in text.split(",")], default=[1, 2])
    parser.add_argument("--scene", choices=sorted(DECLARED), default="boxes")
    parser.add_argument("--extension", default=str(ROOT / "build/release/foresee.so"))
    parser.add_argument("--folder")
    given = parser.parse_args()
    folder = Path(given.folder or tempfile.mkdtemp(prefix="foresee-bench-"))
    folder.mkdir(parents=True, exist_ok=True)
    try:
        Bench(given, folder).run()
    finally:
        if not given.folder:
            shutil.rmtree(folder)


if __name__ == "__main__":
    main()
