"""Resolves predicted encounters of ships: in each, one of the two makes the smallest change that is clear of all others.

    python3 advise_ships.py ships.csv --extension build/release/foresee

ships.csv: lines of id,t,x,y,vx,vy in metres, metres per second and seconds; of several lines of a ship the last one counts.
The encounters of the next ten minutes are examined in order of time. The ship with the larger number gives way, or the
other one if nothing is clear for it; no ship gives way twice. An encounter that an earlier change has resolved is skipped.
Each change is written before the next one is computed. Ships that are too close already are left alone.
"""
import argparse
import csv
import sqlite3
import time


def traffic(options):
    """A table in memory with the ships."""
    db = sqlite3.connect(":memory:", isolation_level=None)
    db.enable_load_extension(True)
    db.load_extension(options.extension)
    db.execute("CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy)")
    names = ("id", "t", "x", "y", "vx", "vy")
    with open(options.ships, newline="") as file:
        rows = [[float(row[name]) for name in names] for row in csv.DictReader(file)]
    db.execute("BEGIN")
    db.executemany("INSERT OR REPLACE INTO ships VALUES (?, ?, ?, ?, ?, ?)", ([int(row[0])] + row[1:] for row in rows))
    db.execute("COMMIT")
    return db


def encounters(db, options):
    """The encounters that start after now, in order of time."""
    return db.execute("SELECT a, b FROM predictive_join(?, 'ships', ?) WHERE dt > 0 ORDER BY t",
                      (options.horizon, options.within)).fetchall()


def is_still_there(db, options, a, b):
    return db.execute("SELECT 1 FROM predictive_join(?, 'ships', ?) WHERE a = ? AND b = ? AND dt > 0",
                      (options.horizon, options.within, a, b)).fetchone() is not None


def gives_way(db, options, ship):
    """Writes the smallest clear change, turns before speeds, and returns it; None if no change is clear."""
    least = db.execute("SELECT manoeuvre, k, t, x, y, vx, vy FROM predictive_avoid(?, 'ships', ?, ?) WHERE clear"
                       " ORDER BY manoeuvre = 'speed', round(abs(k), 6), k DESC LIMIT 1",
                       (options.horizon, ship, options.within)).fetchone()
    if least is None or least[1] == 0:
        return None
    db.execute("UPDATE ships SET (t, x, y, vx, vy) = (?, ?, ?, ?, ?) WHERE id = ?", least[2:] + (ship,))
    return least[:2]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("ships")
    parser.add_argument("--horizon", type=float, default=600)
    parser.add_argument("--within", type=float, default=200)
    parser.add_argument("--extension", default="build/release/foresee")
    options = parser.parse_args()
    db = traffic(options)
    before = encounters(db, options)
    advised, without, costs = {}, set(), []
    for a, b in before:
        if not is_still_there(db, options, a, b):
            continue
        for ship in max(a, b), min(a, b):
            if ship in advised or ship in without:
                continue
            start = time.perf_counter()
            change = gives_way(db, options, ship)
            costs.append(time.perf_counter() - start)
            if change is not None:
                advised[ship] = change
                break
            without.add(ship)
    after = encounters(db, options)
    made = [pair for pair in after if pair not in before]
    turns = sorted(abs(k) for manoeuvre, k in advised.values() if manoeuvre == "turn")
    print(f"{len(before)} encounters of {len({ship for pair in before for ship in pair})} ships before, {len(after)} after, {len(made)} of them new")
    print(f"{len(advised)} ships changed, {len(turns)} of them their course" + (f" (median {turns[len(turns) // 2]:.1f} degrees)" if turns else "") +
          f"; {len(without)} have no clear change")
    if costs:
        print(f"a query took {1e6 * sorted(costs)[len(costs) // 2]:.0f} us (median), {1e6 * max(costs):.0f} at most")


if __name__ == "__main__":
    main()
