"""An hour of AIS reports at sixty times its speed through feed and alerts: reports per second, latency of an alert, memory.

    bash ext/hosts/pack.sh wheel && python3 bench/feed_replay.py
    python3 bench/feed_replay.py --speed 0            # as fast as they go

The reports are those of ../shared/data within 1,400 km of 30 N 90 W (FORESEE_SHARED_DATA names another folder), else those of sql/data.
They last 25 minutes. The hour plays them forward, backward with reversed courses, and forward again, so that every ship moves without
a jump. feed, alerts and this program are three processes, with pipes between them. Latency is the time from the line that causes a
new pair to the line of alerts that reports it. Pairs that only time brings into the horizon are counted apart.
"""
import argparse
import bisect
import csv
import gzip
import json
import math
import os
import platform
import shutil
import subprocess
import tempfile
import threading
import time
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
SHARED = Path(os.environ.get("FORESEE_SHARED_DATA", ROOT.parent / "shared/data")) / "ships_us_20220103.csv.gz"
CENTRE, REACH_KM = (30.0, -90.0), 1400.0
SECONDS = 3600
PYTHON = "/usr/bin/python3"


def distance_km(lat, lon):
    a, b = math.radians(lat), math.radians(CENTRE[0])
    cosine = math.sin(a) * math.sin(b) + math.cos(a) * math.cos(b) * math.cos(math.radians(lon - CENTRE[1]))
    return 6371.0 * math.acos(max(-1.0, min(1.0, cosine)))


def recorded():
    """(t, ship, lat, lon, speed, course) of the 25 minutes, in order of time."""
    if SHARED.exists():
        with gzip.open(SHARED, "rt", newline="") as file:
            rows = [(int(row["t"]), int(row["mmsi"]), float(row["lat"]), float(row["lon"]), float(row["sog_kn"]), float(row["cog_deg"]))
                    for row in csv.DictReader(file)]
        return [row for row in rows if distance_km(row[2], row[3]) <= REACH_KM], SHARED.name
    os.environ["TZ"] = "UTC"
    path = ROOT / "sql/data/new_york_20220103.csv"
    with path.open(newline="") as file:
        return [(int(time.mktime(time.strptime(row["BaseDateTime"], "%Y-%m-%dT%H:%M:%S"))), int(row["MMSI"]), float(row["LAT"]),
                 float(row["LON"]), float(row["SOG"]), float(row["COG"])) for row in csv.DictReader(file)], path.name


def an_hour(rows):
    """Forward, backward, forward."""
    first, last = rows[0][0], rows[-1][0]
    length, hour = last - first + 1, []
    for leg in range(SECONDS // length + 1):
        start = leg * length
        if leg % 2 == 0:
            hour += [(start + t - first, *rest) for t, *rest in rows]
        else:
            hour += [(start + last - t, ship, lat, lon, speed, course if course >= 360 else (course + 180) % 360)
                     for t, ship, lat, lon, speed, course in reversed(rows)]
    return [row for row in hour if row[0] < SECONDS], first


def peak_memory(process):
    status = Path(f"/proc/{process.pid}/status").read_text()
    return int(status.split("VmHWM:")[1].split()[0]) / 1024


def quantile(values, share):
    return sorted(values)[min(len(values) - 1, int(share * len(values)))]


def latencies(sent, alerts):
    """Seconds of each new pair from the cause to its line, and how many only time has brought.

    The cause is the last report of one of its ships between the clock of the change before and its own.
    """
    by_ship, clocks, delays, by_time = {}, sorted({change["now"] for _, change in alerts}), [], 0
    for when, t, ship in sent:
        by_ship.setdefault(ship, []).append((t, when))
    for arrived, change in alerts:
        if change["op"] != "+":
            continue
        place = bisect.bisect_left(clocks, change["now"])
        before = clocks[place - 1] if place else -math.inf
        causes = [when for ship in (change["a"], change["b"]) for t, when in by_ship.get(ship, ())
                  if before < t <= change["now"] and when <= arrived]
        if causes:
            delays.append(arrived - max(causes))
        else:
            by_time += 1
    return delays, by_time


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--speed", type=float, default=60.0, help="times real time; 0: without a pause (%(default)g)")
    parser.add_argument("--every", default="1", help="seconds of a transaction (%(default)s)")
    parser.add_argument("--packages", default=ROOT / "build/packages", type=Path, help="the folder of the wheel")
    options = parser.parse_args()
    rows, source = recorded()
    hour, first = an_hour(rows)
    folder = Path(tempfile.mkdtemp(prefix="foresee-replay-"))
    with zipfile.ZipFile(sorted(options.packages.glob("foresee-*.whl"))[-1]) as wheel:
        wheel.extractall(folder / "site")
    settings = dict(cwd=folder, env={**os.environ, "PYTHONPATH": str(folder / "site")})
    foresee = [PYTHON, "-m", "foresee"]
    create = [*foresee, "feed", "live.db", "--table", "ships", "--watch", "alerts", "--origin", f"{CENTRE[0]} {CENTRE[1]}"]
    subprocess.run(create, stdin=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True, **settings)
    feed = subprocess.Popen([*create, "--every", options.every], stdin=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **settings)
    reader = subprocess.Popen([*foresee, "alerts", "live.db", "alerts", "--json"], stdout=subprocess.PIPE, text=True, **settings)
    alerts, sent, errors = [], [], []
    threads = [threading.Thread(target=lambda: [alerts.append((time.monotonic(), json.loads(line))) for line in reader.stdout]),
               threading.Thread(target=lambda: errors.extend(feed.stderr))]
    for thread in threads:
        thread.start()
    print(f"{len(hour)} reports of {len({row[1] for row in hour})} ships in an hour ({source}); {platform.machine()}, "
          f"{os.cpu_count()} processors, load average {os.getloadavg()[0]:.1f}", flush=True)

    feed.stdin.write("mmsi,t,lat,lon,sog,cog\n")
    started, latest = time.monotonic(), 0.0
    for t, ship, lat, lon, speed, course in hour:
        if options.speed:
            now = time.monotonic()
            due = started + t / options.speed
            if now < due:
                feed.stdin.flush()
                time.sleep(due - now)
            latest = max(latest, time.monotonic() - due)
        feed.stdin.write(f"{ship},{first + t},{lat},{lon},{speed},{course}\n")
        sent.append((time.monotonic(), first + t, ship))
    feed.stdin.flush()
    time.sleep(1.5 * float(options.every))
    memory = peak_memory(feed)
    feed.stdin.close()
    feed.wait()
    seconds = time.monotonic() - started
    time.sleep(1.0)
    reader_memory = peak_memory(reader)
    reader.terminate()
    reader.wait()
    for thread in threads:
        thread.join()
    delays, by_time = latencies(sent, alerts)
    print(f"{len(hour) / seconds:.0f} reports per second in {seconds:.1f} s" +
          (f"; the replay was late by at most {latest:.2f} s" if options.speed else ""))
    print(f"{len(alerts)} changes; {len(delays)} new pairs by a report: latency median {1000 * quantile(delays, 0.5):.0f} ms, "
          f"99th percentile {1000 * quantile(delays, 0.99):.0f} ms; {by_time} by time alone")
    print(f"memory: feed {memory:.0f} MB, alerts {reader_memory:.0f} MB; file {(folder / 'live.db').stat().st_size / 1e6:.0f} MB; "
          f"load average {os.getloadavg()[0]:.1f}")
    print(errors[-1].strip())
    shutil.rmtree(folder)


if __name__ == "__main__":
    main()
