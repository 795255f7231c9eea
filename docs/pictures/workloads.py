"""What do the workloads look like? A cut of each scene, by the rules of bench/workloads.h, with the paths of its horizon."""
import math
import random

from svg import Picture, number

SIDE, GAP = 250, 24


def even(draw, side, v_max=3.0, half=0.5, density=1 / 14):
    """(x, y, vx, vy, half) at S-n's density in a square."""
    for _ in range(round(side * side * density)):
        yield draw.uniform(0, side), draw.uniform(0, side), draw.uniform(-v_max, v_max), draw.uniform(-v_max, v_max), half


def mixed(draw, side):
    for place, (x, y, vx, vy, half) in enumerate(even(draw, side)):
        fast = 1000 if place % 100 == 7 else 1
        yield x, y, vx * fast, vy * fast, half * (12 if place == 111 else 1)  # 1000 times larger would cover the cut


def giants(draw, side):
    for place, (x, y, vx, vy, half) in enumerate(even(draw, side)):
        yield x, y, vx, vy, half * (100 if place % 1000 == 500 else 1)


def paper(spread):
    def scene(draw, side):
        steps, cumulative = 0.0, []
        for k in range(1, 1001):
            cumulative.append(steps := steps + k ** -0.8)
        cities = [(draw.uniform(0, side), draw.uniform(0, side)) for _ in range(50)]
        for _ in range(2000):
            if spread == "uniform":
                x, y = draw.uniform(0, side), draw.uniform(0, side)
            elif spread == "zipf":
                x, y = zipf(draw, cumulative), zipf(draw, cumulative)
            else:
                city = draw.choice(cities)
                x, y = draw.gauss(city[0], 150), draw.gauss(city[1], 150)
            yield x, y, draw.uniform(-3, 3), draw.uniform(-3, 3), 2.5
    return scene


def zipf(draw, cumulative):
    """A bin of ten units by P(k) ~ k^-0.8, and a place in it."""
    at, low, high = draw.uniform(0, cumulative[-1]), 0, len(cumulative) - 1
    while low < high:
        middle = (low + high) // 2
        low, high = (low, middle) if cumulative[middle] >= at else (middle + 1, high)
    return 10 * (low + draw.random())


# name, caption, rules, side of the cut, units of its bar
SCENES = [("U-n, S-n, K-n", "boxes of side 1, about one pair each", even, 60, 10),
          ("M-n", "S-n; some are fast, few are huge", mixed, 60, 10),
          ("G-0.1", "S-n; one in a thousand is 100 times larger", giants, 180, 50),
          ("P-uniform-2000", "the paper's scene, uniform", paper("uniform"), 10000, 2000),
          ("P-zipf-2000", "the paper's scene, by Zipf's law", paper("zipf"), 10000, 2000),
          ("P-city-2000", "the paper's scene, 50 cities", paper("city"), 10000, 2000)]


def workloads(_):
    message = "The scenes of the benchmarks: even, mixed, giants, and the paper's three"
    picture = Picture(GAP + 3 * (SIDE + GAP), 62 + 2 * (SIDE + 58), message, "Six cuts of scenes: boxes at the start, and lines to where they are at the end of the horizon.")
    picture.heading(message, "blue: boxes at the start; lines: their paths during the horizon of 3")
    for place, (name, caption, rules, side, bar) in enumerate(SCENES):
        left, top, scale = GAP + (SIDE + GAP) * (place % 3), 62 + (SIDE + 58) * (place // 3), SIDE / side
        picture.add(f'<svg x="{left}" y="{top}" width="{SIDE}" height="{SIDE}" viewBox="0 0 {SIDE} {SIDE}">')
        picture.rect(0, 0, SIDE, SIDE, "water")
        boxes, large, paths = [], [], []
        for x, y, vx, vy, half in rules(random.Random(1), side):
            px, py, edge = x * scale, SIDE - y * scale, max(1.1, 2 * half * scale)
            (boxes if edge < 30 else large).append(f"M{number(px - edge / 2)} {number(py - edge / 2)}h{number(edge)}v{number(edge)}h{number(-edge)}z")
            if side < 100 and 3 * math.hypot(vx, vy) * scale > 1:
                paths.append(f"M{number(px)} {number(py)}l{number(3 * vx * scale)} {number(-3 * vy * scale)}")
        if paths:
            picture.add(f'<path class="s-grey3" d="{"".join(paths)}" stroke-width="0.7" fill="none"/>')
        picture.add(f'<path class="f-foresee" d="{"".join(boxes)}" fill-opacity="0.75"/>')
        if large:
            picture.add(f'<path class="f-foresee s-foresee" d="{"".join(large)}" fill-opacity="0.15" stroke-width="1"/>')
        picture.add("</svg>")
        picture.rect(left + SIDE - 18 - bar * scale, top + SIDE - 28, bar * scale + 12, 23, "ground", ' fill-opacity="0.85" rx="3"')
        picture.line(left + SIDE - 12 - bar * scale, top + SIDE - 10, left + SIDE - 12, top + SIDE - 10, "ink", 2)
        picture.text(left + SIDE - 12 - bar * scale / 2, top + SIDE - 15, f"{bar:,}", "ink", "middle", 11)
        picture.text(left, top + SIDE + 18, name, weight="bold")
        picture.text(left, top + SIDE + 34, caption, "soft")
    return picture
