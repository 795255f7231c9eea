"""FILE.db of the commands: opened with foresee in it, with the tables that keep the positions of feed and of readers.

    db = opened("fleet.db", create=True)
    with committed(db): db.execute("INSERT …")

foresee_feed(tbl, line, messages, origin): per table the last committed line of standard input, how many messages of a broker were
committed, and the origin of a table in metres.
foresee_messages(tbl, session, mid, digest, number): per table and session of a broker the last messages that were committed.
foresee_readers(watch, reader, seq, created): per watch and reader the last change that was delivered, and which watch of this name it is.
"""
import os
import sqlite3
import time
from contextlib import contextmanager
from typing import NamedTuple, Optional

from . import connect
from .process import Refusal

BUSY_SECONDS = 30


def quoted(name):
    return '"' + name.replace('"', '""') + '"'


def opened(path, create=False, **options):
    """A connection in autocommit. The file is in WAL mode, so that a writer and readers do not wait for each other."""
    if not create and not os.path.exists(path):
        raise Refusal(f"there is no file {path}; feed creates it")
    try:
        db = connect(path, isolation_level=None, timeout=BUSY_SECONDS, **options)
    except sqlite3.OperationalError as error:
        raise Refusal(f"{path} cannot be opened: {error}") from None
    try:
        db.execute("PRAGMA schema_version").fetchone()      # reads the file
        if create:
            db.execute("PRAGMA journal_mode = WAL").fetchone()
            db.execute("CREATE TABLE IF NOT EXISTS foresee_feed(tbl TEXT PRIMARY KEY, line INTEGER NOT NULL DEFAULT 0, "
                       "messages INTEGER NOT NULL DEFAULT 0, origin TEXT)")
            db.execute("CREATE TABLE IF NOT EXISTS foresee_messages(tbl TEXT, session TEXT, mid INTEGER, digest BLOB, number INTEGER, "
                       "PRIMARY KEY(tbl, session, mid)) WITHOUT ROWID")
        return db
    except BaseException as error:
        db.close()
        if isinstance(error, sqlite3.DatabaseError) and "not a database" in str(error):
            raise Refusal(f"{path} is no SQLite file; write the name of another file") from None
        raise


def is_busy(error):
    return "locked" in str(error) or "busy" in str(error)


def begun(db, patience=BUSY_SECONDS):
    """Starts a transaction for writing as soon as no other connection has one; False where that takes longer than `patience`.

    SQLite's own waiting sleeps longer and longer, up to 100 ms, and misses the short gaps between the transactions of a feed.
    """
    give_up = time.monotonic() + patience
    db.execute("PRAGMA busy_timeout = 0")
    try:
        while True:
            try:
                db.execute("BEGIN IMMEDIATE")
                return True
            except sqlite3.OperationalError as error:
                if not is_busy(error):
                    raise
                if time.monotonic() >= give_up:
                    return False
                time.sleep(0.0005)
    finally:
        db.execute(f"PRAGMA busy_timeout = {1000 * BUSY_SECONDS}")


@contextmanager
def committed(db):
    """A transaction for writing. A COMMIT that finds readers in the way is repeated."""
    if not begun(db):
        raise Refusal(f"the file is locked by another program for more than {BUSY_SECONDS} seconds")
    try:
        yield
        give_up = time.monotonic() + BUSY_SECONDS
        while True:
            try:
                db.execute("COMMIT")
                return
            except sqlite3.OperationalError as error:
                if not is_busy(error) or time.monotonic() > give_up:
                    raise
                time.sleep(0.01)
    except BaseException:
        if db.in_transaction:
            db.execute("ROLLBACK")
        raise


@contextmanager
def one_state(db):
    """Several SELECTs that see the same state of the file."""
    db.execute("BEGIN")
    try:
        yield
    finally:
        db.execute("COMMIT")


class Watch(NamedTuple):
    """What predictive_watches says of a watch."""
    name: str
    tbl: str
    other: Optional[str]
    horizon: float
    within: float
    within_z: Optional[float]
    now: float
    seq: int
    oldest: int
    fault: Optional[str]
    created: Optional[int]


def watch_of(db, name):
    """The Watch of this name."""
    row = db.execute(f"SELECT {', '.join(Watch._fields)} FROM predictive_watches('main') WHERE lower(name) = lower(?)", (name,)).fetchone()
    if row is None:
        names = ", ".join(row[0] for row in db.execute("SELECT name FROM predictive_watches('main') ORDER BY name"))
        raise Refusal(f"there is no watch {name}; " + (f"watches here: {names}" if names else
                      f"CREATE VIRTUAL TABLE {name} USING predictive_watch(ships, horizon = 600, within = 926)"))
    return Watch(*row)
