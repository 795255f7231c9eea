"""What the tests of feed, alerts and map share: the wheel's commands as processes, a broker, ships in the columns of AIS.

The wheel is unpacked, and Debian's Python runs it, because paho is Debian's.
"""
import os
import re
import shutil
import signal
import socket
import sqlite3
import subprocess
import sys
import tempfile
import threading
import time
import zipfile
from pathlib import Path

from hosts import ROOT, Host, packed, skip

PYTHON = "/usr/bin/python3"
NEW_YORK = ROOT / "sql/data/new_york_20220103.csv"
LONG = bool(os.environ.get("FORESEE_LONG"))
START = 1641168000      # 2022-01-03 00:00:00


def waited(condition, seconds=30.0, what="what was awaited"):
    """The first true value of condition(); an error after so many seconds."""
    give_up = time.monotonic() + seconds
    while True:
        value = condition()
        if value:
            return value
        if time.monotonic() > give_up:
            raise AssertionError(f"{what} did not come within {seconds} s")
        time.sleep(0.02)


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Command:
    """python3 -m foresee … as a process, whose stderr is kept."""

    def __init__(self, test, *arguments, stdin=None, stdout=subprocess.PIPE):
        self.process = subprocess.Popen([PYTHON, "-m", "foresee", *map(str, arguments)], cwd=test.folder, env=test.environment, stdin=stdin,
                                        stdout=stdout, stderr=subprocess.PIPE, text=True)
        self.errors = []
        self.reader = threading.Thread(target=self.collect, daemon=True)
        self.reader.start()
        test.addCleanup(self.kill)

    def collect(self):
        for line in self.process.stderr:
            self.errors.append(line.rstrip("\n"))

    def said(self, text):
        return any(text in line for line in self.errors)

    def kill(self):
        """kill −9."""
        if self.process.poll() is None:
            self.process.kill()
        self.finish()

    def end(self, number=signal.SIGTERM):
        """Ends it as a person would; its status."""
        self.process.send_signal(number)
        self.process.wait(30)
        return self.finish()

    def finish(self):
        status = self.process.wait(60)
        self.reader.join(10)
        for stream in (self.process.stdout, self.process.stderr, self.process.stdin):
            if stream:
                stream.close()
        return status


class Live(Host):
    """A test with the commands and a database."""

    @classmethod
    def setUpClass(cls):
        wheel = packed("feed, alerts and map", "foresee-*.whl")
        if not Path(PYTHON).exists():
            skip("feed, alerts and map", f"there is no {PYTHON}")
        site = Path(tempfile.mkdtemp(prefix="foresee-live-"))
        cls.addClassCleanup(shutil.rmtree, site)
        with zipfile.ZipFile(wheel) as content:
            content.extractall(site)
        cls.site = site
        cls.environment = {**os.environ, "PYTHONPATH": str(site), "no_proxy": "127.0.0.1"}

    def setUp(self):
        super().setUp()
        self.file = self.folder / "fleet.db"

    def command(self, *arguments, text="", fails=False):
        """(stdout, stderr) of a command that ends."""
        done = subprocess.run([PYTHON, "-m", "foresee", *map(str, arguments)], cwd=self.folder, env=self.environment, input=text, text=True,
                              capture_output=True, timeout=120)
        if (done.returncode != 0) != fails:
            raise AssertionError(f"{arguments} ended with status {done.returncode}:\n{done.stdout}{done.stderr}")
        return done.stdout, done.stderr

    def database(self):
        connection = sqlite3.connect(self.file, isolation_level=None, timeout=30)
        connection.enable_load_extension(True)
        connection.load_extension(str(self.site / "foresee/foresee"))
        self.addCleanup(connection.close)
        return connection

    def positions(self, table="ships"):
        """{ship: (t, lat, lon, speed, course)} as they are stored."""
        rows = self.database().execute(f"SELECT id, t, lat, lon, speed, course FROM {table}").fetchall()
        return {row[0]: row[1:] for row in rows}

    def assert_holds(self, reports):
        """The table holds the last of the reports (ship, t, lat, lon, speed, course) of every ship, and no other ship."""
        stored = self.positions()
        wanted = {report[0]: report[1:] for report in reports}
        self.assertEqual(sorted(stored), sorted(wanted))
        for ship, values in wanted.items():
            for got, want in zip(stored[ship], values):
                self.assertAlmostEqual(got, want, delta=1e-6, msg=f"ship {ship}: {stored[ship]}, not {values}")


class WatchedShips(Live):
    """Three ships and a watch of them, which can change while a reader runs."""

    def setUp(self):
        super().setUp()
        # Two ships under way towards each other, and one at anchor near their course.
        self.report("1,10,53.99,7.85,14,91,ANNA\n2,10,53.985,8.0,12,272,BRUNO\n3,10,53.9875,7.92,0,0,DORA\n")

    def report(self, rows, *options):
        self.command("feed", self.file, "--table", "ships", "--watch", "alerts", "--horizon", "600", "--origin", "54 8", *options,
                     text="mmsi,t,lat,lon,sog,cog,name\n" + rows)

    def alerts(self, *options):
        return self.command("alerts", self.file, "alerts", "--once", *options)[0].splitlines()

    def write_changes(self, count, pause):
        """Ship 1 turns away and back, commit after commit, in a thread; the thread."""
        def write():
            db = self.database_of_thread()
            for i in range(count):
                db.execute("UPDATE ships SET t = ?, course = ? WHERE id = 1", (10 + i / 1000, 91 if i % 2 else 271))
                time.sleep(pause)
            db.close()
        thread = threading.Thread(target=write)
        thread.start()
        return thread

    def database_of_thread(self):
        db = sqlite3.connect(self.file, isolation_level=None, timeout=30)
        db.enable_load_extension(True)
        db.load_extension(str(self.site / "foresee/foresee"))
        return db

    def published(self, after):
        return [row[0] for row in self.database().execute("SELECT seq FROM predictive_changes('alerts', ?)", (after,))]

    def assert_nothing_missed(self, runs, wanted):
        """Each reader goes on where the one before ended: only what was being delivered when that one was killed comes twice."""
        delivered = 0
        for run in filter(None, runs):
            start = wanted.index(run[0])
            self.assertLessEqual(start, delivered, "a change was missed between two readers")
            self.assertEqual(run, wanted[start:start + len(run)])
            delivered = max(delivered, start + len(run))
        self.assertEqual(delivered, len(wanted))


def made_up_report(number, ships):
    """The number-th report of a fleet off Heligoland: (ship, t, lat, lon, speed, course)."""
    ship, turn = number % ships, number // ships
    return (211000000 + ship, START + turn, round(53.9 + 0.001 * (ship % 100) + 0.0001 * turn, 6), round(7.8 + 0.002 * (ship // 100), 6),
            10.0, 45.0)


def need_paho():
    """Feeds over MQTT read with paho in PYTHON; Broker.publish() writes with it in this Python."""
    for python in sorted({PYTHON, sys.executable}):
        if subprocess.run([python, "-c", "import paho.mqtt.client"], capture_output=True).returncode != 0:
            skip("feed over MQTT", f"{python} has no paho.mqtt (python3-paho-mqtt)")


class Broker:
    """mosquitto on loopback, which can be stopped and started again with what it holds."""

    def __init__(self, test, settings=""):
        if not shutil.which("mosquitto") and not Path("/usr/sbin/mosquitto").exists():
            skip("feed over MQTT", "there is no mosquitto")
        need_paho()
        self.port, self.process = free_port(), None
        self.settings = test.write("broker/mosquitto.conf", f"listener {self.port} 127.0.0.1\nallow_anonymous true\nmax_queued_messages 0\n"
                                   f"persistence true\npersistence_location {test.folder}/broker/\n" + settings +
                                   ("user root\n" if os.geteuid() == 0 else ""))
        self.url = f"mqtt://127.0.0.1:{self.port}/ais/#"
        test.addCleanup(self.stop)
        self.start()

    def start(self):
        self.process = subprocess.Popen(["/usr/sbin/mosquitto" if not shutil.which("mosquitto") else "mosquitto", "-c", str(self.settings)],
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        waited(self.answers, what="the broker")

    def answers(self):
        with socket.socket() as probe:
            return probe.connect_ex(("127.0.0.1", self.port)) == 0

    def stop(self):
        if self.process:
            self.process.terminate()
            self.process.wait(30)
            self.process = None

    def publish(self, messages):
        """Sends (topic, text) pairs with QoS 1, and waits until the broker has them."""
        import paho.mqtt.client as mqtt
        versions = (mqtt.CallbackAPIVersion.VERSION1,) if hasattr(mqtt, "CallbackAPIVersion") else ()
        client = mqtt.Client(*versions)
        client.max_queued_messages_set(0)
        client.max_inflight_messages_set(200)
        client.connect("127.0.0.1", self.port)
        client.loop_start()
        messages = list(messages)
        for i in range(0, len(messages), 1000):
            for one in [client.publish(topic, text, qos=1) for topic, text in messages[i:i + 1000]]:
                one.wait_for_publish()
        client.disconnect()
        client.loop_stop()


class ForgetfulBroker:
    """A broker of MQTT 3.1.1 that reads no acknowledgement: it sends a script of packets per connection, then closes it.

    A packet is (mid, dup, text). The session is there from the second connection on.
    """

    def __init__(self, test, connections):
        need_paho()
        self.server = socket.create_server(("127.0.0.1", 0))
        test.addCleanup(self.server.close)
        self.url = f"mqtt://127.0.0.1:{self.server.getsockname()[1]}/ais/#"
        threading.Thread(target=self.serve, args=(test, connections), daemon=True).start()

    def serve(self, test, connections):
        for number, packets in enumerate(connections):
            peer = self.server.accept()[0]
            peer.recv(4096)                                                     # CONNECT
            peer.sendall(bytes([0x20, 2, number > 0, 0]))
            subscribe = peer.recv(4096)
            peer.sendall(bytes([0x90, 3]) + subscribe[2:4] + b"\1")
            for mid, dup, text in packets:
                body = b"\0\5ais/x" + mid.to_bytes(2, "big") + text.encode()
                length = bytes([len(body) % 128 | 128, len(body) // 128])
                peer.sendall(bytes([0x32 | 8 * dup]) + length + body)
            peer.recv(4096)                                                     # what was sent is stored
            peer.close()


def totals(errors):
    """The last line of totals of feed: (lines, stored, older, left out, bad)."""
    line = [line for line in errors if " reports stored" in line][-1]
    return tuple(int(n) for n in re.findall(r"(\d+) (?:lines,|reports|older|without|bad)", line))
