"""What the tests of foresee_dask share: fleets in shards, the single join to compare with, the command line."""
import os
import random
import shutil
import signal
import sqlite3
import subprocess
import sys
import tempfile
import unittest
from contextlib import closing
from pathlib import Path
from unittest import mock

from hosts import BUILD, ROOT, main, skip  # noqa: F401

PACKAGE = ROOT / "ext/hosts/python/src"
EXTENSION = Path(os.environ.get("FORESEE_EXTENSION", BUILD / "foresee.so")).resolve()
sys.path.insert(0, str(PACKAGE))
sys.dont_write_bytecode = True

from foresee_dask import files  # noqa: E402

# Hundreds of small files are made here; what the machine loses with its power is not tested.
files.to_disk = lambda path: None

SHIPS = "id, t, x, y, vx, vy, r, +name TEXT"


def ships(count, seed=1):
    """Crowded enough that most of them meet somebody."""
    chance = random.Random(seed)
    side = 60 * count ** 0.5
    return [(i, chance.choice((0, 2.5, 60)), chance.uniform(0, side), chance.uniform(0, side), chance.uniform(-8, 8), chance.uniform(-8, 8), 20,
             f"ship {i}") for i in range(count)]


class Fleet(unittest.TestCase):
    """A test with a folder of its own, and foresee in every connection that it opens."""

    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="foresee-scale-"))
        self.addCleanup(shutil.rmtree, self.folder)
        self.out = self.folder / "pairs"
        here = mock.patch.dict(os.environ, TMPDIR=str(self.folder))     # who is killed leaves Dask's files
        here.start()
        self.addCleanup(here.stop)
        if not EXTENSION.exists():
            skip("joins in tiles", f"{EXTENSION} is not built")
        if not hasattr(sqlite3.connect(":memory:"), "enable_load_extension"):
            skip("joins in tiles", f"{sys.executable} has no enable_load_extension")

    def open(self, path=":memory:"):
        db = sqlite3.connect(path, isolation_level=None)
        db.enable_load_extension(True)
        db.load_extension(str(EXTENSION))
        return db

    def shard(self, name, **tables):
        """A file with moving_objects tables: {name: (declaration, rows)}."""
        path = self.folder / name
        with closing(self.open(path)) as db:
            db.execute("PRAGMA synchronous = OFF")
            db.execute("BEGIN")
            for table, (declared, rows) in tables.items():
                db.execute(f"CREATE VIRTUAL TABLE {table} USING moving_objects({declared})")
                places = ", ".join("?" * len([part for part in declared.split(",") if "=" not in part]))
                db.executemany(f"INSERT INTO {table} VALUES ({places})", rows)
            db.execute("COMMIT")
        return path

    def shards(self, rows, count=3, declared=SHIPS):
        return [self.shard(f"ships-{i}.db", ships=(declared, rows[i::count])) for i in range(count)]

    def single(self, question, **tables):
        """The rows of the single join of all in one table."""
        path = self.shard("single.db", **tables)
        with closing(self.open(path)) as db:
            rows = db.execute(*question.rows("main", (None,) * 4)).fetchall()
        path.unlink()
        return rows

    def of_tiles(self, folder=None):
        """All rows of the tiles' files; each file is sorted."""
        rows = []
        for file in sorted((folder or self.out).glob("pairs-*.db")):
            with closing(sqlite3.connect(file)) as db:
                part = db.execute("SELECT * FROM pairs").fetchall()
            self.assertEqual([row[:2] for row in part], sorted(row[:2] for row in part))
            rows += part
        return sorted(rows, key=lambda row: row[:2])

    def bytes_of(self, folder):
        return {file.name: file.read_bytes() for file in folder.glob("pairs-*.db")}

    def command(self, *arguments, before=(), prefix=(), **options):
        """The command line, as users write it."""
        return subprocess.run([*prefix, sys.executable, *(before or ("-m", "foresee_dask")), *map(str, arguments)], text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=120, env=environment(), **options)

    def refused(self, *arguments, **options):
        """What the command says, which must be one line and end with status 1."""
        done = self.command(*arguments, **options)
        self.assertEqual(done.returncode, 1, done.stderr)
        said = [line for line in done.stderr.splitlines() if " tiles, " not in line]
        self.assertEqual(len(said), 1, done.stderr)
        self.assertTrue(said[0].startswith("foresee_dask: "), said[0])
        return said[0]

    def asking(self, *more, out=None, horizon=60):
        return ("--extension", EXTENSION, "--table", "ships", "--horizon", horizon, "--out", out or self.out, *more)


def here(function, arguments):
    return [function(*one) for one in arguments]


def environment():
    return {**os.environ, "PYTHONPATH": str(PACKAGE), "PYTHONDONTWRITEBYTECODE": "1"}


def children(process):
    """The worker processes that a command has begun."""
    try:
        pids = [int(pid) for thread in Path(f"/proc/{process.pid}/task").iterdir() for pid in (thread / "children").read_text().split()]
        return [pid for pid in pids if b"spawn_main" in Path(f"/proc/{pid}/cmdline").read_bytes()]
    except FileNotFoundError:
        return []


def kill(pids):
    """How many of them were alive."""
    killed = 0
    for pid in pids:
        try:
            os.kill(pid, signal.SIGKILL)
            killed += 1
        except ProcessLookupError:
            pass
    return killed
