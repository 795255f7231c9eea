"""Where are the objects? Opens shards read-only, tells what each holds, and refuses those that do not fit together.

A shard is a SQLite file with the table as moving_objects; each object is in one of them. What a shard holds is known by the `stamp` of its
table, which every change makes anew. Cost: one scan of the ids a shard; they are compared one by one only where the ranges of two overlap.
"""
import heapq
import os
import socket
import sqlite3
import sys
from contextlib import closing, contextmanager
from pathlib import Path
from urllib.parse import quote

from . import Refusal
from .question import quoted


def connect(extension, database=":memory:"):
    db = sqlite3.connect(database, isolation_level=None, uri=True)
    if not hasattr(db, "enable_load_extension"):
        raise Refusal(f"{sys.executable} cannot load extensions into SQLite: write /usr/bin/python3")
    db.enable_load_extension(True)
    try:
        db.load_extension(str(extension))
    except sqlite3.Error as error:
        raise Refusal(f"{extension} cannot be loaded on {socket.gethostname()}: {error}") from None
    db.enable_load_extension(False)
    return db


def commit(db):
    """Version and commit of the extension: one for all that take part."""
    return ", ".join(line for line in db.execute("SELECT foresee_debug()").fetchone()[0].splitlines() if line[:6] in ("Versio", "Commit"))


@contextmanager
def attached(db, path):
    """The shard as schema `shard`, read-only, in one read transaction."""
    try:
        db.execute("ATTACH ? AS shard", (f"file:{quote(str(path))}?mode=ro",))
    except sqlite3.Error as error:
        raise Refusal(f"{path} cannot be opened: {error if Path(path).exists() else 'there is no such file'}") from None
    try:
        db.execute("BEGIN")
        yield
        db.commit()
    except BaseException:
        db.rollback()
        raise
    finally:
        db.execute("DETACH shard")


@contextmanager
def reading(db, path):
    """`attached`, for questions before the tiles: what goes wrong there is wrong with the shard."""
    try:
        with attached(db, path):
            yield
    except sqlite3.Error as error:
        raise Refusal(f"{path} cannot be read: {error}") from None


# A table in degrees is joined on its plane: by the hidden columns that hold it, bit for bit, in a plain table. So is one on the globe:
# in place of lat, lon and z there are x, y, z, which gx, gy, gz hold, and in place of speed, course and vz velocity and acceleration.
ON_THE_PLANE = {"lat": "x", "lon": "y", "speed": "vx", "course": "vy"}
ON_THE_GLOBE = {"lat": ("x", "y", "z"), "lon": (), "z": (), "speed": ("vx", "vy", "vz", "ax", "ay", "az"), "course": (), "vz": ()}


def tables_of(db, tables):
    """{table: {'columns', 'stamp', 'objects', 'frame'}} of those tables that the attached shard has."""
    there = {name.lower(): (frame, origin) for name, frame, origin in db.execute("SELECT name, frame, origin FROM foresee_tables('shard')")}
    found = {}
    for table in tables:
        if table.lower() in there:
            found[table] = dict(db.execute(f"SELECT key, value FROM shard.{quoted(table + '_meta')} WHERE key IN ('columns', 'stamp', 'objects')"))
            found[table]["columns"] = _declared(db, table, found[table]["columns"])
            found[table]["frame"] = there[table.lower()]
    return found


def _declared(db, table, stored):
    """The columns of `_meta` without those that a table stores but does not declare: t of plans."""
    declared = {name.lower() for name, in db.execute("SELECT name FROM pragma_table_xinfo(?, 'shard')", (table,))}
    return ", ".join(column for column in map(str.strip, stored.split(",")) if column[0] == "+" or column.lower() in declared)


def look(extension, path, tables):
    """What the shard holds now, without reading its objects."""
    with closing(connect(extension)) as db, reading(db, path):
        return {"path": str(path), "tables": tables_of(db, tables)}


# `now` of a join without one: the newest t. An object with that t exists then, so that its row says `now`.
NEWEST = "SELECT now FROM predictive_sweep(0, ?, NULL, NULL, NULL, 'shard') LIMIT 1"


def survey(extension, shard, newest):
    """`look`, and of every table the range of its ids and, with `newest`, its newest t: that of plans is no column."""
    tables = {}
    with closing(connect(extension)) as db, reading(db, shard["path"]):
        for table, of in shard["tables"].items():
            first, last = db.execute(f"SELECT min(id), max(id) FROM shard.{quoted(table)}").fetchone()
            now = db.execute(NEWEST, (table,)).fetchone() if newest else None       # without objects there is no row
            tables[table] = {**of, "first": first, "last": last, "newest": now and now[0]}
    return {**shard, "tables": tables}


def columns_of(declared):
    """The motion columns, and those with +, of 'id, x, y, +name'."""
    columns = [column.strip() for column in declared.split(",")]
    return [c for c in columns if c[0] != "+"], [c[1:] for c in columns if c[0] == "+"]


def declaration(shards, table, carried):
    """What `table` is made of in every shard that has it: its motion columns."""
    having = [shard for shard in shards if table in shard["tables"]]
    if not having:
        raise Refusal(f"no shard has a moving_objects table {table}")
    first = having[0]["tables"][table]["columns"]
    for shard in having:
        motion, plus = columns_of(shard["tables"][table]["columns"])
        if motion != columns_of(first)[0]:
            raise Refusal(f"declarations of {table} differ: {having[0]['path']} has ({', '.join(columns_of(first)[0])}),"
                          f" {shard['path']} has ({', '.join(motion)})")
        for column in carried:
            if column not in plus:
                raise Refusal(f"{shard['path']}: {table} has no column +{column}")
    columns = columns_of(first)[0]
    if len(shards) > 1 and "lat" in columns and "plan" in columns:
        raise Refusal(f"{having[0]['path']}: {table} has plans in degrees, which several shards cannot join: write them in metres,"
                      " by geo_to_plane, or all rows into one file")
    if on_globe(having[0], table):
        return [axis for column in columns for axis in ON_THE_GLOBE.get(column, (column,))]
    return [ON_THE_PLANE[column] if "lat" in columns and column in ON_THE_PLANE else column for column in columns]


def on_globe(shard, table):
    return shard["tables"][table]["frame"][0] == "globe"


def stored(shard, table, column):
    """The column of the shard's table that holds a column of the plain one."""
    return "g" + column if on_globe(shard, table) and column in ON_THE_GLOBE["lat"] + ON_THE_GLOBE["speed"] else column


def refuse_other_frames(shards):
    """Metres of one table or shard that are not those of another: two origins, degrees beside metres, two texts of `frame`."""
    first = None
    for shard in shards:
        for table, of in shard["tables"].items():
            frame, origin = of["frame"]
            if frame == "degrees" and origin is None:
                continue        # an empty table that has not chosen its origin
            named = f"origin '{origin}'" if origin else "no frame" if frame == "plane" else f"frame '{frame}'"
            if first is None:
                first = named, table, shard["path"]
            elif named != first[0]:
                raise Refusal(f"coordinates do not match: {first[1]} of {first[2]} has {first[0]}, {table} of {shard['path']} has {named}; "
                              "create all of them with one origin or frame")


def refuse_twice(paths):
    """A file that is given twice, under whatever names."""
    seen = {}
    for path in paths:
        try:
            status = os.stat(path)
        except OSError:
            raise Refusal(f"{path} cannot be opened: there is no such file") from None
        same = status.st_dev, status.st_ino
        if same in seen:
            raise Refusal(f"a shard is given twice: {seen[same]} and {path}")
        seen[same] = path


def refuse_shared_ids(extension, shards, table):
    """Compares ids shard by shard where their ranges overlap."""
    ranges = sorted((shard["tables"][table]["first"], shard["tables"][table]["last"], shard["path"])
                    for shard in shards if table in shard["tables"] and shard["tables"][table]["first"] is not None)
    group, last = [], None
    for first, end, path in [*ranges, (float("inf"), None, None)]:
        if group and first > last:
            _refuse_shared(extension, group, table)
            group = []
        group.append(path)
        last = end if last is None or not group[1:] else max(last, end)


def _refuse_shared(extension, paths, table):
    def ids(path):
        db = connect(extension, f"file:{quote(path)}?mode=ro")
        return ((id, path) for id, in db.execute(f"SELECT id FROM {quoted(table)} ORDER BY id"))

    if len(paths) < 2:
        return
    before = (None, None)
    for id, path in heapq.merge(*map(ids, paths)):
        if id == before[0]:
            raise Refusal(f"{table}: id {id} is in two shards: {before[1]} and {path}")
        before = id, path
