"""The Python examples of docs/reference/loading.md and of the tutorials, run by Debian's Python, print what the pages say.

The tutorials import foresee; a module of that name stands in for the wheel, which tests/hosts tests.
"""
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

from documents import fenced_and_hidden
from house import EXTENSION, ROOT, main, with_extension

PYTHON = "/usr/bin/python3"
STAND_IN = """
import sqlite3
def connect(path, **options):
    db = sqlite3.connect(path, **options)
    db.enable_load_extension(True)
    db.load_extension({path!r})
    return db
"""


def example(page):
    """All python blocks of a page as one program, and all that it prints."""
    blocks = fenced_and_hidden((ROOT / page).read_text())
    programs = [block.text for block in blocks if block.kind == "python"]
    printed = [after.text for block, after in zip(blocks, blocks[1:]) if block.kind == "python" and after.kind == "text"]
    return "".join(programs), "".join(printed)


def run(program, **environment):
    return subprocess.run([PYTHON, "-c", program], text=True, capture_output=True, cwd=ROOT, env={**os.environ, **environment})


class Python(unittest.TestCase):
    def setUp(self):
        if not Path(PYTHON).exists():
            self.skipTest(f"there is no {PYTHON}")
        probe = "import sqlite3; print(hasattr(sqlite3.Connection, 'enable_load_extension'))"
        if run(probe).stdout.strip() != "True":
            self.skipTest(f"{PYTHON} was built without enable_load_extension")

    def test_loads_the_extension_and_joins(self):
        program, printed = example("docs/reference/loading.md")
        done = run(with_extension(program))
        self.assertEqual((done.returncode, done.stdout), (0, printed), done.stderr)

    def test_an_error_becomes_an_exception_with_its_message(self):
        program, _ = example("docs/reference/loading.md")
        done = run(with_extension(program) + "db.execute('INSERT INTO ships(id, x, y, r) VALUES (9, 0, 0, -30)')")
        self.assertEqual(done.returncode, 1)
        self.assertIn("Error: ", done.stderr)
        self.assertIn("-30", done.stderr)

    def test_tutorials_print_what_they_say(self):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "foresee.py").write_text(STAND_IN.format(path=str(EXTENSION)))
            for page in ("docs/tutorials/drones.md", "docs/how-to/plans_from_other_tools.md"):
                program, printed = example(page)
                done = run(program, PYTHONPATH=folder)
                self.assertEqual((done.returncode, done.stdout), (0, printed), done.stderr)

    def test_the_first_drone_gives_way_after_few_lines_to_copy(self):
        first_steps = (ROOT / "docs/tutorials/drones.md").read_text().partition("\n## A loop of reports")[0]
        build = [line for line in first_steps.partition("\n## ")[0].splitlines() if line.startswith("    ")]
        programs = [line for block in fenced_and_hidden(first_steps) if block.kind == "python" for line in block.text.splitlines()]
        self.assertLessEqual(len(build + [line for line in programs if line]), 25)


if __name__ == "__main__":
    main()
