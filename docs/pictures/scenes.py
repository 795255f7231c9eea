"""Pictures of scenes that the extension computes: the harbour of four ships, hulls beside boxes, traffic that gives way, the ring of eight."""
import math
import os
import re
import sqlite3
from pathlib import Path

from svg import Picture, number

ROOT = Path(__file__).resolve().parents[2]
STEP = ROOT / "sql/tour/09_avoid.sql"


def connect():
    db = sqlite3.connect(":memory:")
    db.enable_load_extension(True)
    db.load_extension(os.environ.get("FORESEE_EXTENSION", str(ROOT / "build/release/foresee")).removesuffix(".so"))
    return db


def animate(attribute, times, values, seconds, mode="linear"):
    """Values at times from 0 to 1, for ever."""
    return (f'<animate attributeName="{attribute}" values="{";".join(map(number, values))}" '
            f'keyTimes="{";".join(f"{time:.4g}" for time in times)}" calcMode="{mode}" dur="{seconds}s" repeatCount="indefinite"/>')


def arrow(picture, x, y, dx, dy, colour, length=16):
    """From (x, y) in the direction (dx, dy)."""
    size = math.hypot(dx, dy)
    if not size:
        return
    ux, uy = dx / size, dy / size
    tip = x + ux * length, y + uy * length
    picture.line(x, y, *tip, colour, 2)
    picture.add(f'<path class="f-{colour}" d="M{number(tip[0] + 4 * ux)} {number(tip[1] + 4 * uy)}L{number(tip[0] - 4 * uy - 3 * ux)} '
                f'{number(tip[1] + 4 * ux - 3 * uy)}L{number(tip[0] + 4 * uy - 3 * ux)} {number(tip[1] - 4 * ux - 3 * uy)}Z"/>')


def scale_bar(picture, x, y, pixels, label):
    picture.line(x, y, x + pixels, y, "ink", 2)
    picture.text(x + pixels / 2, y - 6, label, "soft", "middle", 11)


# --- Four ships of a harbour

SHIPS = [(1, 0, 0, 6, 0, 30, "Anna"), (2, 1200, 0, -6, 0, 30, "Bruno"), (3, 600, -1600, 0, 8, 30, "Clara"), (4, 600, 300, 0, 0, 30, "Dora")]


def harbour():
    """Five minutes of four ships in fifteen seconds; a ring opens where two touch."""
    horizon, seconds = 300, 15
    db = connect()
    db.execute("CREATE VIRTUAL TABLE ships USING moving_objects(id, x, y, vx, vy, r, +name TEXT)")
    db.executemany("INSERT INTO ships VALUES (?, ?, ?, ?, ?, ?, ?)", SHIPS)
    pairs = db.execute("SELECT s.name, o.name, j.a, j.t, j.t_end FROM predictive_join(?) j JOIN ships s ON s.id = j.a "
                       "JOIN ships o ON o.id = j.b ORDER BY j.t", (horizon,)).fetchall()
    message = f"Anna and Bruno touch after {number(pairs[0][3])} s, Clara and Dora after {number(pairs[1][3])} s"
    picture = Picture(600, 560, message, "Four ships, their paths of five minutes, and the two places where ships touch.")
    west, north, scale = -1106, 960, 0.17

    def pixel(x, y):
        return 10 + (x - west) * scale, 60 + (north - y) * scale

    picture.heading(message)
    picture.add('<svg x="10" y="50" width="580" height="452" viewBox="10 50 580 452">')
    picture.rect(10, 50, 580, 452, "water")
    for ship, x, y, vx, vy, r, name in SHIPS:
        track = [(t, *pixel(px, py)) for t, px, py in db.execute(
            "SELECT t, x, y FROM predictive_track(0, ?, 60, 'ships') WHERE id = ? ORDER BY t", (horizon, ship))]
        times = [t / horizon for t, _, _ in track]
        xs, ys = [px for _, px, _ in track], [py for _, _, py in track]
        if vx or vy:
            picture.path([(xs[0], ys[0]), (xs[-1], ys[-1])], "track", 1.5, "2 6")
            arrow(picture, xs[0], ys[0], vx, -vy, "foresee", 22)
        picture.circle(xs[0], ys[0], max(6, r * scale), "foresee")
        picture.moving(animate("cx", times, xs, seconds) + animate("cy", times, ys, seconds))
        picture.text(xs[0] + 12, ys[0] - 9, name, size=13)
        picture.moving(animate("x", times, [v + 12 for v in xs], seconds) + animate("y", times, [v - 9 for v in ys], seconds))
    for ship, other, a, t, t_end in pairs:
        (x, y), = db.execute("SELECT x, y FROM predictive_position(?, 'ships') WHERE id = ?", ((t + t_end) / 2, a)).fetchall()
        x, y = pixel(x, y)
        times = [0, t / horizon, t_end / horizon, min(t_end + 25, horizon) / horizon, 1]
        picture.add(f'<circle class="s-meet f-meet" cx="{number(x)}" cy="{number(y)}" r="12" fill-opacity="0.15" stroke-width="2">'
                    + animate("r", times, [12, 12, 26, 34, 34], seconds) + "</circle>")
    scale_bar(picture, 480, 486, 500 * scale, "500 m")
    picture.add("</svg>")
    left, right, middle = 40, 560, 522

    def at(t):
        return left + (right - left) * t / horizon
    picture.line(left, middle, right, middle, "rule", 4)
    for ship, other, _, t, t_end in pairs:
        picture.line(at(t), middle, at(t_end), middle, "meet", 8)
        picture.text(at((t + t_end) / 2), middle + 22, f"{ship} and {other}: {number(t)} s to {number(t_end)} s", "soft", "middle")
    picture.add(f'<circle class="f-ink" cx="{left}" cy="{middle}" r="6">' + animate("cx", [0, 1], [left, right], seconds) + "</circle>")
    return picture


# --- Boxes meet where hulls do not

HULL = [(-8, -90), (8, -90), (8, 60), (0, 90), (-8, 60)]
QUAY = [(0, 0), (20, 0), (20, 180), (80, 180), (80, 0), (100, 0), (100, 200), (0, 200)]
# name, x, y, vx, vy, corners, heading: those of sql/tour/07_hulls.sql
ANNA, BRUNO = ("Anna", 0, 0, 4, 4, HULL, 45), ("Bruno", 684, 600, -4, -4, HULL, 225)
CLARA, BASIN = ("Clara", 1050, 0, 0, 2, HULL, 0), ("quay", 1000, 300, 0, 0, QUAY, 0)
BESIDE = {"Anna": (-62, 78), "Bruno": (-32, -92), "Clara": (22, -40), "quay": (112, 90)}  # metres from the position to the name


def turned(corners, heading):
    """Clockwise from the y axis. For the drawing alone: the extension turns exactly."""
    c, s = math.cos(math.radians(heading)), math.sin(math.radians(heading))
    return [(x * c + y * s, y * c - x * s) for x, y in corners]


def box_around(corners):
    xs, ys = zip(*corners)
    return [(min(xs), min(ys)), (max(xs), min(ys)), (max(xs), max(ys)), (min(xs), max(ys))]


def boxed(thing):
    name, x, y, vx, vy, corners, heading = thing
    return name, x, y, vx, vy, box_around(turned(corners, heading)), 0


def first_contact(a, b, within=0):
    """(t, t_cpa) of the two as outlines, or None."""
    db = connect()
    db.execute("CREATE VIRTUAL TABLE objects USING moving_objects(id, x, y, vx, vy, shape, heading)")
    for row, (_, x, y, vx, vy, corners, heading) in enumerate((a, b)):
        text = "POLYGON((" + ", ".join(f"{cx!r} {cy!r}" for cx, cy in [*corners, corners[0]]) + "))"
        db.execute("INSERT INTO objects VALUES (?, ?, ?, ?, ?, ?, ?)", (row, x, y, vx, vy, text, heading))
    return db.execute("SELECT t, t_cpa FROM predictive_join(300, 'objects', ?)", (within,)).fetchone()


def boxes_and_hulls():
    boxes, nothing, passing = first_contact(boxed(ANNA), boxed(BRUNO)), first_contact(ANNA, BRUNO), first_contact(ANNA, BRUNO, 45)
    mouth, wall = first_contact(boxed(CLARA), boxed(BASIN)), first_contact(CLARA, BASIN)
    if nothing is not None:
        raise SystemExit("the hulls of Anna and Bruno are not to meet")
    side, gap, view = 340, 20, 430
    message = "Boxes meet long before hulls do, or where hulls never meet"
    picture = Picture(2 * side + 3 * gap, 30 + 2 * (side + 50), message, "Two pairs of hulls at two times each, with the boxes around them.")
    picture.heading(message)

    def panel(column, row, middle, t, things, caption, beside=BESIDE):
        left, top = gap + column * (side + gap), 50 + row * (side + 50)

        def pixel(x, y):
            return left + ((x - middle[0]) / view + 0.5) * side, top + (0.5 - (y - middle[1]) / view) * side
        picture.add(f'<svg x="{left}" y="{top}" width="{side}" height="{side}" viewBox="{left} {top} {side} {side}">')
        picture.rect(left, top, side, side, "water")
        for name, x, y, vx, vy, corners, heading in things:
            outline = [(x + vx * t + dx, y + vy * t + dy) for dx, dy in turned(corners, heading)]
            d = "M" + "L".join(f"{number(px)} {number(py)}" for px, py in (pixel(*corner) for corner in outline)) + "Z"
            picture.add(f'<path class="f-{"foresee" if vx or vy else "quay"}" d="{d}"/>')
            picture.path([pixel(*corner) for corner in box_around(outline)], "meet", 1.5, "6 4", True)
            at = x + vx * t, y + vy * t
            if vx or vy:
                ahead = math.hypot(vx, vy)
                start = pixel(at[0] + 95 * vx / ahead, at[1] + 95 * vy / ahead)
                arrow(picture, *start, vx, -vy, "foresee", 24)
            dx, dy = beside[name]
            picture.text(*pixel(at[0] + dx, at[1] + dy), name, size=13)
        scale_bar(picture, left + side - 105, top + side - 12, 100 * side / view, "100 m")
        picture.add("</svg>")
        picture.text(left, top + side + 20, caption, size=13)

    lane, basin = (342, 300), (1050, 322)
    panel(0, 0, lane, boxes[0], (ANNA, BRUNO), f"{boxes[0]:.1f} s: the boxes touch")
    panel(1, 0, lane, passing[1], (ANNA, BRUNO), f"{passing[1]:.1f} s: the boxes overlap, the hulls pass")
    panel(0, 1, basin, mouth[0], (BASIN, CLARA), f"{mouth[0]:.1f} s: the boxes touch")
    panel(1, 1, basin, wall[0], (BASIN, CLARA), f"{wall[0]:.1f} s: hull and quay touch", {**BESIDE, "Clara": (-20, -108)})
    return picture


# --- Traffic that gives way

H, WITHIN, RADIUS = 60, 50, 10
# caption, ids, middle, metres across
TRAFFIC = [("head-on", (1, 2), (0, 500), 1200), ("overtaking", (3, 4), (2000, 60), 1200), ("crossing", (5, 6), (4100, 0), 1200)]
RING = ("ring", tuple(range(11, 19)), (6600, 0), 1060)


def run(db, wanted):
    """The step's statements that begin with one of these words."""
    statement = ""
    for part in re.sub(r"^\..*\n", "", STEP.read_text(), flags=re.M).splitlines(keepends=True):
        statement += part
        if sqlite3.complete_statement(statement):
            if statement.strip().startswith(wanted):
                db.execute(statement)
            statement = ""


def state(db):
    """{id: (x, y, vx, vy, name, time of the nearest encounter or None)}"""
    nearest = {}
    for a, b, t in db.execute("SELECT a, b, t_cpa FROM predictive_join(?, 'traffic', ?) ORDER BY t_cpa, a, b", (H, WITHIN)):
        nearest.setdefault(a, t), nearest.setdefault(b, t)
    return {row[0]: (*row[1:], nearest.get(row[0])) for row in db.execute("SELECT id, x, y, vx, vy, name FROM traffic")}


def before_and_after():
    db = connect()
    run(db, ("CREATE", "INSERT INTO traffic"))
    before = state(db)
    run(db, ("INSERT OR IGNORE INTO advice",))
    return before, state(db), {row[0]: row[1:] for row in db.execute("SELECT id, manoeuvre, k FROM advice WHERE k IS NOT NULL")}


def draw_traffic(picture, left, top, side, scene, objects, seconds=0, names=False, numbers=False):
    """Paths of a minute; where objects meet, their protected discs of half the distance. Names stand behind, numbers to starboard."""
    _, ids, middle, across = scene
    scale = side / across

    def pixel(x, y):
        return left + ((x - middle[0]) / across + 0.5) * side, top + (0.5 - (y - middle[1]) / across) * side
    picture.add(f'<svg x="{number(left)}" y="{number(top)}" width="{side}" height="{side}" '
                f'viewBox="{number(left)} {number(top)} {side} {side}">')
    picture.rect(left, top, side, side, "water")
    for ship in ids:
        x, y, vx, vy, name, meets = objects[ship]
        start, end = pixel(x, y), pixel(x + H * vx, y + H * vy)
        picture.line(*start, *end, "track", 1.5)
    for ship in ids:
        x, y, vx, vy, name, meets = objects[ship]
        start, end = pixel(x, y), pixel(x + H * vx, y + H * vy)
        if meets is not None:
            picture.circle(*pixel(x + meets * vx, y + meets * vy), (RADIUS + WITHIN / 2) * scale, "meet", hollow=True)
        moving = "" if not seconds else animate("cx", [0, 1], [start[0], end[0]], seconds) + animate("cy", [0, 1], [start[1], end[1]], seconds)
        if seconds:  # the distance that is kept goes with it
            picture.add(f'<circle class="f-foresee" fill-opacity="0.15" cx="{number(start[0])}" cy="{number(start[1])}" '
                        f'r="{number((RADIUS + WITHIN / 2) * scale)}">{moving}</circle>')
        picture.add(f'<circle class="f-foresee" cx="{number(start[0])}" cy="{number(start[1])}" r="{number(max(3, RADIUS * scale))}">{moving}</circle>')
        if seconds:
            size = math.hypot(*(b - a for a, b in zip(start, end)))
            arrow(picture, *(b - 9 * (b - a) / size for a, b in zip(start, end)), vx, -vy, "track", 5)
        else:
            arrow(picture, *start, vx, -vy, "foresee", 18)
        if names or numbers:
            size = math.hypot(vx, vy)
            beside = (14 * vy, 14 * vx) if numbers else (-18 * vx, 18 * vy)
            picture.text(start[0] + beside[0] / size, start[1] + beside[1] / size + 4, str(ship) if numbers else name, anchor="middle", weight="bold")
    scale_bar(picture, left + side - 30 - 200 * scale, top + side - 14, 200 * scale, "200 m")
    picture.add("</svg>")


def traffic():
    """Three encounters before and after, with the manoeuvre that solves each."""
    before, after, advice = before_and_after()
    side, gap = 260, 20
    message = "One small change of one of the two keeps each pair 50 m apart"
    picture = Picture(gap + 3 * (side + gap), 62 + 2 * (side + 46), message, "Three encounters, before and after a manoeuvre of one object.")
    picture.heading(message, "paths of one minute; orange circles: half of the distance to keep around each of two that come closer")
    for row, (objects, when) in enumerate(((before, "before"), (after, "after"))):
        for column, scene in enumerate(TRAFFIC):
            left, top = gap + column * (side + gap), 62 + row * (side + 46)
            draw_traffic(picture, left, top, side, scene, objects, numbers=True)
            changes = [f"{ship} turns {advice[ship][1]:.1f}° to starboard" if advice[ship][0] == "turn"
                       else f"{ship} changes its speed" for ship in scene[1] if ship in advice]
            picture.text(left, top + side + 19, f"{scene[0]}: " + ("they meet" if row == 0 else ", ".join(changes) or "clear"), size=13)
    return picture


def ring():
    """The poster: eight drones bound for the opposite side of a ring, before and after."""
    before, after, advice = before_and_after()
    changed = sum(ship in advice for ship in RING[1])
    message = f"Eight drones fly through one point; {changed} manoeuvres, each proven clear, keep all 50 m apart"
    picture = Picture(1180, 660, message, "Eight drones in a ring, each bound for the opposite side: all meet in the middle; after the manoeuvres none do.")
    picture.heading(message, "one drone at a time changes, and the next change is computed after it (sql/tour/09_avoid.sql); discs and circles: half of the distance to keep")
    for column, (objects, caption) in enumerate(((before, "as planned: all eight meet in the middle after 40 to 50 s"),
                                                 (after, "after the manoeuvres: no two come within 50 m"))):
        draw_traffic(picture, 20 + 580 * column, 62, 560, RING, objects, 12, True)
        picture.text(20 + 580 * column, 644, caption, size=14)
    return picture
