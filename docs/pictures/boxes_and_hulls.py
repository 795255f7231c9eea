#!/usr/bin/python3
"""Why do boxes meet where hulls do not? Draws boxes_and_hulls.svg; the moments are those that the extension says.

    python3 docs/pictures/boxes_and_hulls.py > docs/pictures/boxes_and_hulls.svg      # from the root, with build/release/foresee.so

FORESEE_EXTENSION names another build. Lengths in metres, moments in seconds. The ships and the quay are those of
sql/tour/07_hulls.sql.
"""
import math
import os
import sqlite3

HULL = [(-8, -90), (8, -90), (8, 60), (0, 90), (-8, 60)]
QUAY = [(0, 0), (20, 0), (20, 180), (80, 180), (80, 0), (100, 0), (100, 200), (0, 200)]
# name, x, y, vx, vy, corners, heading
ANNA = ("Anna", 0, 0, 4, 4, HULL, 45)
BRUNO = ("Bruno", 684, 600, -4, -4, HULL, 225)
CLARA = ("Clara", 1050, 0, 0, 2, HULL, 0)
BASIN = ("quay", 1000, 300, 0, 0, QUAY, 0)
LABELS = {"Anna": (14, -6), "Bruno": (14, -6), "Clara": (60, 0), "quay": (34, 186)}  # where a name begins, seen from the position

VIEW = 400   # metres across a panel
SIDE = 340   # pixels across a panel
GAP, CAPTION = 20, 30
INK, WATER, HULLS, QUAYS, BOX = "#1b2733", "#eef4f8", "#3d6f94", "#8c7b6b", "#c2410c"


def turned(corners, heading):
    """Clockwise from the y axis. For the drawing alone: the extension turns exactly."""
    c, s = math.cos(math.radians(heading)), math.sin(math.radians(heading))
    return [(x * c + y * s, y * c - x * s) for x, y in corners]


def box_around(corners):
    xs, ys = zip(*corners)
    return [(min(xs), min(ys)), (max(xs), min(ys)), (max(xs), max(ys)), (min(xs), max(ys))]


def well_known_text(corners):
    return "POLYGON((" + ", ".join(f"{x!r} {y!r}" for x, y in [*corners, corners[0]]) + "))"


def first_contact(a, b, within=0):
    """(t, t_cpa) of the two as outlines, or None."""
    db = sqlite3.connect(":memory:")
    db.enable_load_extension(True)
    db.load_extension(os.environ.get("FORESEE_EXTENSION", "build/release/foresee").removesuffix(".so"))
    db.execute("CREATE VIRTUAL TABLE objects USING moving_objects(id, x, y, vx, vy, shape, heading)")
    for number, (_, x, y, vx, vy, corners, heading) in enumerate((a, b)):
        db.execute("INSERT INTO objects VALUES (?, ?, ?, ?, ?, ?, ?)", (number, x, y, vx, vy, well_known_text(corners), heading))
    return db.execute("SELECT t, t_cpa FROM predictive_join(300, 'objects', ?)", (within,)).fetchone()


def boxed(thing):
    """The box around it in its place."""
    name, x, y, vx, vy, corners, heading = thing
    return name, x, y, vx, vy, box_around(turned(corners, heading)), 0


def polygon(corners, style):
    points = " ".join(f"{x:.1f},{y:.1f}" for x, y in corners)
    return f'<polygon points="{points}" {style}/>'


def panel(column, row, middle, t, things, caption):
    """A square of the plane at the moment t, north up."""
    left, top = GAP + column * (SIDE + GAP), GAP + row * (SIDE + CAPTION + GAP)

    def pixel(x, y):
        return (left + ((x - middle[0]) / VIEW + 0.5) * SIDE, top + (0.5 - (y - middle[1]) / VIEW) * SIDE)

    yield f'<rect x="{left}" y="{top}" width="{SIDE}" height="{SIDE}" fill="{WATER}"/>'
    for name, x, y, vx, vy, corners, heading in things:
        at = (x + vx * t, y + vy * t)
        outline = turned(corners, heading)
        fill = HULLS if vx or vy else QUAYS
        yield polygon([pixel(at[0] + x, at[1] + y) for x, y in outline], f'fill="{fill}"')
        yield polygon([pixel(at[0] + x, at[1] + y) for x, y in box_around(outline)],
                      f'fill="none" stroke="{BOX}" stroke-width="1.5" stroke-dasharray="6 4"')
        label = pixel(at[0] + LABELS[name][0], at[1] + LABELS[name][1])
        yield f'<text x="{label[0]:.1f}" y="{label[1]:.1f}">{name}</text>'
    yield f'<text x="{left}" y="{top + SIDE + 20}">{caption}</text>'


def picture():
    boxes, nothing, passing = first_contact(boxed(ANNA), boxed(BRUNO)), first_contact(ANNA, BRUNO), first_contact(ANNA, BRUNO, 45)
    mouth, wall = first_contact(boxed(CLARA), boxed(BASIN)), first_contact(CLARA, BASIN)
    if nothing is not None:
        raise SystemExit("the hulls of Anna and Bruno are not to meet")
    width, height = 2 * SIDE + 3 * GAP, 2 * (SIDE + CAPTION + GAP) + GAP
    lane, harbour = (342, 300), (1050, 310)
    yield (f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}" '
           f'font-family="sans-serif" font-size="14" fill="{INK}">')
    yield f'<rect width="{width}" height="{height}" fill="#ffffff"/>'
    yield from panel(0, 0, lane, boxes[0], (ANNA, BRUNO), f"{boxes[0]:.1f} s: the boxes touch")
    yield from panel(1, 0, lane, passing[1], (ANNA, BRUNO), f"{passing[1]:.1f} s: the boxes overlap, the hulls pass")
    yield from panel(0, 1, harbour, mouth[0], (BASIN, CLARA), f"{mouth[0]:.1f} s: the boxes touch")
    yield from panel(1, 1, harbour, wall[0], (BASIN, CLARA), f"{wall[0]:.1f} s: hull and quay touch")
    yield "</svg>"


if __name__ == "__main__":
    print("\n".join(picture()))
