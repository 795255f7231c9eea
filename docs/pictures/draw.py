#!/usr/bin/python3
"""Draws the pictures of the pages, all from one palette (svg.py): charts from the CSV files beside them, scenes and maps from the extension.

    python3 docs/pictures/draw.py                       # all, from the root; those of the extension with build/release/foresee.so
    python3 docs/pictures/draw.py compare wrong         # these
    python3 docs/pictures/draw.py --into FOLDER compare # from the CSV files of another folder, and into it
    python3 docs/pictures/draw.py --print harbour       # to the standard output
    (build/release/bench/bench_outline_cost; build/release/bench/bench_mesh_cost) | python3 docs/pictures/draw.py --pairs    # pairs.csv

FORESEE_EXTENSION names another build. The Mississippi is drawn from ../shared/data (FORESEE_SHARED_DATA), and left alone where that
folder is not.
"""
import csv
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import accuracy  # noqa: E402
import charts  # noqa: E402
import maps  # noqa: E402
import scenes  # noqa: E402
import workloads  # noqa: E402

DOCS = Path(__file__).resolve().parents[1]
BENCHMARKS, ACCURACY, PICTURES = DOCS / "developers/benchmarks", DOCS / "explanation/accuracy", DOCS / "pictures"
# name: (folder, what draws it); a chart reads the CSV files of its folder
CHARTS = {"workloads": (BENCHMARKS, workloads.workloads), "compare": (BENCHMARKS, charts.compare), "growth": (BENCHMARKS, charts.growth), "paper_time": (BENCHMARKS, charts.paper_time),
          "paper_prune": (BENCHMARKS, charts.paper_prune), "pairs": (BENCHMARKS, charts.pairs), "wrong": (ACCURACY, accuracy.wrong),
          "stages": (ACCURACY, accuracy.stages)}
SCENES = {"new_york": maps.new_york, "mississippi": maps.mississippi, "ring": scenes.ring, "traffic": scenes.traffic,
          "harbour": scenes.harbour, "boxes_and_hulls": scenes.boxes_and_hulls}


def main(arguments):
    folder, printed = None, "--print" in arguments
    if "--pairs" in arguments:
        with (BENCHMARKS / "pairs.csv").open("w", newline="") as file:
            csv.writer(file, lineterminator="\n").writerows([("scene", "method", "ns", "errs"), *charts.pairs_of(sys.stdin)])
        return
    if "--into" in arguments:
        place = arguments.index("--into")
        folder = Path(arguments[place + 1])
        del arguments[place:place + 2]
    for name in [word for word in arguments if not word.startswith("--")] or [*CHARTS, *SCENES]:
        if name in CHARTS:
            home, draw = CHARTS[name]
            picture, home = draw(folder or home), folder or home
        else:
            picture, home = SCENES[name](), folder or PICTURES
        if picture is None:
            print(f"{name}: left as it is, its data are not there", file=sys.stderr)
        elif printed:
            sys.stdout.write(picture.written())
        else:
            (home / f"{name}.svg").write_text(picture.written())


if __name__ == "__main__":
    main(sys.argv[1:])
