#!/usr/bin/env python3
"""Draws what bench_outline_cost and bench_mesh_cost print: nanoseconds a pair until the first moment is known.

    (build/release/bench/bench_outline_cost; build/release/bench/bench_mesh_cost) | python3 docs/developers/benchmarks/pairs.py > docs/developers/benchmarks/pairs.svg
"""
import math
import re
import sys

COLOURS = {"foresee": "#d62728", "plain double": "#1f77b4", "FCL, 10 samples": "#98df8a", "FCL, 1000 samples": "#2ca02c",
           "Boost, steps of 0.1 s": "#ff7f0e"}
LEFT, WIDTH, BAR = 270, 640, 13
LOWEST, HIGHEST = 2, 8  # powers of ten


def scenes(lines):
    """(title, [(method, nanoseconds)]) of each scene that has rivals."""
    found = []
    for line in lines:
        if line.startswith("    foresee"):
            found[-1][1].append(("foresee", float(re.search(r"([\d.]+) ns t ", line)[1])))
        elif line.startswith("    "):
            name, cost = re.match(r" +(.+?) +([\d.]+) ns:", line).groups()
            if name in COLOURS:
                found[-1][1].append((name, float(cost)))
        elif " pairs, " in line:
            found.append((line.split(": ")[0], []))
    return [scene for scene in found if len(scene[1]) > 1]


def x_of(nanoseconds):
    return LEFT + WIDTH * (math.log10(nanoseconds) - LOWEST) / (HIGHEST - LOWEST)


def draw(found):
    height = 60 + sum(BAR * len(bars) + 14 for _, bars in found)
    yield f'<svg xmlns="http://www.w3.org/2000/svg" width="{LEFT + WIDTH + 20}" height="{height}" font-family="sans-serif" font-size="11">'
    yield '<rect width="100%" height="100%" fill="white"/>'
    for power, name in zip(range(LOWEST, HIGHEST + 1), ("100 ns", "1 µs", "10 µs", "100 µs", "1 ms", "10 ms", "100 ms")):
        x = x_of(10**power)
        yield f'<line x1="{x:.0f}" y1="40" x2="{x:.0f}" y2="{height - 16}" stroke="#dddddd"/>'
        yield f'<text x="{x:.0f}" y="{height - 4}" text-anchor="middle">{name}</text>'
    for place, (name, colour) in enumerate(COLOURS.items()):
        label = "foresee, exact" if name == "foresee" else name
        yield f'<text x="{40 + 180 * place}" y="22" fill="{colour}" font-weight="bold">{label}</text>'
    y = 44
    for title, bars in found:
        yield f'<text x="{LEFT - 8}" y="{y + BAR * len(bars) / 2 + 4:.0f}" text-anchor="end">{title}</text>'
        for name, cost in bars:
            yield f'<rect x="{LEFT}" y="{y}" width="{x_of(cost) - LEFT:.1f}" height="{BAR - 2}" fill="{COLOURS[name]}"/>'
            y += BAR
        y += 14
    yield "</svg>"


print("\n".join(draw(scenes(sys.stdin))))
