"""The command alerts: follows a watch and prints a line per change, or sends it to a web server, at least once and in order.

    python3 -m foresee alerts fleet.db alerts
    python3 -m foresee alerts fleet.db alerts --json --webhook https://example.org/alerts

The number of the last change that was delivered is a row of the file (foresee_readers): a reader that is killed goes on behind it, and
repeats at most the changes that it was delivering. The first time a reader gets the whole watch as `+`.
"""
import json
import math
import os
import sqlite3
import sys
import time
from datetime import datetime, timezone

from .encounters import Encounters
from .files import begun, committed, is_busy, one_state, opened, watch_of
from .process import Refusal, Stop
from .webhook import Webhook

AT_ONCE = 1000          # changes that are read before they are delivered; the position moves after each such group


def say(text):
    print(f"foresee alerts: {text}", file=sys.stderr, flush=True)


class Reader:
    """The position of a reader of a watch. It is kept in the file, but need not be there at once: changes may come twice.

    A feed that never pauses holds the lock for writing most of the time. The position then waits for a gap, and delivery goes on.
    """

    def __init__(self, db, watch, name):
        self.db, self.watch, self.name = db, watch, name
        with committed(db):
            db.execute("CREATE TABLE IF NOT EXISTS foresee_readers(watch TEXT, reader TEXT, seq INTEGER NOT NULL, created INTEGER, "
                       "PRIMARY KEY(watch, reader))")
            if "created" not in [row[1] for row in db.execute("PRAGMA table_info(foresee_readers)")]:      # of an older version
                db.execute("ALTER TABLE foresee_readers ADD COLUMN created INTEGER")
            db.execute("INSERT OR IGNORE INTO foresee_readers VALUES (?, ?, 0, NULL)", (watch, name))
        # A position that is lost in a power failure repeats changes: it need not wait for the disk.
        db.execute("PRAGMA synchronous = NORMAL")
        self.position, self.created = db.execute("SELECT seq, created FROM foresee_readers WHERE watch = ? AND reader = ?",
                                                 (watch, name)).fetchone()
        self.saved = self.position, self.created

    def recognise(self, created):
        """A watch that was dropped and created again counts its changes from the start: nothing of it was read yet."""
        if created != self.created and self.position:
            say(f"{self.watch} was created again: the whole watch follows")
            self.position = 0
        self.created = created

    def move(self, position, patience=0.02):
        self.position = position
        self.save(patience)

    def save(self, patience):
        """Tries so many seconds to write the position."""
        if (self.position, self.created) == self.saved:
            return
        if begun(self.db, patience):
            self.db.execute("UPDATE foresee_readers SET seq = ?, created = ? WHERE watch = ? AND reader = ?",
                            (self.position, self.created, self.watch, self.name))
            try:
                self.db.execute("COMMIT")
                self.saved = self.position, self.created
            except sqlite3.OperationalError as error:      # a file without WAL, in which a reader is in the way
                self.db.execute("ROLLBACK")
                if not is_busy(error):
                    raise


def changes_after(db, reader, there):
    """(changes, position behind them, whether they are the whole watch, because the next ones are no longer kept)."""
    watch = reader.watch
    if there.fault and "damaged" in there.fault:
        raise Refusal(there.fault)
    reader.recognise(there.created)
    position, seq, oldest = reader.position, there.seq, there.oldest
    if position > seq or (position and position < oldest):
        say(f"{watch} has changes {oldest} to {seq}, and the position was {position}: the whole watch follows")
        position = 0
    if position == seq and seq:
        return [], position, False
    limit = -1 if position == 0 else AT_ONCE       # the whole watch has one position: its rows are delivered together
    rows = db.execute("SELECT seq, op, a, b, t, now FROM predictive_changes(?, ?) LIMIT ?", (watch, position, limit)).fetchall()
    return rows, rows[-1][0] if rows else seq, position == 0


def time_of(clock):
    """A date where the clock of the watch is Unix seconds."""
    if not 0 <= clock < 2e11:
        return f"{clock:.0f} s"
    return datetime.fromtimestamp(clock, timezone.utc).strftime("%Y-%m-%d %H:%M:%S")


def as_text(change):
    line = f"{time_of(change['now'])}  {change['op']}  {change['a_name']}, {change['b_name']}"
    if change["op"] == "-":
        return line + "  over"
    there = f"within {change['within_m']:.0f} m" if change["within_m"] or change["entry_min"] is None else "inside"
    if change["near"]:
        line += f"  {there}"
    elif change["entry_min"] is not None:
        line += f"  {there} in {change['entry_min']:.1f} min"
    if change["tcpa_min"] is not None:
        line += f"  TCPA {change['tcpa_min']:.1f} min  CPA {change['cpa_m']:.0f} m"
    if change["lat"] is not None:
        north, east = "NS"[change["lat"] < 0], "EW"[change["lon"] < 0]
        line += f"  {abs(change['lat']):.4f} {north} {abs(change['lon']):.4f} {east}"
    elif change["x"] is not None:
        line += f"  x {change['x']:.0f} m  y {change['y']:.0f} m"
    return line


def is_news(change):
    """A new pair whose encounter is still to come."""
    return change["op"] == "+" and not change["near"]


def urgency(change):
    """What comes first, then what is near already."""
    minutes = change["tcpa_min"] if change["entry_min"] is None else change["entry_min"]
    return change["near"], math.inf if minutes is None else minutes


def write_line(text):
    """In one call, so that a killed reader leaves no half line."""
    sys.stdout.flush()
    data = (text + "\n").encode()
    while data:
        data = data[os.write(sys.stdout.fileno(), data):]


def deliver(changes, is_whole, options, hook, reader):
    """Whether all were delivered. Rows of the whole watch share one position, which moves once all of them are."""
    for change in changes:
        if not options.news or is_news(change):
            if hook and not hook.deliver(change, reader.created):
                return False
            write_line(json.dumps(change) if options.json else as_text(change))
            if hook and not is_whole:
                reader.move(change["seq"], patience=0.5)
    return True


def follow(db, options, hook, stop):
    watch = watch_of(db, options.watch)
    encounters = Encounters(db, watch)
    reader = Reader(db, watch.name, options.reader or ("webhook" if hook else "alerts"))
    if options.from_start:
        reader.move(0)
    seen, more = None, True
    try:
        while not stop():
            version = db.execute("PRAGMA data_version").fetchone()[0]
            if version == seen and not more:
                reader.save(patience=0.02)
                if options.once:
                    return
                time.sleep(options.poll)
                continue
            seen = version
            with one_state(db):
                watch = watch_of(db, options.watch)
                if watch.created != encounters.watch.created:
                    encounters = Encounters(db, watch)
                rows, position, is_whole = changes_after(db, reader, watch)
                changes = [encounters.describe(row) for row in rows]
            if is_whole:
                changes.sort(key=urgency)
            if not deliver(changes, is_whole, options, hook, reader):
                return
            reader.move(position)
            more = len(rows) == AT_ONCE
    finally:
        reader.save(patience=5.0)


def run(options):
    stop = Stop()
    hook = Webhook(options.webhook, say, stop) if options.webhook else None
    db = opened(options.file)
    try:
        follow(db, options, hook, stop)
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())     # head has read enough
    finally:
        db.close()
