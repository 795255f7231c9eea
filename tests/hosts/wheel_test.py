"""Python's wheel in a fresh venv: the examples of docs/hosts/python.md, and the message of a Python without extensions.

Wheels of other targets, around a stand-in: each has its tag and its module, and pip refuses it by name.
"""
import os
import re
import shutil
import subprocess
import tempfile
import zipfile
from pathlib import Path

from hosts import ROOT, Host, fenced_and_hidden, main, packed, run, skip, version
from stand_ins import HERE, pack, table

PYTHON = "/usr/bin/python3"


def need_venv():
    if not Path(PYTHON).exists() or subprocess.run([PYTHON, "-c", "import ensurepip"], capture_output=True).returncode != 0:
        skip("the wheel", f"there is no {PYTHON} with python3-venv")


def pip_install(python, *arguments, fails=False):
    return run(python, "-m", "pip", "install", "--no-index", "--quiet", "--disable-pip-version-check", "--no-deps", *arguments, fails=fails)


class Wheel(Host):
    @classmethod
    def setUpClass(cls):
        cls.wheel = packed("the wheel", "foresee-*.whl")
        need_venv()
        venv = Path(tempfile.mkdtemp(prefix="foresee-hosts-"))
        cls.addClassCleanup(shutil.rmtree, venv)
        cls.python = venv / "bin/python"
        run(PYTHON, "-m", "venv", venv)
        pip_install(cls.python, cls.wheel)

    def say(self, program, python=None, **environment):
        return run(python or self.python, "-c", program, folder=self.folder, **environment)

    def examples(self, kind, page="python"):
        page = fenced_and_hidden((ROOT / f"docs/hosts/{page}.md").read_text())
        return [(block.text, after.text) for block, after in zip(page, page[1:]) if block.kind == kind]

    def test_the_examples_of_the_page(self):
        found = self.examples("python")
        self.assertEqual(len(found), 3)
        for program, printed in found:
            self.assertEqual(self.say(program), printed)

    def test_the_examples_with_numpy(self):
        self.try_examples_with("numpy", "python")

    def test_the_examples_with_sqlalchemy(self):
        self.try_examples_with("sqlalchemy", "orm")

    def try_examples_with(self, package, page):
        if subprocess.run([PYTHON, "-c", f"import {package}"], capture_output=True).returncode != 0:
            skip(f"the example with {package}", f"{PYTHON} has no {package} (python3-{package})")
        site = self.say("import foresee, os; print(os.path.dirname(os.path.dirname(foresee.__file__)))").strip()
        found = self.examples(f"python {package}", page)
        self.assertEqual(len(found), 1)
        for program, printed in found:
            self.assertEqual(self.say(program, PYTHON, PYTHONPATH=site), printed)

    def test_one_version_everywhere(self):
        said = self.say("import foresee; print(foresee.__version__, foresee.connect(':memory:').execute('SELECT foresee_version()').fetchone()[0])")
        package, module = said.split()[:2]
        self.assertEqual((package, module.split("+")[0]), (version(), version()))

    def test_loading_is_off_afterwards_and_the_connection_comes_back(self):
        self.say("""import foresee, sqlite3
db = sqlite3.connect(':memory:')
assert foresee.load(db) is db
assert foresee.load(db) is db
try:
    db.load_extension(foresee.loadable_path())
except sqlite3.OperationalError as error:
    assert 'not authorized' in str(error), error
else:
    raise AssertionError('extensions may still be loaded')
assert foresee.connect(':memory:', isolation_level=None).isolation_level is None""")

    def test_an_interpreter_without_extensions_is_told_three_ways_out(self):
        said = self.say("""import foresee
class Connection: pass
try:
    foresee.load(Connection())
except RuntimeError as error:
    print(error)""")
        self.assertIn(str(self.python), said)
        for way in ("/usr/bin/python3", "pysqlite3-binary", "--enable-loadable-sqlite-extensions"):
            self.assertIn(way, said)

    def test_tiles_without_dask_find_the_module_by_themselves(self):
        self.say("import foresee\ndb = foresee.connect('ships.db')\n"
                 "db.execute('CREATE VIRTUAL TABLE ships USING moving_objects(id, x, y, vx, vy, r)')\n"
                 "db.executemany('INSERT INTO ships VALUES (?, ?, ?, ?, ?, ?)', [(1, 0, 0, 6, 0, 30), (2, 1200, 0, -6, 0, 30)])\ndb.commit()")
        for tiles in ("foresee_dask plan --table ships --horizon 300 --out pairs ships.db", "foresee_dask.tile_join pairs"):
            run(self.python, "-m", *tiles.split(), folder=self.folder)
        self.assertEqual(run(self.python, "-m", "foresee_dask", "merge", "pairs", "pairs.db", folder=self.folder), "1 rows in pairs.db\n")

    def test_the_shell_loads_it_too(self):
        path = self.say("import foresee; print(foresee.loadable_path())").strip()
        self.assertRegex(run("sqlite3", ":memory:", f".load {path}", "SELECT foresee_version()"), r"^\d")

    def test_it_serves_every_python_of_machines_that_have_its_libraries(self):
        tag = re.search(r"-py3-none-manylinux_2_(\d+)_x86_64\.whl$", self.wheel.name)
        self.assertIsNotNone(tag, self.wheel.name)
        with zipfile.ZipFile(self.wheel) as wheel:
            names = wheel.namelist()
            module = wheel.read("foresee/foresee.so")
        asked = max(int(n) for n in re.findall(rb"GLIBC_2\.(\d+)\0", module))
        self.assertGreaterEqual(int(tag.group(1)), asked)
        self.assertIn("foresee/py.typed", names)
        sources = ROOT / "ext/hosts/python/src"
        files = [str(file.relative_to(sources)) for pattern in ("*/*.py", "foresee/page/*") for file in sources.glob(pattern)]
        self.assertEqual([name for name in files if name not in names], [])
        self.assertTrue(any(name.endswith("LICENSE") for name in names), names)
        self.assertEqual([name for name in names if os.path.basename(name) in ("setup.py", "pyproject.toml")], [])


class Targets(Host):
    def wheel(self, target, **options):
        pack("wheel", target, self.folder, **options)
        return next(self.folder.glob(f"*-{table()[target]['wheel']}.whl"))

    def test_pip_refuses_the_wheel_of_another_target_by_name(self):
        need_venv()
        for target, row in table().items():
            wheel = self.wheel(target)
            self.assertEqual(wheel.name, f"foresee-{version()}-py3-none-{row['wheel']}.whl")
            with zipfile.ZipFile(wheel) as files:
                self.assertEqual([name for name in files.namelist() if re.match(r"foresee/foresee\.", name)], [f"foresee/{row['module']}"])
            installed = self.folder / f"installed-{target}"
            said = pip_install(PYTHON, "--target", installed, wheel, fails=target != HERE)
            if target != HERE:
                self.assertIn(f"{wheel.name} is not a supported wheel on this platform", said)
            self.assertEqual((installed / "foresee" / row["module"]).exists(), target == HERE)

    def test_a_module_that_does_not_suit_its_tag_is_not_packed(self):
        for target, module_of, oldest, reason in (
                ("linux-x64-gnu", None, "2_35", "needs 2.35, newer than manylinux_2_17_x86_64"),
                ("darwin-arm64", None, "14_2", "needs 14.2, newer than macosx_13_0_arm64"),
                ("linux-x64-gnu", "linux-x64-musl", None, "built for linux-x64-musl, not for linux-x64-gnu"),
                ("win32-x64", "darwin-x64", None, "built for darwin-x64, not for win32-x64")):
            self.assertIn(reason, pack("wheel", target, self.folder, module_of=module_of, oldest=oldest, fails=True))
        self.assertEqual(list(self.folder.glob("*.whl")), [])


if __name__ == "__main__":
    main()
