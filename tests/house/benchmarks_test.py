"""Every benchmark still compiles: the release build leaves them out, so what they call could change unseen.

Only their syntax and types are looked at, which takes a second a file. A file that wants the headers of a peer that
this machine lacks is passed over."""
import concurrent.futures
import os
import re
import subprocess
import unittest

from house import ROOT, main

FLAGS = ["-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", "-Werror", "-Iext", "-Itests", "-Ibench", "-I.",
         "-isystem", "/usr/include/eigen3"]
PEERS = re.compile(r"fatal error: '?(CGAL|spatialindex|fcl|ccd|benchmark|boost)/\S+")


def complaint(source):
    """What the compiler says of one file; None where it says nothing, or lacks a peer's header."""
    done = subprocess.run([os.environ["FORESEE_COMPILER"], *FLAGS, str(source)], cwd=ROOT, text=True,
                          capture_output=True)
    if done.returncode == 0 or PEERS.search(done.stderr):
        return None
    return f"{source.relative_to(ROOT)}:\n{done.stderr}"


class Benchmarks(unittest.TestCase):
    def test_every_benchmark_compiles(self):
        if "FORESEE_COMPILER" not in os.environ:
            self.skipTest("FORESEE_COMPILER names no compiler")
        sources = sorted((ROOT / "bench").rglob("*.cpp"))
        self.assertGreater(len(sources), 20)
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            complaints = [said for said in pool.map(complaint, sources) if said]
        self.assertEqual(complaints, [], "\n".join(complaints))


if __name__ == "__main__":
    main()
