"""The picture of docs/avoidance.md is what its script draws."""
import os
import subprocess
import unittest
from pathlib import Path

from house import EXTENSION, ROOT, main

PYTHON = "/usr/bin/python3"
PICTURE = ROOT / "docs/avoidance/traffic"


class Picture(unittest.TestCase):
    maxDiff = None

    def test_the_picture_is_what_the_script_draws(self):
        probe = "import sqlite3; sqlite3.Connection.enable_load_extension"
        if not Path(PYTHON).exists() or subprocess.run([PYTHON, "-c", probe], capture_output=True).returncode:
            self.skipTest(f"there is no {PYTHON} with enable_load_extension")
        done = subprocess.run([PYTHON, PICTURE.with_suffix(".py")], text=True, capture_output=True, cwd=ROOT,
                              env={**os.environ, "FORESEE_EXTENSION": str(EXTENSION)})
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout, PICTURE.with_suffix(".svg").read_text())


if __name__ == "__main__":
    main()
