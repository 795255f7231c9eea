#!/usr/bin/python3
"""What do advices change? Draws traffic.svg: the ways of a minute before and after, as sql/tour/09_avoid.sql makes them.

    python3 docs/pictures/traffic.py > docs/pictures/traffic.svg      # from the root, with build/release/foresee.so

FORESEE_EXTENSION names another build. The objects, and the statement that advises them one after another, are those of the tour's step;
each object is drawn with half of the distance that is kept, 25 m beyond its radius, at the moment of its nearest approach.
"""
import os
import re
import sqlite3
from pathlib import Path

STEP = Path(__file__).resolve().parents[2] / "sql/tour/09_avoid.sql"
H, WITHIN = 60, 50
# caption, ids, middle, metres across
SCENES = [("head-on", (1, 2), (0, 500), 1200), ("overtaking", (3, 4), (2000, 60), 1200), ("crossing", (5, 6), (4100, 0), 1200),
          ("a ring of eight", tuple(range(11, 19)), (6600, 0), 1200)]
SIDE, GAP, CAPTION = 220, 16, 24
INK, WATER, WAY, SHIP, MEETS = "#1b2733", "#eef4f8", "#9fb8c9", "#3d6f94", "#c2410c"


def connect():
    db = sqlite3.connect(":memory:")
    db.enable_load_extension(True)
    db.load_extension(os.environ.get("FORESEE_EXTENSION", "build/release/foresee").removesuffix(".so"))
    return db


def run(db, wanted):
    """The step's statements that begin with one of these words."""
    text = re.sub(r"^\..*\n", "", STEP.read_text(), flags=re.M)
    statement = ""
    for part in text.splitlines(keepends=True):
        statement += part
        if sqlite3.complete_statement(statement):
            if statement.strip().startswith(wanted):
                db.execute(statement)
            statement = ""


def state(db):
    """{id: (x, y, vx, vy, moment of the nearest encounter or None)}"""
    nearest = {}
    for a, b, t in db.execute("SELECT a, b, t_cpa FROM predictive_join(?, 'traffic', ?) ORDER BY t_cpa, a, b", (H, WITHIN)):
        nearest.setdefault(a, t), nearest.setdefault(b, t)
    return {row[0]: (*row[1:], nearest.get(row[0])) for row in db.execute("SELECT id, x, y, vx, vy FROM traffic")}


def panel(left, top, scene, objects, caption):
    _, ids, middle, across = scene

    def pixel(x, y):
        return left + ((x - middle[0]) / across + 0.5) * SIDE, top + (0.5 - (y - middle[1]) / across) * SIDE

    scale = SIDE / across
    lines = [f'<svg x="{left}" y="{top}" width="{SIDE}" height="{SIDE}" viewBox="{left} {top} {SIDE} {SIDE}">',
             f'<rect x="{left}" y="{top}" width="{SIDE}" height="{SIDE}" fill="{WATER}"/>']
    for number in ids:
        x, y, vx, vy, meets = objects[number]
        (x0, y0), (x1, y1) = pixel(x, y), pixel(x + H * vx, y + H * vy)
        lines.append(f'<line x1="{x0:.1f}" y1="{y0:.1f}" x2="{x1:.1f}" y2="{y1:.1f}" stroke="{WAY}" stroke-width="1.5"/>')
        lines.append(f'<circle cx="{x0:.1f}" cy="{y0:.1f}" r="{10 * scale:.1f}" fill="{SHIP}"/>')
        if meets is not None:
            x2, y2 = pixel(x + meets * vx, y + meets * vy)
            lines.append(f'<circle cx="{x2:.1f}" cy="{y2:.1f}" r="{(10 + WITHIN / 2) * scale:.1f}" fill="none" stroke="{MEETS}"/>')
    lines.append("</svg>")
    lines.append(f'<text x="{left}" y="{top + SIDE + 16}" fill="{INK}">{caption}</text>')
    return lines


def main():
    db = connect()
    run(db, ("CREATE", "INSERT INTO traffic"))
    before = state(db)
    run(db, ("INSERT OR IGNORE INTO advice",))
    after = state(db)
    width, height = GAP + len(SCENES) * (SIDE + GAP), GAP + 2 * (SIDE + CAPTION + GAP)
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}" '
             'font-family="sans-serif" font-size="13">', f'<rect width="{width}" height="{height}" fill="white"/>']
    for row, (objects, when) in enumerate(((before, "before"), (after, "after"))):
        for column, scene in enumerate(SCENES):
            met = sum(objects[number][4] is not None for number in scene[1])
            caption = f"{scene[0]}, {when}: " + (f"{met} meet" if met else "all clear")
            lines += panel(GAP + column * (SIDE + GAP), GAP + row * (SIDE + CAPTION + GAP), scene, objects, caption)
    print("\n".join([*lines, "</svg>"]))


if __name__ == "__main__":
    main()
