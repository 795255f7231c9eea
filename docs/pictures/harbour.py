#!/usr/bin/python3
"""Draws harbour.svg: the README's four ships, which move, and where the extension says that they meet.

    python3 docs/pictures/harbour.py > docs/pictures/harbour.svg      # from the root, with build/release/foresee.so

FORESEE_EXTENSION names another build. Lengths in metres, moments in seconds; 300 s pass in 15.
"""
import os
import sqlite3

SHIPS = [(1, 0, 0, 6, 0, 30, "Anna"), (2, 1200, 0, -6, 0, 30, "Bruno"), (3, 600, -1600, 0, 8, 30, "Clara"),
         (4, 600, 300, 0, 0, 30, "Dora")]
BEHIND = ("Anna", "Clara")  # whose names stand to the left, so that two that meet can be read
HORIZON, SECONDS = 300, 15
WEST, NORTH, ACROSS, SCALE = -330, 960, 1860, 0.4   # metres, metres, metres, pixels a metre
HEIGHT, BAR = 1060, 46                              # metres of water; pixels below it
STYLE = """
  .water { fill: #eef4f8 } .ink { fill: #1b2733 } .soft { fill: #5c6f7e } .track { stroke: #9fb6c6 } .rail { stroke: #c9d6df }
  .ship { fill: #3d6f94 } .meet { fill: #c2410c; stroke: #c2410c }
  @media (prefers-color-scheme: dark) {
    .water { fill: #10202c } .ink { fill: #dbe7ef } .soft { fill: #8aa0b0 } .track { stroke: #3b556a } .rail { stroke: #2b4151 }
    .ship { fill: #7fb2d6 } .meet { fill: #fb923c; stroke: #fb923c }
  }"""


def ask(db, question, *inputs):
    return db.execute(question, inputs).fetchall()


def pixel(x, y):
    return (x - WEST) * SCALE, (NORTH - y) * SCALE


def number(value):
    return f"{value:.2f}".rstrip("0").rstrip(".")


def animated(attribute, moments, values, mode="linear"):
    times = ";".join(f"{moment / HORIZON:.4g}" for moment in moments)
    return (f'<animate attributeName="{attribute}" values="{";".join(map(number, values))}" keyTimes="{times}" '
            f'calcMode="{mode}" dur="{SECONDS}s" repeatCount="indefinite"/>')


def track(db, ship, name):
    """The dashed way, the hull and the name that goes with it."""
    rows = ask(db, "SELECT t, x, y FROM predictive_track(0, ?, 60, 'ships') WHERE id = ? ORDER BY t", HORIZON, ship)
    moments = [row[0] for row in rows]
    xs, ys = zip(*(pixel(x, y) for _, x, y in rows))
    radius = number(30 * SCALE)
    yield (f'<line class="track" x1="{number(xs[0])}" y1="{number(ys[0])}" x2="{number(xs[-1])}" y2="{number(ys[-1])}" '
           'stroke-width="1.5" stroke-dasharray="2 6" stroke-linecap="round"/>')
    yield (f'<circle class="ship" cx="{number(xs[0])}" cy="{number(ys[0])}" r="{radius}">'
           + animated("cx", moments, xs) + animated("cy", moments, ys) + "</circle>")
    side, anchor = (-17, "end") if name in BEHIND else (17, "start")
    beside = [x + side for x in xs], [y - 13 for y in ys]
    yield (f'<text class="ink" x="{number(beside[0][0])}" y="{number(beside[1][0])}" text-anchor="{anchor}">{name}'
           + animated("x", moments, beside[0]) + animated("y", moments, beside[1]) + "</text>")


def meeting(db, a, t, t_end):
    """A ring that opens where the first of the two is when they touch, and stays while they do."""
    (x, y), = ask(db, "SELECT x, y FROM predictive_position(?, 'ships') WHERE id = ?", (t + t_end) / 2, a)
    x, y = map(number, pixel(x, y))
    moments = [0, t, t_end, min(t_end + 25, HORIZON), HORIZON]
    yield (f'<circle class="meet" cx="{x}" cy="{y}" r="0" fill-opacity="0.15" stroke-width="2" opacity="0">'
           + animated("r", moments, [12, 16, 34, 46, 46]) + animated("opacity", [0, t, t, t_end, moments[3], HORIZON], [0, 0, 1, 1, 0, 0])
           + "</circle>")


def bar(pairs, width, top):
    """The horizon from left to right, its meetings, and now."""
    left, right, middle = 24, width - 24, top + 16

    def at(moment):
        return left + (right - left) * moment / HORIZON

    yield f'<line class="rail" x1="{left}" y1="{middle}" x2="{right}" y2="{middle}" stroke-width="4" stroke-linecap="round"/>'
    for ship, other, _, t, t_end in pairs:
        yield (f'<line class="meet" x1="{number(at(t))}" y1="{middle}" x2="{number(at(t_end))}" y2="{middle}" stroke-width="8" '
               'stroke-linecap="round"/>')
        yield f'<text class="soft" x="{number(at((t + t_end) / 2))}" y="{number(middle + 21)}" text-anchor="middle">{ship} and {other}: {number(t)} s to {number(t_end)} s</text>'
    yield (f'<circle class="ink" cx="{left}" cy="{middle}" r="6">' + animated("cx", [0, HORIZON], [left, right]) + "</circle>")


def picture():
    db = sqlite3.connect(":memory:")
    db.enable_load_extension(True)
    db.load_extension(os.environ.get("FORESEE_EXTENSION", "build/release/foresee").removesuffix(".so"))
    db.execute("CREATE VIRTUAL TABLE ships USING moving_objects(id, x, y, vx, vy, r, +name TEXT)")
    db.executemany("INSERT INTO ships VALUES (?, ?, ?, ?, ?, ?, ?)", SHIPS)
    pairs = ask(db, "SELECT s.name, o.name, j.a, j.t, j.t_end FROM predictive_join(?) j JOIN ships s ON s.id = j.a "
                    "JOIN ships o ON o.id = j.b ORDER BY j.t", HORIZON)
    width, water = ACROSS * SCALE, HEIGHT * SCALE
    yield (f'<svg xmlns="http://www.w3.org/2000/svg" width="{number(width)}" height="{number(water + BAR)}" '
           f'viewBox="0 0 {number(width)} {number(water + BAR)}" font-family="system-ui, sans-serif" font-size="13">')
    yield f"<title>Four ships; Anna and Bruno touch after {number(pairs[0][3])} s</title>"
    yield f"<style>{STYLE}\n</style>"
    yield f'<rect class="water" width="{number(width)}" height="{number(water + BAR)}" rx="10"/>'
    yield f'<clipPath id="sea"><rect width="{number(width)}" height="{number(water)}"/></clipPath><g clip-path="url(#sea)">'
    for ship in SHIPS:
        yield from track(db, ship[0], ship[-1])
    for _, _, a, t, t_end in pairs:
        yield from meeting(db, a, t, t_end)
    yield "</g>"
    yield from bar(pairs, width, water)
    yield "</svg>"


if __name__ == "__main__":
    print("\n".join(picture()))
