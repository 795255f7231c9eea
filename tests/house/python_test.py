"""The README's Python example, run by Debian's Python, prints what the README says."""
import subprocess
import unittest
from pathlib import Path

from documents import fenced_and_hidden
from house import ROOT, main, with_extension

PYTHON = "/usr/bin/python3"


def example():
    """The README's python block and the text block after it."""
    blocks = fenced_and_hidden((ROOT / "README.md").read_text())
    place = next(i for i, block in enumerate(blocks) if block.kind == "python")
    return blocks[place].text, blocks[place + 1].text


def run(program):
    return subprocess.run([PYTHON, "-c", program], text=True, capture_output=True, cwd=ROOT)


class Python(unittest.TestCase):
    def setUp(self):
        if not Path(PYTHON).exists():
            self.skipTest(f"there is no {PYTHON}")
        probe = "import sqlite3; print(hasattr(sqlite3.Connection, 'enable_load_extension'))"
        if run(probe).stdout.strip() != "True":
            self.skipTest(f"{PYTHON} was built without enable_load_extension")

    def test_loads_the_extension_and_joins(self):
        program, printed = example()
        done = run(with_extension(program))
        self.assertEqual((done.returncode, done.stdout), (0, printed), done.stderr)

    def test_an_error_becomes_an_exception_with_its_message(self):
        program, _ = example()
        done = run(with_extension(program) + "db.execute('INSERT INTO ships(id, x, y, r) VALUES (9, 0, 0, -30)')")
        self.assertEqual(done.returncode, 1)
        self.assertIn("Error: ", done.stderr)
        self.assertIn("-30", done.stderr)


if __name__ == "__main__":
    main()
