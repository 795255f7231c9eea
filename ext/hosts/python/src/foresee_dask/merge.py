"""How do the tiles' files become one table? Sorted by a and b as each of them is, so that they are merged as they are read.

    merge("pairs/", "pairs.db")      # table pairs, PRIMARY KEY(a, b)

All tiles must be there. Cost: some microseconds a row, and a few kilobytes of memory a tile.
"""
import heapq
import resource
import sqlite3
from contextlib import ExitStack, closing
from operator import itemgetter
from pathlib import Path
from urllib.parse import quote

from . import Refusal
from .files import appearing
from .plan import read
from .tile_join import done


def missing(plan):
    return [tile.name for tile in plan.leaves() if not plan.pairs(tile).exists()]


def merge(folder, target):
    """Rows written."""
    plan = read(folder)
    if plan is None:
        raise Refusal(f"{folder} holds no plan.json")
    if Path(target).exists():
        raise Refusal(f"{target} is there already")
    absent = missing(plan)
    if absent:
        raise Refusal(f"{folder} is not whole: {len(absent)} tiles are missing, {absent[0]} among them; run join once more")
    tiles = list(plan.leaves())
    rows = sum(done(plan, tile)["rows"] for tile in tiles)
    _allow_files(len(tiles) + 64)
    with appearing(target) as hidden, ExitStack() as open_files:
        db = open_files.enter_context(closing(sqlite3.connect(hidden, isolation_level=None)))
        db.execute("PRAGMA journal_mode = OFF")
        db.execute("PRAGMA synchronous = OFF")
        db.execute("BEGIN")
        db.execute(plan.question.pairs_table())

        def rows_of(tile):
            part = open_files.enter_context(closing(sqlite3.connect(f"file:{quote(str(plan.pairs(tile)))}?mode=ro", uri=True)))
            part.execute("PRAGMA cache_size = -64")
            return part.execute("SELECT * FROM pairs ORDER BY a, b")

        places = ", ".join("?" * (2 + len(plan.question.columns)))
        try:
            db.executemany(f"INSERT INTO pairs VALUES ({places})", heapq.merge(*map(rows_of, tiles), key=itemgetter(0, 1)))
        except sqlite3.IntegrityError:
            raise Refusal(f"{folder} is damaged: a pair is in two tiles") from None
        db.execute("COMMIT")
    return rows


def _allow_files(count):
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    if soft != resource.RLIM_INFINITY and soft < count:
        if hard != resource.RLIM_INFINITY and hard < count:
            raise Refusal(f"{count} files are needed at once, {hard} are allowed: raise it with ulimit -n")
        resource.setrlimit(resource.RLIMIT_NOFILE, (count, hard))
