"""docs/how-to/tiles_on_dask.md and the loop of docs/how-to/many_files.md do what they say, and sql/scale_demo.sh finds no row that differs."""
import os
import re
import subprocess
import sys

from fleet import EXTENSION, PACKAGE, Fleet, main, skip
from hosts import ROOT, fenced_and_hidden, need_commands

PAGE = (ROOT / "docs/how-to/tiles_on_dask.md").read_text()


def need_dask(what):
    try:
        import distributed  # noqa: F401
    except ImportError:
        skip(what, f"{sys.executable} has no distributed (python3-distributed)")


class Pages(Fleet):
    def setUp(self):
        super().setUp()
        need_commands("the pages about tiles", "sqlite3", "xargs")
        (self.folder / "ext").symlink_to(ROOT / "ext")
        (self.folder / "build/release").mkdir(parents=True)
        (self.folder / "build/release/foresee.so").symlink_to(EXTENSION)

    def said_by(self, *command):
        done = subprocess.run(command, cwd=self.folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=120,
                              env={**os.environ, "PYTHONPATH": "ext/hosts/python/src", "PYTHONDONTWRITEBYTECODE": "1"})
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_what_the_page_of_dask_shows(self):
        need_dask("the page of tiles on Dask")
        blocks = fenced_and_hidden(PAGE)
        programs = 0
        for block, after in zip(blocks, [*blocks[1:], None]):
            if block.kind not in ("bash", "python"):
                continue
            (self.folder / "program").write_text(block.text)
            said = self.said_by(*(("bash", "-e") if block.kind == "bash" else ("/usr/bin/python3",)), "program")
            self.assertEqual(said, after.text if after and after.kind == "text" else "", f"line {block.line}")
            programs += 1
        self.assertEqual(programs, 4)

    def test_the_errors_of_the_page_are_those_of_the_package(self):
        sources = " ".join(file.read_text() for file in (PACKAGE / "foresee_dask").glob("*.py"))
        said = re.findall(r"^\| `(.*)` \| ", PAGE.split("## Errors")[1].split("\n## ")[0], re.M)
        self.assertGreater(len(said), 10)
        for message in said:
            for words in message.split("…"):
                self.assertIn(words.strip(), sources, message)

    def test_the_options_of_the_page_are_those_of_the_command(self):
        told = self.command("join", "--help").stdout
        for option in re.findall(r"--[a-z-]+", " ".join(re.findall(r"^\| `(--.*?)` \|", PAGE, re.M))):
            self.assertIn(option + " ", told)

    def test_the_loop_of_scale(self):
        page = fenced_and_hidden((ROOT / "docs/how-to/many_files.md").read_text())
        table = next(block.text for block in page if block.kind == "sql").split(";\n\n")[0]
        self.said_by("sqlite3", "ships.db", ".load build/release/foresee", table)
        loop = [block.text for block in page if block.kind == "bash"]
        self.assertEqual(len(loop), 1)
        self.assertEqual(self.said_by("bash", "-e", "-c", loop[0]), "1|2|95.0\n3|4|230.0\n")


class Demo(Fleet):
    def test_a_small_fleet(self):
        need_commands("the demo of tiles", "sqlite3", "pgrep")
        need_dask("the demo of tiles")
        done = subprocess.run(["bash", ROOT / "sql/scale_demo.sh", "50000"], text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              env={**os.environ, "FORESEE_EXTENSION": str(EXTENSION), "TMPDIR": str(self.folder)}, timeout=300)
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertRegex(done.stdout, r"killed worker \d+ when \d+ tiles were done")
        self.assertIn("rows that differ from the single join: 0\n", done.stdout)
        self.assertNotIn("Traceback", done.stdout)
        self.assertEqual(list(self.folder.iterdir()), [])


if __name__ == "__main__":
    main()
