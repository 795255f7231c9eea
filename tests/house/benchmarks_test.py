"""Every benchmark still compiles: the release build leaves them out, so what they call could change unseen. And the figures of the
README and the pages are those of docs/developers/benchmarks/compare.csv.

Only their syntax and types are looked at, which takes some two seconds a file. A file that wants the headers of a peer that
this machine lacks is passed over."""
import concurrent.futures
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from house import ROOT, main

sys.path.insert(0, str(ROOT / "bench"))
import compare_pages  # noqa: E402

FLAGS = ["-std=c++20", "-Wall", "-Wextra", "-Werror", "-Iext", "-Itests", "-Ibench", "-I."]
PEERS = re.compile(r"fatal error: '?(CGAL|spatialindex|fcl|ccd|benchmark|boost)/\S+")


# What nearly every benchmark includes. Compiled once, it saves half of the time.
COMMON = """#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <vector>
"""


def compiler(*arguments):
    return subprocess.run([os.environ["FORESEE_COMPILER"], *FLAGS, *map(str, arguments)], cwd=ROOT, text=True,
                          capture_output=True)


def complaint(source, common):
    """What the compiler says of one file; None where it says nothing, or lacks a peer's header."""
    done = compiler("-fsyntax-only", "-include", common, source)
    if done.returncode == 0 or PEERS.search(done.stderr):
        return None
    return f"{source.relative_to(ROOT)}:\n{done.stderr}"


class Benchmarks(unittest.TestCase):
    def test_every_benchmark_compiles(self):
        if "FORESEE_COMPILER" not in os.environ:
            self.skipTest("FORESEE_COMPILER names no compiler")
        sources = sorted((ROOT / "bench").rglob("*.cpp"))
        self.assertGreater(len(sources), 20)
        with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(2) as pool:
            common = Path(folder) / "common.h"
            common.write_text(COMMON)
            self.assertEqual(compiler("-x", "c++-header", common, "-o", f"{common}.gch").stderr, "")
            complaints = [said for said in pool.map(lambda source: complaint(source, common), sources) if said]
        self.assertEqual(complaints, [], "\n".join(complaints))


class Figures(unittest.TestCase):
    maxDiff = None

    def test_the_pages_have_the_figures_of_the_file(self):
        made = compare_pages.blocks(compare_pages.Figures(compare_pages.FOLDER / "compare.csv"))
        for page in compare_pages.PAGES:
            text = (ROOT / page).read_text()
            self.assertIn("<!-- compare ", text, page)
            self.assertEqual(text, compare_pages.filled(text, made), f"{page}: run python3 bench/compare_pages.py")

    def test_a_table_says_what_stopped_and_what_does_not_exist(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "compare.csv"
            path.write_text("scene,objects,method,build_s,join_s,over_s,report_s,join_after_s,memory_bytes,pairs,missed\n"
                            "ships,237,foresee grid,,6.2e-05,,,7e-05,1800000,530,0\n"
                            "ships,237,Boost R-tree,4.8e-05,2.04e-05,,1.8e-06,2.1e-05,600000,530,0\n"
                            "U-1000,1000,foresee grid,,4.9e-05,,,5.1e-05,1600000,973,0\n"
                            "U-1000,1000,brute force,,0.00226,,,0.00231,400000,973,0\n"
                            "U-1000,1000,Boost R-tree,0.00017,0.00046,,2.2e-06,0.00047,700000,973,0\n"
                            "U-10000,10000,foresee grid,,0.00056,,,0.00061,2200000,9669,0\n"
                            "U-10000,10000,brute force,,,60,,,400000,,\n")
            header, _, grid, boost, brute = compare_pages.compare_table(compare_pages.Figures(path))
        self.assertEqual(header, "| | join, 237 ships | join, 10<sup>3</sup> | join, 10<sup>4</sup> | build | report | join after reports | memory |")
        self.assertEqual(grid, "| **foresee: production grid** | 62 µs | 49 µs | 560 µs | – | – | 610 µs | 2.2 MB |")
        self.assertEqual(boost, "| Boost: R-tree | 20.4 µs | 460 µs |  | 170 µs (10<sup>3</sup>) | 2.2 µs (10<sup>3</sup>) | 470 µs (10<sup>3</sup>) | 0.7 MB (10<sup>3</sup>) |")
        self.assertEqual(brute, "| brute force | – | 2.26 ms | over 60 s | – | – | – | 0.4 MB |")

    def test_a_quick_run_is_not_called_the_published_one(self):
        figures = compare_pages.Figures(compare_pages.FOLDER / "compare.csv")
        with tempfile.TemporaryDirectory() as folder:
            shutil.copy(compare_pages.FOLDER / "compare_machine.txt", folder)
            quick = next(compare_pages.run_text(figures, Path(folder)))
        self.assertTrue(quick.startswith("This run: "), quick)
        self.assertTrue(next(compare_pages.run_text(figures, compare_pages.FOLDER)).startswith("The published run: "))

    def test_the_number_of_cores_has_its_noun(self):
        def shown(*prefix):
            return subprocess.run([*prefix, "bash", "-c", ". bench/machine.sh; shown_cores"], cwd=ROOT, text=True, capture_output=True, check=True,
                                  env={**os.environ, "OMP_NUM_THREADS": "1"}).stdout.strip()
        available = len(os.sched_getaffinity(0))
        self.assertEqual(shown(), "1 core" if available == 1 else f"{available} cores")
        self.assertEqual(shown("taskset", "-c", str(min(os.sched_getaffinity(0)))), "1 core")

    def test_three_digits_and_a_unit(self):
        self.assertEqual([compare_pages.time(value) for value in (1.234e-7, 4.9e-5, 0.00123, 0.0999, 1.5, 61.2)],
                         ["0.123 µs", "49 µs", "1.23 ms", "99.9 ms", "1.5 s", "61.2 s"])
        self.assertEqual([compare_pages.number(value) for value in (0.58, 9.97, 47.9, 9999, 123456)], ["0.58", "9.97", "47.9", "10,000", "123,000"])


if __name__ == "__main__":
    main()
