"""The command feed: reports from standard input or an MQTT broker into a table of moving objects.

    python3 -m foresee feed fleet.db --table ships < reports.csv
    python3 -m foresee feed fleet.db --table ships --mqtt 'mqtt://127.0.0.1/ais/#'

The options are those of __main__.py. One transaction holds what comes in a second, at most 1,000 rows. A SIGTERM or SIGINT ends it
after the last batch; after kill −9 the same command goes on, with --resume where standard input is a file.
"""
import hashlib
import os
import socket
import sys
import time

from .applied import Applied
from .batches import MAX_ROWS, Batches, Progress, line_groups
from .files import committed, opened, quoted
from .layouts import CsvLines, MissingColumns, decoder_of
from .mqtt_source import Address, MqttSource, number_in
from .nmea import NoDecoder, Sentences
from .process import Refusal, Stop
from .reports import UNREADABLE, by_quantity, json_object, report_of
from .tables import Table, create


GAP = 0.001             # seconds between two transactions, in which readers can write their positions


# Of a new watch: horizon, within and tolerance where they are not given.
NEW_WATCH = {"horizon": 600.0, "within": 926.0, "tolerance": 30.0}


def prepared(db, options, say):
    """The table, created with its watch where --watch names one and they are not there."""
    with committed(db):
        if not exists(db, options.table):
            create(db, options.table, options.origin)
        elif options.origin:
            require_origin(db, options.table, options.origin)
        if options.watch and not exists(db, options.watch):
            create_watch(db, options)
        elif options.watch:
            require_watch(db, options, say)
    table = Table(db, options.table)
    table.prepare(options.forget, options.kinds)
    return table


def require_origin(db, name, origin):
    """A table in degrees has its origin; of one in metres the file remembers it."""
    table = Table(db, name)
    if not table.degrees:
        db.execute("INSERT INTO foresee_feed(tbl, origin) VALUES (?, ?) ON CONFLICT(tbl) DO UPDATE SET origin = excluded.origin",
                   (table.name, f"{origin[0]!r} {origin[1]!r}"))
    elif table.globe or table.origin != origin:
        there = "is on the globe" if table.globe else "takes its origin from its first report" if table.origin is None else \
            f"has the origin {table.origin[0]:g} {table.origin[1]:g}"
        raise Refusal(f"{name} {there}: --origin is for a new table; leave it out, or write another --table")


def create_watch(db, options):
    # A ship whose clock is fast moves the clock of the watch by `ahead` at most: less than the time after which ships are forgotten.
    ahead = min(3600.0, options.forget / 3)
    given = {what: value if getattr(options, what) is None else getattr(options, what) for what, value in NEW_WATCH.items()}
    db.execute(f"CREATE VIRTUAL TABLE {quoted(options.watch)} USING predictive_watch({quoted(options.table)}, "
               f"{', '.join(f'{what} = {value!r}' for what, value in given.items())}, ahead = {ahead!r})")


def require_watch(db, options, say):
    """The watch that is there must be one of the table. Its options stay."""
    row = db.execute("SELECT tbl, other, horizon, within, tolerance FROM predictive_watches('main') WHERE lower(name) = lower(?)",
                     (options.watch,)).fetchone()
    if row is None:
        raise Refusal(f"{options.watch} is a table, not a watch; write another name after --watch")
    if options.table.lower() not in (str(name).lower() for name in row[:2]):
        raise Refusal(f"{options.watch} is a watch of {row[0]}, not of {options.table}; write another name after --watch")
    for (what, given), there in zip(((what, getattr(options, what)) for what in NEW_WATCH), row[2:]):
        if given is not None and given != there:
            say(f"{options.watch} is there and has {what} = {there:g}: --{what} is for a new watch")


def exists(db, name):
    return db.execute("SELECT 1 FROM sqlite_master WHERE lower(name) = lower(?)", (name,)).fetchone() is not None


def from_standard_input(batches, options, stop):
    skip = 0
    if options.resume:
        row = batches.db.execute("SELECT line FROM foresee_feed WHERE tbl = ?", (batches.table.name,)).fetchone()
        skip = row[0] if row else 0
        batches.progress.say(f"going on after line {skip}")
    decoder = None
    for group in line_groups(sys.stdin.fileno(), options.every, MAX_ROWS, stop):
        if decoder is None:
            first = next((line for line in group if line[1].strip()), None)
            if first is None:
                continue
            decoder = decoder_of(first[1], options.layout, options.arrival)
            batches.progress.left_out = lambda: decoder.left_out
            if first[0] <= skip and isinstance(decoder, CsvLines):
                decoder.read([first])       # the header
        fresh = [line for line in group if line[0] > skip]
        if fresh:
            reports, bad = decoder.read(fresh)
            batches.commit(reports, bad, len(fresh), fresh[-1][0])
            time.sleep(GAP)


class Payloads:
    """A decoder of messages: JSON, NMEA sentences, or lines of either."""

    def __init__(self):
        self.sentences, self.left_out = None, 0

    def read(self, messages):
        now, reports, bad, sentences, lines = time.time(), [], [], [], 0
        for message in messages:
            topic, text = message.topic, message.payload.decode("utf-8", "replace").strip()
            for line in text.splitlines() if not text.startswith("{\n") else [text]:
                lines += 1
                if line[:1] in ("!", "$", "\\"):
                    sentences.append((topic, line))
                    continue
                try:
                    report = report_of(by_quantity(json_object(line)), now, number_in(topic))
                except UNREADABLE as reason:
                    bad.append((topic, str(reason)))
                else:
                    self.left_out += report is None
                    reports += [] if report is None else [report]
        if sentences:
            self.sentences = self.sentences or Sentences()
            more, worse = self.sentences.read(sentences)
            reports, bad = reports + more, bad + worse
        return reports, bad, lines


def from_broker(batches, options, stop):
    path, address = os.path.abspath(options.file), Address(options.mqtt)
    identity = hashlib.sha256(f"{socket.gethostname()} {path} {batches.table.name} {address.topic}".encode()).hexdigest()[:12]
    client_id = options.client_id or f"foresee-{identity}"
    applied = Applied(batches.db, batches.table.name, f"{client_id} at {address.host}:{address.port}")
    source = MqttSource(options.mqtt, client_id, batches.progress.say, applied.forget)
    payloads = Payloads()
    batches.progress.left_out = lambda: payloads.left_out + (payloads.sentences.left_out if payloads.sentences else 0)

    def commit(messages):
        fresh = applied.fresh(messages)
        batches.progress.repeated += len(messages) - len(fresh)
        if fresh:
            reports, bad, lines = payloads.read(fresh)
            batches.commit(reports, bad, lines, also=lambda: applied.keep(fresh))

    source.run(commit, options.every, MAX_ROWS, stop)


def run(options):
    stop = Stop()
    db = opened(options.file, create=True)
    try:
        progress = Progress(sys.stderr)
        batches = Batches(db, prepared(db, options, progress.say), progress, options.future)
        (from_broker if options.mqtt else from_standard_input)(batches, options, stop)
        progress.show(final=True)
    except (MissingColumns, NoDecoder) as reason:
        raise Refusal(str(reason)) from None
    finally:
        db.close()
