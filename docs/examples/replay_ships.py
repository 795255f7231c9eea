"""Plays reports of ships into a file, and prints alerts from a second process as they come.

    python3 replay_ships.py ships.csv live.db --speed 60 --extension build/release/foresee

ships.csv: lines of id,t,x,y,vx,vy in metres, metres per second and seconds. The reports of one second are one transaction; with
--speed 60 a minute of theirs takes a second, with --speed 0 they come as fast as they can. The second process polls
PRAGMA data_version, which moves when another connection has committed, and reads what the watch has told since its position. That
position is a row of the file, moved in the transaction that handles the changes: kill it and start again, nothing is lost.
"""
import argparse
import csv
import itertools
import multiprocessing
import os
import sqlite3
import time


def connect(options):
    db = sqlite3.connect(options.database, isolation_level=None, timeout=10)
    db.enable_load_extension(True)
    db.load_extension(options.extension)
    return db


def prepare(options):
    """A new file with the ships, their watch, and the position of its reader."""
    for end in "", "-wal", "-shm":
        if os.path.exists(options.database + end):
            os.remove(options.database + end)
    db = connect(options)
    db.executescript(f"""
        PRAGMA journal_mode = WAL;
        PRAGMA synchronous = NORMAL;
        CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy);
        CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = {options.horizon}, within = {options.within},
                                                           ahead = 3600);
        CREATE TABLE readers(name TEXT PRIMARY KEY, seq INTEGER);
        INSERT INTO readers VALUES ('printer', 0);""")
    db.close()


def read_alerts(options, done):
    """Prints what changes until the writer is done and all is read."""
    db = connect(options)
    seen = None
    while True:
        finished = done.is_set()
        version = db.execute("PRAGMA data_version").fetchone()[0]
        if version != seen:
            seen = version
            db.execute("BEGIN IMMEDIATE")
            position = db.execute("SELECT seq FROM readers WHERE name = 'printer'").fetchone()[0]
            changes = db.execute("SELECT seq, op, a, b, t, now FROM predictive_changes('alerts', ?)", (position,)).fetchall()
            for seq, op, a, b, t, now in changes:
                print(f"{now:.0f} s  {op} {a} and {b}" + (f" at {t:.1f} s" if t is not None else ""), flush=True)
                position = seq
            db.execute("UPDATE readers SET seq = ? WHERE name = 'printer'", (position,))
            db.execute("COMMIT")
        elif finished:
            return
        time.sleep(0.01)


def write_reports(options):
    """The reports of each second as one transaction; what each of them cost."""
    db = connect(options)
    with open(options.reports, newline="") as file:
        reports = [tuple(float(row[name]) for name in ("t", "x", "y", "vx", "vy")) + (int(row["id"]),)
                   for row in csv.DictReader(file)]
    reports.sort()
    costs, before = [], None
    for second, group in itertools.groupby(reports, key=lambda report: int(report[0])):
        if before is not None and options.speed > 0:
            time.sleep((second - before) / options.speed)
        before = second
        group = list(group)
        start = time.perf_counter()
        db.execute("BEGIN IMMEDIATE")
        db.executemany("INSERT OR REPLACE INTO ships(t, x, y, vx, vy, id) VALUES (?, ?, ?, ?, ?, ?)", group)
        db.execute("COMMIT")
        costs.append((time.perf_counter() - start, len(group)))
    db.close()
    return costs


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("reports")
    parser.add_argument("database")
    parser.add_argument("--speed", type=float, default=60)
    parser.add_argument("--horizon", type=float, default=600)
    parser.add_argument("--within", type=float, default=926)
    parser.add_argument("--extension", default="build/release/foresee")
    options = parser.parse_args()
    prepare(options)
    done = multiprocessing.Event()
    reader = multiprocessing.Process(target=read_alerts, args=(options, done))
    reader.start()
    costs = write_reports(options)
    done.set()
    reader.join()
    seconds = sorted(cost for cost, _ in costs)
    print(f"{sum(count for _, count in costs)} reports in {len(costs)} transactions: median "
          f"{1000 * seconds[len(seconds) // 2]:.2f} ms, slowest {1000 * seconds[-1]:.1f} ms")


if __name__ == "__main__":
    main()
