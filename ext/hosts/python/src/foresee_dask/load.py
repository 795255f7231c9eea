"""How do plain tables, CSV and Parquet become shards? Each is loaded into a foresee file beside the answer, once.

Columns are known by their names: those of moving_objects are motion, others are left out, id comes first whatever their order. A file that
is loaded already and has not changed since (size, time) is not loaded again. Parquet needs pyarrow. What is empty in CSV is NULL.
"""
import csv
import hashlib
import os
import sqlite3
from contextlib import closing
from pathlib import Path
from urllib.parse import quote

from . import Refusal
from .files import appearing
from .question import quoted
from .shards import ON_THE_PLANE, connect

MOTION = ("id", "t", "x", "y", "z", "vx", "vy", "vz", "ax", "ay", "az", "fx", "fy", "fz", "m", "hx", "hy", "hz", "r", "shape", "heading",
          "growth", "growth_z", "until", "lat", "lon", "speed", "course", "plan", "category", "mask")


def as_shards(extension, paths, tables, folder):
    """`paths` with those that are no foresee files replaced by what they were loaded into."""
    return [_as_shard(extension, Path(path).resolve(), tables, folder) for path in paths]


def _as_shard(extension, path, tables, folder):
    if not path.exists():
        raise Refusal(f"{path} cannot be opened: there is no such file")
    if path.suffix == ".csv":
        return _loaded(extension, path, tables[0], folder, _csv)
    if path.suffix == ".parquet":
        return _loaded(extension, path, tables[0], folder, _parquet)
    try:
        with closing(sqlite3.connect(f"file:{quote(str(path))}?mode=ro", uri=True)) as db:
            plain = {name.lower() for name, in db.execute("SELECT name FROM sqlite_master WHERE sql LIKE 'CREATE TABLE%'")}
    except sqlite3.Error as error:
        raise Refusal(f"{path} cannot be read: {error}") from None
    for table in tables:
        if table.lower() in plain:
            return _loaded(extension, path, table, folder, lambda path: _plain(path, table))
    return path


def _csv(path):
    with open(path, newline="", encoding="utf-8-sig") as file:
        rows = csv.reader(file)
        yield next(rows, [])
        yield from ([value or None for value in row] for row in rows)


def _plain(path, table):
    with closing(sqlite3.connect(f"file:{quote(str(path))}?mode=ro", uri=True)) as db:
        rows = db.execute(f"SELECT * FROM {quoted(table)}")
        yield [column[0] for column in rows.description]
        yield from rows


def _parquet(path):
    try:
        from pyarrow.parquet import ParquetFile
    except ImportError:
        raise Refusal(f"{path}: Parquet needs pyarrow, which this Python does not have; write CSV or SQLite") from None
    file = ParquetFile(path)
    yield file.schema_arrow.names
    for batch in file.iter_batches():
        yield from zip(*(column.to_pylist() for column in batch.columns))


def _loaded(extension, path, table, folder, read):
    status = os.stat(path)
    mark = hashlib.sha256(f"{path} {table} {status.st_size} {status.st_mtime_ns}".encode()).hexdigest()[:12]
    target = Path(folder).resolve() / "shards" / f"{path.stem}-{mark}.db"
    if target.exists():
        return target
    target.parent.mkdir(parents=True, exist_ok=True)
    rows = read(path)
    names = [name.strip().lower() for name in next(rows)]
    motion = [name for name in MOTION if name in names and name not in ON_THE_PLANE]
    if "x" not in motion and "lat" in names:
        raise Refusal(f"{path}: x and y are needed; load lat, lon into a foresee file, where a table has an origin")
    if "id" not in motion or "x" not in motion:
        raise Refusal(f"{path}: id and x are needed; its columns are {', '.join(names) or 'none'}")
    places = [names.index(name) for name in motion]
    with appearing(target) as hidden, closing(connect(extension, hidden)) as db:
        try:
            db.execute("PRAGMA journal_mode = OFF")
            db.execute("BEGIN")
            db.execute(f"CREATE VIRTUAL TABLE {quoted(table)} USING moving_objects({', '.join(motion)})")
            db.executemany(f"INSERT INTO {quoted(table)} VALUES ({', '.join('?' * len(motion))})",
                           ([row[place] for place in places] for row in rows if row))
            db.execute("COMMIT")
        except IndexError:
            raise Refusal(f"{path}: a row has fewer values than the header has names") from None
        except sqlite3.Error as error:
            if "disk is full" in str(error):
                raise
            raise Refusal(f"{path}: {error}") from None
    return target
