"""The figures of compare.sh as text: tables of the README and the pages, between their markers, from compare.csv.

    python3 bench/compare_pages.py            # writes them into README.md, docs/developers/benchmarks.md, docs/explanation/choosing.md
    python3 bench/compare_pages.py --quick    # prints those of build/benchmarks/

A marker is a line `<!-- compare NAME -->`; what follows it, up to `<!-- end -->`, is replaced. tests/house/benchmarks_test.py compares
the pages with the file.
"""
import csv
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
FOLDER = ROOT / "docs/developers/benchmarks"
PAGES = ("README.md", "docs/developers/benchmarks.md", "docs/explanation/choosing.md")
SIZES = (1000, 10000, 100000, 1000000)
# The order of the table, with what each is called there.
METHODS = {
    "foresee grid": "**foresee: production grid**",
    "foresee TPR-tree": "foresee: TPR-tree",
    "GPCD": "GPCD (reference implementation of the paper)",
    "libspatialindex TPR-tree": "libspatialindex: TPR-tree",
    "Boost R-tree": "Boost: R-tree",
    "brute force": "brute force",
    "time stepping": "time stepping, 30 steps",
    "foresee in SQL": "**foresee in SQL**",
    "R*Tree in SQL": "SQLite R\\*Tree in SQL",
    "DuckDB cells": "DuckDB in SQL: a grid by hand",
    "DuckDB range join": "DuckDB in SQL: ranges joined",
}


class Figures:
    """The rows of compare.csv by scene and method."""

    def __init__(self, path):
        with path.open(newline="") as file:
            self.rows = {(row["scene"], row["method"]): row for row in csv.DictReader(file)}

    def of(self, scene, method, column):
        text = self.rows.get((scene, method), {}).get(column, "")
        return float(text) if text else None

    def over(self, scene, method):
        """The limit that the join exceeded."""
        return self.of(scene, method, "over_s")

    def known(self, method):
        return any(name == method for _, name in self.rows)

    def largest(self, *methods):
        """The most objects of a scene that all these have joined."""
        return max(size for size in SIZES if all(self.of(f"U-{size}", method, "join_s") is not None for method in methods))


def number(value):
    """Three digits: 0.123, 4.56, 78.9, 1,230."""
    digits = f"{value:.3g}"
    return f"{float(digits):,.0f}" if "e" in digits or value >= 100 else digits


def time(seconds):
    for scale, unit in ((1e6, "µs"), (1e3, "ms")):
        if seconds * scale < 999.5:
            return f"{number(seconds * scale)} {unit}"
    return f"{number(seconds)} s"


def count(value):
    return f"{value:,.0f}"


def power(size):
    return f"10<sup>{len(str(size)) - 1}</sup>"


def compare_table(figures):
    """Joins by scene; build, report, the join after the reports, and memory at the largest size that a method has."""
    sizes = [size for size in SIZES if size <= figures.largest("foresee grid")]
    ships = figures.rows["ships", "foresee grid"]["objects"]
    yield (f"| | join, {ships} ships | " + " | ".join(f"join, {power(size)}" for size in sizes) +
           " | build | report | join after reports | memory |")
    yield "|---" * (len(sizes) + 6) + "|"
    for method, name in METHODS.items():
        if not figures.known(method):
            continue
        ships = figures.of("ships", method, "join_s")
        cells, last = ["–" if ships is None else time(ships)], None
        for size in sizes:
            scene, seconds = f"U-{size}", figures.of(f"U-{size}", method, "join_s")
            if (scene, method) in figures.rows:
                last = scene
            over = figures.over(scene, method)
            cells.append(time(seconds) if seconds is not None else f"over {over:g} s" if over else "")
        size = int(last.split("-")[1])
        at = "" if size == sizes[-1] else f" ({power(size)})"
        for column in ("build_s", "report_s", "join_after_s"):
            value = figures.of(last, method, column)
            cells.append("–" if value is None else time(value) + at)
        cells.append(f"{number(figures.of(last, method, 'memory_bytes') / 1e6)} MB{at}")
        yield f"| {name} | " + " | ".join(cells) + " |"


def numbers_table(figures):
    """The three figures of the README."""
    rivals = [name for name in ("R*Tree in SQL", "DuckDB cells") if figures.known(name)]
    names = {"R*Tree in SQL": "R\\*Tree in SQL", "DuckDB cells": "DuckDB, hand-written grid join"}
    yield "| | foresee | " + " | ".join(names[name] for name in rivals) + " |"
    yield "|---" * (len(rivals) + 2) + "|"

    def row(what, scene, column, shown):
        ours = figures.of(scene, "foresee in SQL", column)
        theirs = [figures.of(scene, name, column) for name in rivals]
        cells = []
        for name, value in zip(rivals, theirs):
            if value is None:
                cells.append("too long")
            elif shown is time:
                cells.append(f"{time(value)} ({number(value / ours)} times)")
            else:
                cells.append(shown(value) + (" (no index)" if name.startswith("DuckDB") else ""))
        return f"| {what} | {shown(ours)} | " + " | ".join(cells) + " |"

    size = min(100000, figures.largest("foresee in SQL", "R*Tree in SQL"))
    scene = f"U-{size}"

    def per_second(seconds):
        return count(float(f"{1 / seconds:.3g}"))

    pairs = count(figures.of("ships", "foresee in SQL", "pairs"))
    yield row(f"real ships of New York Harbour, {figures.rows['ships', 'foresee in SQL']['objects']} of them: the {pairs} pairs "
              "within half a nautical mile in the next 10 minutes", "ships", "join_s", time)
    yield row(f"{count(size)} moving boxes: all {count(figures.of(scene, 'foresee in SQL', 'pairs'))} pairs that touch, with times",
              scene, "join_s", time)
    yield row("reports (x, y, vx, vy) stored in one transaction, in memory, per second", scene, "report_s", per_second)


def choosing_table(figures):
    """foresee in SQL beside the R*Tree and DuckDB, to 100,000 objects."""
    size = min(100000, figures.largest("foresee in SQL", "R*Tree in SQL"))
    scene = f"U-{size}"
    rivals = [name for name in ("R*Tree in SQL", "DuckDB cells", "DuckDB range join") if figures.known(name)]
    yield "| | foresee | " + " | ".join(METHODS[name].replace(" in SQL", "") for name in rivals) + " |"
    yield "|---" * (len(rivals) + 2) + "|"
    for what, scene, column in (("join of 237 real ships", "ships", "join_s"), ("join of 1,000 boxes", "U-1000", "join_s"),
                                (f"join of {count(size)} boxes", scene, "join_s"), (f"load of {count(size)} boxes", scene, "build_s"),
                                ("one report (x, y, vx, vy) of a batch, in memory", scene, "report_s")):
        ours = figures.of(scene, "foresee in SQL", column)
        cells = []
        for name in rivals:
            value = figures.of(scene, name, column)
            cells.append("too long" if value is None else f"{time(value)} ({number(value / ours)})")
        yield f"| {what} | {time(ours)} | " + " | ".join(cells) + " |"


def run_text(figures, folder):
    """Which machine, and whether its figures can be trusted."""
    machine = dict(line.split(": ", 1) for line in (folder / "compare_machine.txt").read_text().splitlines() if ": " in line)
    loads = [machine[f"Load average at the {when}"] for when in ("start", "end")]
    yield f"{'The published' if folder == FOLDER else 'This'} run: {machine['CPU'].split(';')[0]}; up to {count(figures.largest('foresee grid'))} objects. The load average was"
    yield f"{loads[0].split()[0]} at the start and {loads[1].split()[0]} at the end."
    if max(float(load.split()[0]) for load in loads) > 1.5:
        yield "**The machine was busy: trust the ratios more than the times.**"


def blocks(figures, folder=FOLDER):
    return {"table": list(compare_table(figures)), "numbers": list(numbers_table(figures)),
            "choosing": list(choosing_table(figures)), "run": list(run_text(figures, folder))}


def filled(text, made):
    """The page with what stands between its markers replaced."""
    return re.sub(r"<!-- compare (\w+) -->\n.*?<!-- end -->", lambda found: "\n".join(
        [f"<!-- compare {found[1]} -->", "", *made[found[1]], "", "<!-- end -->"]), text, flags=re.S)


def main():
    if "--quick" in sys.argv:
        for lines in blocks(Figures(ROOT / "build/benchmarks/compare.csv"), ROOT / "build/benchmarks").values():
            print("\n".join(lines), "\n")
        return
    made = blocks(Figures(FOLDER / "compare.csv"))
    for page in PAGES:
        path = ROOT / page
        path.write_text(filled(path.read_text(), made))


if __name__ == "__main__":
    main()
