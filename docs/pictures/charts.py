"""The charts of the benchmarks, from the CSV files beside the pages."""
import csv
import math
import re

from svg import SECONDS, Linear, Log, Panel, Picture

# method of compare.csv: label, colour, mark, dash
COMPARED = {
    "foresee grid": ("foresee: grid", "foresee", "dot", ""),
    "foresee in SQL": ("foresee in SQL", "foresee", "square", "7 3"),
    "foresee TPR-tree": ("foresee: TPR-tree", "foresee", "up", "2 3"),
    "GPCD": ("GPCD", "grey1", "up", ""),
    "Boost R-tree": ("Boost R-tree", "grey2", "dot", ""),
    "libspatialindex TPR-tree": ("libspatialindex TPR-tree", "grey2", "diamond", "2 3"),
    "R*Tree in SQL": ("R*Tree in SQL", "grey1", "square", "7 3"),
    "DuckDB cells": ("DuckDB, grid by hand", "grey3", "square", "7 3"),
    "DuckDB range join": ("DuckDB, ranges", "grey3", "down", "7 3"),
    "brute force": ("brute force", "grey1", "diamond", "1 3"),
    "time stepping": ("time stepping", "grey3", "diamond", "1 3"),
}
OBJECTS = {3: "1,000", 4: "10,000", 5: "100,000", 6: "1,000,000"}


def rows(path):
    with path.open(newline="") as file:
        return list(csv.DictReader(file))


def compare(folder):
    """Four panels: join, build, report, memory."""
    table = [row for row in rows(folder / "compare.csv") if row["scene"].startswith("U-")]
    largest = max(int(row["objects"]) for row in table)
    fastest = {size: min((float(row["join_s"]), row["method"]) for row in table if row["objects"] == size and row["join_s"])[1]
               for size in {row["objects"] for row in table}}
    message = ("foresee's grid joins moving objects fastest at every size" if set(fastest.values()) == {"foresee grid"}
               else "Joining moving objects: foresee beside other methods and products")
    picture = Picture(1180, 860, message, "Four charts against the number of objects: time of a join, of building, of one report, and memory.")
    picture.heading(message, f"scenes U-1000 to U-{largest}: boxes in uniform motion, about one pair per object; processor time of one thread; "
                    "open ring: stopped there, too long")
    panels = [("Join: all pairs with times", "join_s", (1e-5, 100), "time per join", SECONDS),
              ("Build: from an array to what can be joined", "build_s", (1e-4, 1000), "time to build", SECONDS),
              ("Report: one object moves", "report_s", (1e-8, 1e-2), "time per report", SECONDS),
              ("Memory: at most, beyond the objects", "memory_bytes", (1e5, 1e10), "bytes",
               {5: "100 kB", 6: "1 MB", 7: "10 MB", 8: "100 MB", 9: "1 GB", 10: "10 GB"})]
    for place, (title, column, (low, high), y_name, names) in enumerate(panels):
        left, top = 86 + 590 * (place % 2), 96 + 400 * (place // 2)
        panel = Panel(picture, left, top, 300, 300, Log(1e3, 10 ** math.ceil(math.log10(largest)), OBJECTS), Log(low, high, names), title,
                      "objects", y_name)
        for method, (label, colour, mark, dash) in COMPARED.items():
            mine = sorted((row for row in table if row["method"] == method), key=lambda row: int(row["objects"]))
            points = [(int(row["objects"]), max(low, float(row[column]))) for row in mine if row[column]]
            stop = next(((int(row["objects"]), float(row["over_s"])) for row in mine if row["over_s"]), None)
            over = stop if column == "join_s" else None
            missed = max((float(row["missed"] or 0) for row in mine), default=0)
            note = f" (misses {100 * missed:.0f} %)" if missed and column == "join_s" else ""
            if points or over:
                panel.series(points, label, colour, mark, dash, 2.4 if colour == "foresee" else 1.5, over, note)
        panel.write_labels()
    return picture


def growth(folder):
    """How the join grows with the horizon and with giants."""
    table = rows(folder / "growth.csv")
    message = "Long horizons and large objects cost R-trees and box sorting far more than foresee"
    picture = Picture(1180, 440, message, "Nanoseconds per object against the horizon, and against the share of objects 100 times larger.")
    picture.heading(message, "100,000 objects, without SQL, processor time of one thread; h = 0: contact at one instant; rivals were measured up to 30 s")
    names = {-8: "10 ns", **SECONDS}
    for place, (letter, title, x_name, x) in enumerate((
            ("L", "Horizon (L-h: uniform motion)", "horizon, seconds", Log(1, 300, {0: "1", 1: "10", 2: "100"})),
            ("G", "Giants (G-p: objects 100 times larger)", "percent of the objects", Log(0.01, 1, {-2: "0.01", -1: "0.1", 0: "1"})))):
        panel = Panel(picture, 86 + 590 * place, 96, 320, 280, x, Log(1e-8, 1e-3, names), title, x_name, "time per object")
        for method, label, colour, mark, dash in (("foresee", "foresee, exact", "foresee", "dot", ""),
                                                  ("boost rtree", "Boost R-tree", "grey2", "dot", ""),
                                                  ("cgal boxes", "CGAL boxes", "grey1", "square", "7 3"),
                                                  ("at rest", "foresee, h = 0", "foresee", "up", "2 3")):
            panel.series([(float(row["workload"].split("-")[1]), float(row["ns_per_object"]) * 1e-9) for row in table
                          if row["method"] == method and row["workload"].startswith(letter + "-")], label, colour, mark, dash)
        panel.write_labels()
    return picture


def paper_time(folder):
    """Milliseconds per join against n, in the three distributions of the paper."""
    table = [row for row in rows(folder / "paper.csv") if row["sweep"] == "n" and row["motion"] == "accelerated"]
    message = "On the paper's scene the grid is fastest; brute force takes 30 to 150 times as long as GPCD"
    picture = Picture(1170, 440, message, "Time per join against the number of objects, for three distributions of the centres.")
    picture.heading(message, "10000 × 10000 × 50, accelerated motion, horizon 3, processor time of one thread")
    for place, spread in enumerate(("uniform", "zipf", "city")):
        mine = [row for row in table if row["spread"] == spread]
        panel = Panel(picture, 86 + 300 * place, 96, 220, 280, Linear(800, 5200, (1000, 2000, 3000, 4000, 5000)),
                      Log(5e-5, 1, SECONDS), spread, "objects", "time per join" if place == 0 else "")
        for column, label, colour, mark, dash in (("scan_ms", "brute force", "grey1", "diamond", "1 3"),
                                                  ("gpcd_ms", "GPCD", "grey1", "up", ""),
                                                  ("load_ms", "foresee: TPR-tree, with its load", "foresee", "ring", "2 3"),
                                                  ("sij-tpr_ms", "foresee: TPR-tree", "foresee", "up", "2 3"),
                                                  ("grid_ms", "foresee: grid", "foresee", "dot", "")):
            extra = "sij-tpr_ms" if column == "load_ms" else None
            points = [(int(row["n"]), (float(row[column]) + (float(row[extra]) if extra else 0)) * 1e-3) for row in mine]
            panel.series(points, label if place == 2 else "", colour, mark, dash)
        panel.write_labels()
    return picture


def paper_prune(folder):
    """What each stage of the paper removes of what the stage before has left."""
    sums = {}
    for row in rows(folder / "paper_stages.csv"):
        entry = sums.setdefault((row["stage"], row["spread"]), [0, 0])
        entry[0] += int(row["before"])
        entry[1] += int(row["after"])
    stages = list(dict.fromkeys(stage for stage, _ in sums))
    message = "Space removes nearly all pairs; of the paper's later tests only that of time pays"
    picture = Picture(900, 116 + 62 * len(stages), message, "Percent of the pairs that each stage removes, for three distributions.")
    picture.heading(message, "pairs that a stage removes, in percent of the pairs before it; all settings of the paper")
    left, width = 210, 560
    for value in range(0, 101, 20):
        x = left + width * value / 100
        picture.line(x, 66, x, 74 + 62 * len(stages) - 8, "rule")
        picture.text(x, 74 + 62 * len(stages) + 8, f"{value} %", "soft", "middle", 11)
    picture.text(left + width / 2, 74 + 62 * len(stages) + 28, "pairs removed by the stage", "soft", "middle")
    for place, stage in enumerate(stages):
        top = 72 + 62 * place
        picture.text(left - 12, top + 30, stage, anchor="end")
        for line, (spread, colour) in enumerate((("uniform", "grey1"), ("zipf", "grey3"), ("city", "grey4"))):
            before, after = sums[stage, spread]
            share = (before - after) / before if before else 0
            picture.rect(left, top + 16 * line, max(1, width * share), 13, colour)
            picture.text(left + width * share + 6, top + 16 * line + 11, f"{100 * share:.{2 if share > 0.999 else 1}f} % {spread}", "soft", size=11)
    return picture


def pairs_of(lines):
    """Rows of pairs.csv from what bench_outline_cost and bench_mesh_cost print, of scenes that have rivals."""
    found, scene = [], ""
    for line in lines:
        if not line.startswith(" ") and " pairs, " in line:
            scene = line.split(": ")[0]
        elif ours := re.match(r" +foresee .*?([\d.]+) ns t ", line):
            found.append((scene, "foresee", ours[1], ""))
        elif rival := re.match(r" +(.+?) +([\d.]+) ns: .* of (\d+) in \d+ pairs misses (\d+), .* t off by (\S+) s", line):
            name, cost, touch, missed, late = rival.groups()
            errs = (f"misses {missed} of {touch}, " if int(missed) else "") + f"{float(late):g} s late"
            found.append((scene, name, cost, errs if float(late) > 1e-6 or int(missed) else ""))
    return [row for row in found if sum(other[0] == row[0] for other in found) > 1]


def pairs(folder):
    """Nanoseconds per pair until the first time of contact is known; with what a sampler misses."""
    table = rows(folder / "pairs.csv")
    scenes = list(dict.fromkeys(row["scene"] for row in table))
    colours = {"foresee": ("foresee", "foresee, exact"), "plain double": ("grey1", "textbook in plain double"),
               "FCL, 10 samples": ("grey4", "FCL, 10 samples"), "FCL, 1000 samples": ("grey3", "FCL, 1000 samples"),
               "Boost, steps of 0.1 s": ("grey2", "Boost, steps of 0.1 s")}
    height = 76 + sum(18 + 16 * sum(row["scene"] == scene for row in table) for scene in scenes) + 54
    message = "Outlines and meshes: the exact first time costs less than the textbook's; ten samples miss contacts"
    picture = Picture(1020, height, message, "Time per pair of outlines or meshes until the first contact is known, by method.")
    picture.heading(message, "time per pair until the first contact is known; beside a bar: how the method errs")
    left, width = 250, 480
    scale = Log(1e-7, 1e-1, SECONDS)
    for value, name in scale.ticks():
        x = left + width * scale.share(value)
        picture.line(x, 66, x, height - 50, "rule")
        picture.text(x, height - 34, name, "soft", "middle", 11)
    picture.text(left + width / 2, height - 14, "time per pair", "soft", "middle")
    y = 72
    for scene in scenes:
        mine = [row for row in table if row["scene"] == scene]
        picture.text(left - 10, y + 8 * len(mine) + 3, scene.replace("such a star", "a star of 100 corners"), anchor="end")
        for row in mine:
            colour, label = colours.get(row["method"], ("grey2", row["method"]))
            end = width * scale.share(float(row["ns"]) * 1e-9)
            picture.rect(left, y, end, 13, colour)
            picture.text(left + end + 6, y + 11, label + (f": {row['errs']}" if row["errs"] else ""), "soft" if colour != "foresee" else "foresee", size=11)
            y += 16
        y += 18
    return picture
