"""Plans of robots in a warehouse without conflicts: of two that would meet, one waits, until no conflict is left.

    python3 warehouse.py --robots 50 --extension build/release/foresee

Each robot drives along the aisles of a grid from shelf to shelf at 1.5 m/s and stops 5 s at each; then it has left the
floor. Conflicts are solved in order of time. The robot with the larger number waits before the conflict, for the
shortest time that is clear of all other plans to their ends; if no wait is clear there, it waits earlier, then the
other one does, and at last one of the two starts later.
"""
import argparse
import random
import sqlite3
import time

SPEED, STOP, AISLE, RADIUS, GAP = 1.5, 5.0, 4.0, 0.5, 0.2


def plan_of(generator, size, stops, start):
    """LINESTRING M text: along aisles, first east or west, then north or south."""
    cell = lambda: generator.randrange(size) * AISLE
    x, y, t = cell(), cell(), start
    knots = [(x, y, t)]
    for _ in range(stops):
        for to in ((cell(), y), (None, cell())):
            to_x, to_y = (x if to[0] is None else to[0]), to[1]
            length = abs(to_x - x) + abs(to_y - y)
            if length:
                x, y, t = to_x, to_y, t + length / SPEED
                knots.append((x, y, t))
        t += STOP
        knots.append((x, y, t))
    return "LINESTRING M(" + ", ".join("%r %r %r" % knot for knot in knots) + ")"


def warehouse(options):
    db = sqlite3.connect(":memory:", isolation_level=None)
    db.enable_load_extension(True)
    db.load_extension(options.extension)
    db.execute("CREATE VIRTUAL TABLE robots USING moving_objects(id, x, y, plan, r)")
    generator = random.Random(options.seed)
    size = max(6, round((10 * options.robots) ** 0.5))
    db.execute("BEGIN")
    for robot in range(1, options.robots + 1):
        plan = plan_of(generator, size, 4, round(generator.uniform(0, 4 * options.robots), 1))
        db.execute("INSERT INTO robots(id, plan, r) VALUES (?, ?, ?)", (robot, plan, RADIUS))
    db.execute("COMMIT")
    return db


def horizon(db):
    return db.execute("SELECT max(p.until) FROM robots, plan_rows(plan) AS p").fetchone()[0]


def conflicts(db):
    """All conflicts: robots, time, and the legs in which they happen."""
    return db.execute("""
        SELECT a, b, j.t, (SELECT max(leg) FROM robots r, plan_rows(r.plan) p WHERE r.id = a AND p.t <= j.t) AS leg_a,
               (SELECT max(leg) FROM robots r, plan_rows(r.plan) p WHERE r.id = b AND p.t <= j.t) AS leg_b
          FROM predictive_join(?, 'robots', ?) AS j WHERE j.now = 0 AND contacts = 'all' ORDER BY j.t""",
                      (horizon(db), GAP)).fetchall()


def waits(db, robot, how, now, until):
    """Writes the plan with the shortest clear wait or delay; the seconds, or None if none is clear."""
    least = db.execute("SELECT k, plan FROM predictive_avoid WHERE h = ? AND tbl = 'robots' AND id = ? AND within = ?"
                       " AND how = ? AND lo = 0 AND hi = 600 AND now = ? AND clear ORDER BY k LIMIT 1",
                       (until - now + 600, robot, GAP * 1.01, how, now)).fetchone()
    if least is None:
        return None
    db.execute("UPDATE robots SET plan = ? WHERE id = ?", (least[1], robot))
    return least[0]


def solve(db, a, b, t):
    """One change that resolves the first conflict of a and b; (robot, seconds)."""
    until = horizon(db)
    for robot in (b, a):
        start, end = db.execute("SELECT min(p.t), max(p.until) FROM robots, plan_rows(plan) AS p WHERE id = ?",
                                (robot,)).fetchone()
        for lead in (3, 6, 12, 24, 48):
            if t - lead > start:
                seconds = waits(db, robot, "wait", t - lead, until)
                if seconds is not None:
                    return robot, seconds
    for robot in (b, a):
        start, = db.execute("SELECT min(p.t) FROM robots, plan_rows(plan) AS p WHERE id = ?", (robot,)).fetchone()
        if start > 0 and (seconds := waits(db, robot, "delay", 0, until)) is not None:
            return robot, seconds
    raise SystemExit(f"robots {a} and {b} meet at {t:.1f}, and no wait of either is clear")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--robots", type=int, default=50)
    parser.add_argument("--seed", type=int, default=7)
    parser.add_argument("--extension", default="build/release/foresee")
    options = parser.parse_args()
    db = warehouse(options)
    before, started, changes = conflicts(db), time.perf_counter(), []
    for a, b, t, leg_a, leg_b in before[:3]:
        print(f"robot {a} in leg {leg_a} meets robot {b} in leg {leg_b} after {t:.1f} s")
    while left := db.execute("SELECT a, b, t FROM predictive_join(?, 'robots', ?) WHERE now = 0 ORDER BY t, a, b LIMIT 1",
                             (horizon(db), GAP)).fetchone():
        changes.append(solve(db, *left))
        if len(changes) > 20 * options.robots:
            raise SystemExit("the plans need another order of robots")
    print(f"{len(before)} conflicts of {options.robots} robots before, {len(conflicts(db))} after")
    print(f"{len({robot for robot, _ in changes})} robots wait, {sum(seconds for _, seconds in changes):.0f} s in all, "
          f"the longest {max((seconds for _, seconds in changes), default=0):.0f} s; "
          f"solved in {time.perf_counter() - started:.2f} s")


if __name__ == "__main__":
    main()
