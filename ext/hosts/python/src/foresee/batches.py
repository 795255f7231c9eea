"""Batches: lines of standard input in groups, reports in transactions, each with the number of its last line.

    batches = Batches(db, Table(db, "ships"), Progress(sys.stderr), future=300.0)
    for group in line_groups(0, seconds=1.0, limit=1000):           # 0 is the descriptor of standard input
        batches.commit(*decoder.read(group), lines=len(group), last_line=group[-1][0])

A killed feed goes on after the last line of its last transaction.
"""
import os
import re
import select
import sqlite3
import time

from .files import committed

MAX_ROWS = 1000         # per transaction
CHUNK = 1 << 16         # bytes that are read at once
NAMED_BAD_LINES = 100   # further ones are counted
TOO_FAR = re.compile(r"lat, lon of row .*: (\d+ km from the origin '[^']*')")


class Progress:
    """What feed reports on stderr: bad lines, a line of totals from time to time, and one at the end."""

    def __init__(self, stream, every=10.0):
        self.stream, self.every = stream, every
        self.started = self.shown = time.monotonic()
        self.lines = self.stored = self.older = self.bad = self.repeated = self.far = self.without_position = 0
        self.left_out = lambda: 0           # of the decoder

    def name_bad(self, number, message):
        self.bad += 1
        if self.bad <= NAMED_BAD_LINES:
            self.say(f"{number}: {message}" if isinstance(number, str) else f"line {number}: {message}")
        if self.bad == NAMED_BAD_LINES:
            self.say("further bad lines are only counted")

    def refuse(self, ship, message):
        """A report that the table refuses: by its values, or in a file of half the world by its distance from the origin."""
        far = TOO_FAR.search(message)
        if not far:
            return self.name_bad(f"ship {ship}", message)
        self.far += 1
        if self.far == 1:
            self.say(f"ship {ship}: {far[1]}, the limit is 1500 km; such reports are only counted: --origin 'LAT LON' places a new table")

    def say(self, text):
        print(f"foresee feed: {text}", file=self.stream, flush=True)

    def show(self, final=False):
        now = time.monotonic()
        if not final and now - self.shown < self.every:
            return
        self.shown = now
        rate = self.lines / max(now - self.started, 1e-3)
        more = "".join(f", {count} {what}" for count, what in ((self.far, "too far from the origin"), (self.repeated, "sent again")) if count)
        self.say(f"{self.lines} lines, {self.stored} reports stored, {self.older} older than what is stored, {self.left_out() + self.without_position} without "
                 f"position, speed or course, {self.bad} bad{more}; {rate:.0f} lines per second")


class Batches:
    def __init__(self, db, table, progress, future):
        """`future`: seconds by which a report may be later than the clock of this machine."""
        self.db, self.table, self.progress, self.future = db, table, progress, future

    def commit(self, reports, bad, lines, last_line=None, also=lambda: None):
        """Stores reports in one transaction, in which also() writes too. What the table refuses is a bad line; everything else ends the
        feed, and stores nothing."""
        stored, without_position, refused, latest = 0, 0, [], time.time() + self.future
        with committed(self.db):
            for report in reports:
                if report.t is not None and report.t > latest:
                    refused.append((report.id, f"its report is {report.t - latest + self.future:.0f} s later than the clock of this "
                                               f"machine, more than --future {self.future:g}"))
                    continue
                try:
                    was_stored = self.table.write(report)
                    stored += was_stored
                    without_position += report.t is None and not was_stored     # a name that is known, or of no ship
                except sqlite3.Error as error:
                    if not self.db.in_transaction or not is_refusal(error):
                        raise
                    refused.append((report.id, str(error)))
            self.db.execute("INSERT OR IGNORE INTO foresee_feed(tbl) VALUES (?)", (self.table.name,))
            if last_line is None:
                self.db.execute("UPDATE foresee_feed SET messages = messages + ? WHERE tbl = ?", (lines, self.table.name))
            else:
                self.db.execute("UPDATE foresee_feed SET line = ? WHERE tbl = ?", (last_line, self.table.name))
            also()
        progress = self.progress
        progress.lines += lines
        progress.stored += stored
        progress.older += len(reports) - stored - without_position - len(refused)
        progress.without_position += without_position
        for number, message in bad:
            progress.name_bad(number, message)
        for ship, message in refused:
            progress.refuse(ship, message)
        progress.show()


def is_refusal(error):
    """Did the table refuse the values of a row? Such errors have the code of a constraint; damage and a full disk have others."""
    return isinstance(error, sqlite3.IntegrityError) or str(error).startswith("geo_to_plane:")


def line_groups(descriptor, seconds, limit, stop=lambda: False):
    """Yields lists of (number, text): a group ends with `limit` lines, `seconds` after its first line, or at the end of the input.

    A last line without an end is a line too. `stop` ends at a signal, after what was read.
    """
    waiting, rest, count, oldest, ended = [], b"", 0, None, False
    while True:
        while len(waiting) >= limit or (waiting and (ended or stop() or time.monotonic() - oldest >= seconds)):
            group, waiting = waiting[:limit], waiting[limit:]
            yield group
            oldest = time.monotonic()
        if ended or stop():
            return
        patience = 0.5 if not waiting else max(0.0, oldest + seconds - time.monotonic())
        if not select.select([descriptor], [], [], min(patience, 0.5))[0]:
            continue
        chunk = os.read(descriptor, CHUNK)
        ended = not chunk
        *whole, rest = (rest + chunk).split(b"\n")
        if ended and rest:
            whole.append(rest)
        if whole and not waiting:
            oldest = time.monotonic()
        for line in whole:
            count += 1
            text = line.decode("utf-8", "replace").rstrip("\r")
            waiting.append((count, text.lstrip("\ufeff") if count == 1 else text))
