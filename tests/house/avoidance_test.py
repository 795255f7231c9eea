"""The programs of docs/examples make traffic and robots keep clear, as the pages say."""
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

from house import EXTENSION, ROOT, main, shell

PYTHON = "/usr/bin/python3"


class WithPython(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        probe = "import sqlite3; sqlite3.Connection.enable_load_extension"
        if not Path(PYTHON).exists() or subprocess.run([PYTHON, "-c", probe], capture_output=True).returncode:
            self.skipTest(f"there is no {PYTHON} with enable_load_extension")


class Program(WithPython):
    def advise(self, ships):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "ships.csv"
            path.write_text("id,t,x,y,vx,vy\n" + "".join(",".join(map(str, ship)) + "\n" for ship in ships))
            done = subprocess.run([PYTHON, ROOT / "docs/examples/advise_ships.py", path, "--extension", EXTENSION], text=True,
                                  capture_output=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout.splitlines()

    def test_ships_that_would_meet_keep_clear(self):
        said = self.advise([(1, 0, 0, 0, 0, 10), (2, 0, 0, 4000, 0, -10), (3, 0, 9000, 0, 0, 5), (4, 0, 9000, 2000, 0, 1)])
        self.assertEqual(said[0], "2 encounters of 4 ships before, 0 after, 0 of them new")
        self.assertTrue(said[1].startswith("2 ships changed, 2 of them their course"), said[1])
        self.assertTrue(said[1].endswith("; 0 have no clear change"), said[1])

    def test_the_bundled_ships_keep_clear_as_the_page_says(self):
        feed, clear = ((ROOT / "docs/how-to" / name).read_text() for name in ("follow_a_watch.md", "clear_traffic.md"))
        script = re.search(r"sqlite3 <<'END'\n(.+?)    END\n", feed, re.DOTALL).group(1)
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "ships.csv"
            status, printed = shell(script.replace("    ", "").replace("build/ships.csv", str(path)))
            self.assertEqual((status, printed), (0, ""))
            done = subprocess.run([PYTHON, ROOT / "docs/examples/advise_ships.py", path, "--extension", EXTENSION], text=True,
                                  capture_output=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("".join(f"    {line}\n" for line in done.stdout.splitlines()[:2]), clear)

    def test_without_an_encounter_nothing_is_queried(self):
        said = self.advise([(1, 0, 0, 0, 0, 10)])
        self.assertEqual(said, ["0 encounters of 0 ships before, 0 after, 0 of them new",
                                "0 ships changed, 0 of them their course; 0 have no clear change"])


class Warehouse(WithPython):
    def test_no_conflict_is_left_as_the_page_says(self):
        done = subprocess.run([PYTHON, ROOT / "docs/examples/warehouse.py", "--extension", EXTENSION], text=True,
                              capture_output=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        page = (ROOT / "docs/how-to/movers_with_plans.md").read_text()
        for line in done.stdout.splitlines()[3:]:
            self.assertIn("    " + line.split(";")[0] + "\n", page)


if __name__ == "__main__":
    main()
