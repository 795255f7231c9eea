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

    def stopped(self, scene, method):
        return self.rows.get((scene, method), {}).get("stopped") == "1"

    def known(self, method):
        return any(name == method for _, name in self.rows)

    def largest(self):
        return max(size for size in SIZES if (f"U-{size}", "foresee grid") in self.rows)


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


def compare_table(figures, limit):
    """Joins by size; build, report and memory at the largest size that a method has."""
    sizes = [size for size in SIZES if size <= figures.largest()]
    yield "| | " + " | ".join(f"join, {power(size)}" for size in sizes) + " | build | report | memory |"
    yield "|---" * (len(sizes) + 4) + "|"
    for method, name in METHODS.items():
        if not figures.known(method):
            continue
        cells, last = [], None
        for size in sizes:
            scene, seconds = f"U-{size}", figures.of(f"U-{size}", method, "join_s")
            if (scene, method) in figures.rows:
                last = scene
            over = figures.stopped(scene, method)
            cells.append(time(seconds) if seconds is not None else f"over {limit} s" if over else "")
        build, report = (figures.of(last, method, column) for column in ("build_s", "report_s"))
        size = int(last.split("-")[1])
        at = "" if size == sizes[-1] else f" ({power(size)})"
        cells += ["–" if build is None else time(build) + at, "–" if report is None else time(report) + at,
                  f"{number(figures.of(last, method, 'memory_bytes') / 1e6)} MB{at}"]
        yield f"| {name} | " + " | ".join(cells) + " |"


def numbers_table(figures):
    """The three figures of the README."""
    rivals = [name for name in ("R*Tree in SQL", "DuckDB cells") if figures.known(name)]
    names = {"R*Tree in SQL": "R\\*Tree in SQL", "DuckDB cells": "DuckDB, a grid by hand"}
    yield "| | foresee | " + " | ".join(names[name] for name in rivals) + " |"
    yield "|---" * (len(rivals) + 2) + "|"

    def row(what, scene, column, shown):
        ours = figures.of(scene, "foresee in SQL", column)
        theirs = [figures.of(scene, name, column) for name in rivals]
        return f"| {what} | {shown(ours)} | " + " | ".join(
            f"{shown(value)} ({number(value / ours)} times)" if shown is time else shown(value) for value in theirs) + " |"

    def per_second(seconds):
        return count(float(f"{1 / seconds:.3g}"))

    pairs = count(figures.of("ships", "foresee in SQL", "pairs"))
    yield row(f"real ships of New York Harbour, {figures.rows['ships', 'foresee in SQL']['objects']} of them: the {pairs} pairs "
              "within half a nautical mile in the next 10 minutes", "ships", "join_s", time)
    yield row(f"100,000 moving boxes: all {count(figures.of('U-100000', 'foresee in SQL', 'pairs'))} pairs that touch, with times",
              "U-100000", "join_s", time)
    yield row("position reports stored in one transaction, per second", "U-100000", "report_s", per_second)


def choosing_table(figures):
    """foresee in SQL beside the R*Tree and DuckDB at 100,000 objects."""
    rivals = [name for name in ("R*Tree in SQL", "DuckDB cells", "DuckDB range join") if figures.known(name)]
    yield "| | foresee | " + " | ".join(METHODS[name].replace(" in SQL", "") for name in rivals) + " |"
    yield "|---" * (len(rivals) + 2) + "|"
    for what, scene, column in (("join of 237 real ships", "ships", "join_s"), ("join of 1,000 boxes", "U-1000", "join_s"),
                                ("join of 100,000 boxes", "U-100000", "join_s"), ("load of 100,000 boxes", "U-100000", "build_s"),
                                ("one report of a batch", "U-100000", "report_s")):
        ours = figures.of(scene, "foresee in SQL", column)
        cells = []
        for name in rivals:
            value = figures.of(scene, name, column)
            cells.append("too long" if value is None else f"{time(value)} ({number(value / ours)})")
        yield f"| {what} | {time(ours)} | " + " | ".join(cells) + " |"


def blocks(figures, limit=60):
    return {"table": list(compare_table(figures, limit)), "numbers": list(numbers_table(figures)),
            "choosing": list(choosing_table(figures))}


def filled(text, made):
    """The page with what stands between its markers replaced."""
    return re.sub(r"<!-- compare (\w+) -->\n.*?<!-- end -->", lambda found: "\n".join(
        [f"<!-- compare {found[1]} -->", "", *made[found[1]], "", "<!-- end -->"]), text, flags=re.S)


def main():
    if "--quick" in sys.argv:
        for lines in blocks(Figures(ROOT / "build/benchmarks/compare.csv"), 10).values():
            print("\n".join(lines), "\n")
        return
    made = blocks(Figures(FOLDER / "compare.csv"))
    for page in PAGES:
        path = ROOT / page
        path.write_text(filled(path.read_text(), made))


if __name__ == "__main__":
    main()
