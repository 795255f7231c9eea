"""One tile: ships to it what it needs, joins, writes one file. By itself, from any engine:

    python3 -m foresee_dask.tile_join pairs/ 00017       # tile 00017 of pairs/plan.json; all of them without a name

A tile that is done is left alone; two at once write the same bytes. Of one shard nothing is shipped: the file itself is asked, read-only.
A tile over twice its share is not joined but cut. Cost: docs/how-to/tiles_on_dask.md.
"""
import json
import socket
import sqlite3
import sys
from contextlib import closing, contextmanager, nullcontext
from math import ceil, inf
from urllib.parse import quote

from . import Refusal, in_one_line, plan as plans, shards, tiles
from .files import appearing, write_text
from .question import quoted


BOX = '"box x0", "box x1", "box y0", "box y1"'     # no column of the data is called that


def join_tile(plan, tile):
    """{'name', 'objects', 'rows'} of the tile's file, or {'cut'}: the tiles to be asked in its place."""
    parts = plan.parts(tile)
    if parts is not None:
        return {"cut": parts}
    if plan.pairs(tile).exists():
        return done(plan, tile)
    with closing(shards.connect(plan.extension)) as db:
        check_commit(plan, db)
        db.execute(f"PRAGMA threads = {plan.threads}")
        if len(plan.shards) == 1:
            return _answer(plan, tile, db, "shard", None, _unchanged(db, plan.shards[0]))
        objects = _collect(plan, tile, db)
        parts = _parts(plan, tile, db, objects)
        if len(parts) > 1:
            write_text(plan.path(f"cut-{tile.name}.json"), json.dumps(parts))
            return {"cut": parts}
        _load(plan, db)
        return _answer(plan, tile, db, "main", objects, nullcontext())


def check_commit(plan, db):
    commit = shards.commit(db)
    if commit != plan.commit:
        raise Refusal(f"{plan.extension} on {socket.gethostname()} is {commit}, that of the run {plan.commit}: one commit for all")


@contextmanager
def _unchanged(db, shard):
    """The shard attached, as it was when the run began: another state could lose pairs between tiles."""
    with shards.attached(db, shard["path"]):
        now = shards.tables_of(db, shard["tables"])
        if any(now.get(table, {}).get("stamp") != of["stamp"] for table, of in shard["tables"].items()):
            raise Refusal(f"shard {shard['path']} has changed since the run began: copy it with VACUUM INTO, and join the copy")
        yield


def _collected(table):
    return quoted(table + " collected")


def _collect(plan, tile, db):
    """What the tile needs of every shard in turn, with its boxes. Collected first, since a table is loaded best in one transaction; in the order of
    the sweeps, since a key by id would cost more than all else here."""
    where, bounds = tiles.meets(tile, plan.axes())
    for table in plan.declared:
        columns = plan.columns(table)
        db.execute(f"CREATE TABLE {_collected(table)}({', '.join(columns)}, {BOX})")
        sweep, inputs = plan.question.sweep(table, "shard")
        for shard in plan.shards:
            if table in shard["tables"]:
                with _unchanged(db, shard):
                    db.execute(f"INSERT INTO main.{_collected(table)} SELECT {', '.join('o.' + shards.stored(shard, table, c) for c in columns)}, b.x0, b.x1, b.y0, b.y1"
                               f" FROM {sweep} b CROSS JOIN shard.{quoted(table)} o ON o.id = b.id WHERE {where}", (*inputs, *bounds))
    return sum(db.execute(f"SELECT count(*) FROM {_collected(table)}").fetchone()[0] for table in plan.declared)


def _parts(plan, tile, db, objects):
    if objects <= 2 * max(tile.objects, plan.share):
        return []
    every = ceil(objects / tiles.SAMPLE)
    boxes = [(x0, x1, -inf if y0 is None else y0, inf if y1 is None else y1, side) for side, table in enumerate(plan.declared)
             for x0, x1, y0, y1 in db.execute(f"SELECT {BOX} FROM {_collected(table)} ORDER BY id")][::every]
    return tiles.cut(boxes, ceil(objects / plan.share), objects, tiles.PAIR_SHIPPED, len(plan.declared) > 1, tile)


def _load(plan, db):
    for table, motion in plan.declared.items():
        columns = ", ".join(plan.columns(table))
        carried = ["+" + quoted(name) for name in plan.question.carried(table)]
        db.execute("BEGIN")
        db.execute(f"CREATE VIRTUAL TABLE {quoted(table)} USING moving_objects({', '.join(motion + carried)})")
        db.execute(f"INSERT INTO {quoted(table)}({columns}) SELECT {columns} FROM {_collected(table)}")
        db.execute(f"DROP TABLE {_collected(table)}")
        db.execute("COMMIT")


def _answer(plan, tile, db, schema, objects, source):
    """Writes the tile's file, asking within `source`; nothing in it depends on who writes it."""
    select, inputs = plan.question.rows(schema, tile.bounds())
    with appearing(plan.pairs(tile)) as hidden:
        db.execute("ATTACH ? AS answer", (str(hidden),))
        try:
            for setting in ("journal_mode = MEMORY", "synchronous = OFF"):
                db.execute(f"PRAGMA answer.{setting}")
            with source:
                db.execute(plan.question.pairs_table("answer"))
                rows = db.execute(f"INSERT INTO answer.pairs {select}", inputs).rowcount
                db.execute("CREATE TABLE answer.tile(name, own_x0, own_x1, own_y0, own_y1, objects, rows, fingerprint)")
                db.execute("INSERT INTO answer.tile VALUES (?, ?, ?, ?, ?, ?, ?, ?)",
                           (tile.name, *tile.bounds(), objects, rows, plan.fingerprint()))
        finally:
            db.execute("DETACH answer")
    return {"name": tile.name, "objects": objects, "rows": rows}


def done(plan, tile):
    """What the tile's file says of itself."""
    path = plan.pairs(tile)
    try:
        with closing(sqlite3.connect(f"file:{quote(str(path))}?mode=ro", uri=True)) as db:
            objects, rows, of = db.execute("SELECT objects, rows, fingerprint FROM tile").fetchone()
    except (sqlite3.Error, TypeError) as error:
        raise Refusal(f"{path} cannot be read: {error}; remove it, and it is made anew") from None
    if of != plan.fingerprint():
        raise Refusal(f"{path} is of another answer than plan.json beside it: give --out another folder")
    return {"name": tile.name, "objects": objects, "rows": rows}


def all_of(plan, tile):
    """The tile, or one after another those into which it is cut."""
    result = join_tile(plan, tile)
    if "cut" not in result:
        return [result]
    return [one for part in result["cut"] for one in all_of(plan, part)]


def main(folder, *names):
    plan = plans.read(folder)
    if plan is None:
        raise Refusal(f"{folder} holds no plan.json: write one with foresee_dask plan")
    known = {tile.name: tile for tile in plan.tiles}
    for name in names or known:
        if name not in known:
            raise Refusal(f"there is no tile {name}; there are {min(known)} to {max(known)}")
        for result in all_of(plan, known[name]):
            print("{name}: {rows} rows".format(**result), flush=True)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit("usage: python3 -m foresee_dask.tile_join FOLDER [TILE ...]")
    in_one_line(main, *sys.argv[1:])
