"""The command map: one page on 127.0.0.1 with the ships of a table on a coastline, zones, and the pairs of its watches as they come.

    python3 -m foresee map fleet.db

    GET /                  the page, its script, style and coast: files of the package
    GET /state?version=7&areas=5f   ships, zones and pairs as JSON; 204 where nothing has changed since that version; zones where their
                                    digest is another one

The server answers requests that name this machine alone, reads the file and never writes it. The page may request nothing else.
"""
import hashlib
import json
import secrets
import socket
import threading
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from urllib.parse import parse_qs, urlsplit

from .areas import Areas
from .encounters import Encounters, printable
from .files import one_state, opened, quoted, watch_of
from .process import Refusal, Stop
from .tables import IN_UNIT, KNOT, Table

FILES = {"/": ("map.html", "text/html"), "/map.js": ("map.js", "text/javascript"), "/coast.js": ("coast.js", "text/javascript"),
         "/map.css": ("map.css", "text/css"), "/coast.json": ("coast.json", "application/json")}
POLICY = "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; img-src data:; base-uri 'none'; form-action 'none'"
MAX_PAIRS = 500         # that the page lists: those that come first


class State:
    """What the page shows, from one connection that the requests share."""

    def __init__(self, path, table):
        self.db, self.lock = opened(path, check_same_thread=False), threading.Lock()
        self.table = Table(self.db, table or only_table(self.db))
        self.areas = {}                         # of tables beside it
        self.token = secrets.token_hex(4)       # versions of another run are none of this one
        if self.table.in_degrees() is None and self.db.execute(f"SELECT 1 FROM {quoted(self.table.name)} LIMIT 1").fetchone():
            raise Refusal(f"{self.table.name} is in metres and its origin is not known: a map needs degrees")

    def read(self, known, known_areas=""):
        """None where the state is the known one; without the areas where they are."""
        with self.lock:
            version = f"{self.token}-{self.db.execute('PRAGMA data_version').fetchone()[0]}"
            if version == known:
                return None
            with one_state(self.db):
                watches = self.db.execute("SELECT name, now FROM predictive_watches('main') WHERE lower(tbl) = lower(?) ORDER BY name",
                                          (self.table.name,)).fetchall()
                # The clock of a watch does not follow one report with a time in the far future.
                now = next((clock for _, clock in watches if clock is not None), None)
                if now is None:
                    now = self.db.execute(f"SELECT max(t) FROM {quoted(self.table.name)}").fetchone()[0]
                watched = [self.pairs(watch) for watch, _ in watches]
                areas = {name: self.areas_of(name, now) for name in self.area_tables({watch["other"] for watch in watched})}
                digest = hashlib.sha256(json.dumps(areas).encode()).hexdigest()[:16]
                return {"version": version, "table": self.table.name, "now": now, "ships": [] if now is None else self.ships(now),
                        "watches": watched, "areas_version": digest, **({} if digest == known_areas else {"areas": areas})}

    def area_tables(self, others):
        """Tables of zones, tables that a watch joins with the ships, and the ships where they have a shape."""
        tables = [row[0] for row in self.db.execute("SELECT name FROM foresee_tables WHERE schema = 'main' ORDER BY name")]
        for name in tables:
            table = Table(self.db, name)
            if name not in self.areas or self.areas[name].table.columns != table.columns:
                self.areas[name] = Areas(self.db, table)
        return [name for name in tables if self.areas[name].is_zone or name in others or name == self.table.name]

    def areas_of(self, name, now):
        return self.areas[name].at(0.0 if now is None else now)

    def ships(self, now):
        """[number, name, latitude, longitude, knots, course] of each object at a time."""
        named = f", (SELECT {self.table.named} FROM {quoted(self.table.name)} s WHERE s.id = p.id)" if self.table.named else ", NULL"
        there = self.table.in_degrees()
        if there is None:
            return []
        rows = self.db.execute(f"SELECT p.id, {there[0]}{named} FROM predictive_position(?, ?) p{there[1]}",
                               (*there[2], now, self.table.name, *there[3]))
        return [[number, printable(str(name)) if name else str(number), round(lat, 6), round(lon, 6), round(speed / KNOT, 1),
                 None if course is None or speed == 0 else round(course, 1)]
                for number, lat, lon, speed, course, name in rows if lat is not None]

    def pairs(self, watch):
        """The pairs of a watch that come first; those that are near already come last."""
        there = watch_of(self.db, watch)
        encounters, now = Encounters(self.db, there), there.now
        first = "t" if encounters.is_of_areas else "t_cpa"
        rows = self.db.execute(f"SELECT a, b, t, t_cpa, d_cpa FROM {quoted(watch)} ORDER BY t <= ?, {first}, a, b LIMIT ?",
                               (now, MAX_PAIRS)).fetchall()
        pairs = [{"a": a, "b": b, "a_name": encounters.name(encounters.first, a), "b_name": encounters.name(encounters.second, b),
                  "near": t <= now, **encounters.measures(*encounters.closest(a, b, (t, t_cpa, d_cpa), now), now)}
                 for a, b, t, t_cpa, d_cpa in rows]
        pairs.sort(key=lambda pair: (pair["near"], pair["tcpa_min"] if pair["entry_min"] is None else pair["entry_min"]))
        return {"name": watch, "within": there.within, "horizon": there.horizon, "other": there.other, "of_areas": encounters.is_of_areas,
                "now": now, "pairs": pairs}


def only_table(db):
    names = [row[0] for row in db.execute("SELECT name FROM foresee_tables WHERE schema = 'main' ORDER BY name")
             if "zone" not in Table(db, row[0]).columns]
    if len(names) != 1:
        raise Refusal(f"there are {len(names)} tables of moving objects ({', '.join(names)}); write --table NAME" if names else
                      "there is no table of moving objects; feed creates one")
    return names[0]


class Handler(BaseHTTPRequestHandler):
    server_version, sys_version, protocol_version = "foresee", "", "HTTP/1.1"

    def do_GET(self):
        host = self.headers.get("Host", "").rsplit(":", 1)[0]
        if host not in ("127.0.0.1", "localhost"):
            return self.answer(403, b"This page is for 127.0.0.1 alone.\n", "text/plain")   # a foreign name that leads here
        url = urlsplit(self.path)
        if url.path in FILES:
            name, kind = FILES[url.path]
            return self.answer(200, (Path(__file__).parent / "page" / name).read_bytes(), kind)
        if url.path != "/state":
            return self.answer(404, b"There is no such page.\n", "text/plain")
        try:
            known = parse_qs(url.query)
            state = self.server.state.read(known.get("version", [""])[0], known.get("areas", [""])[0])
        except Exception as error:          # a dropped table, a damaged file: the page shows it
            return self.answer(500, json.dumps({"error": str(error)}).encode(), "application/json")
        if state is None:
            return self.answer(204, b"", "application/json")
        return self.answer(200, json.dumps(state, separators=(",", ":")).encode(), "application/json")

    def answer(self, status, body, kind):
        self.send_response(status)
        self.send_header("Content-Type", f"{kind}; charset=utf-8")
        self.send_header("Content-Length", str(len(body)))
        for name, value in (("Content-Security-Policy", POLICY), ("X-Content-Type-Options", "nosniff"), ("Cache-Control", "no-store"),
                            ("Referrer-Policy", "no-referrer")):
            self.send_header(name, value)
        self.end_headers()
        try:
            self.wfile.write(body)
        except ConnectionError:
            pass

    def log_message(self, *arguments):
        pass


class Server(ThreadingHTTPServer):
    daemon_threads = True

    def server_bind(self):
        # http.server looks up the name of the host, which may take seconds.
        self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        self.socket.bind(self.server_address)
        self.server_address = self.socket.getsockname()
        self.server_name, self.server_port = "127.0.0.1", self.server_address[1]


def run(options):
    stop = Stop()
    state = State(options.file, options.table)
    try:
        server = Server(("127.0.0.1", options.port), Handler)
    except OSError as error:
        raise Refusal(f"port {options.port} cannot be served: {error.strerror}; write --port 0 for any that is free") from None
    server.state = state
    threading.Thread(target=server.serve_forever, daemon=True).start()
    print(f"http://127.0.0.1:{server.server_port}/  (Ctrl+C ends it)", flush=True)
    while not stop():
        threading.Event().wait(0.1)
    server.shutdown()
