"""A packed release: its files and sums, its modules against the table of targets, and answers by tools of their targets.

Debian 11's sqlite3 and Python load the archive and the wheel in a root of their own, arm64's by qemu. The others are queried
by tests/release/run_script.c. Files are written by each target, changed by another and checked by all.
"""
import hashlib
import itertools
import os
import shutil
import struct
import subprocess
import sys
import tarfile
import tempfile
import zipfile
from pathlib import Path

from hosts import PACKAGES, ROOT, Host, main, need_commands, skip, version

sys.path.insert(0, str(ROOT / "tests/release"))
sys.dont_write_bytecode = True
from module_format import faults, read_format  # noqa: E402
from targets import ROOTS, SCRIPTS, Failed, Native, Target, differences, table  # noqa: E402

RELEASE = PACKAGES / "release"
QUESTION = """CREATE VIRTUAL TABLE ships USING moving_objects(id, x, y, vx, vy, r, +name TEXT);
INSERT INTO ships VALUES (1, 0, 0, 6, 0, 30, 'Anna'), (2, 1200, 0, -6, 0, 30, 'Bruno'), (3, 600, -1600, 0, 8, 30, 'Clara'), (4, 600, 300, 0, 0, 30, 'Dora');
SELECT s.name, o.name, j.t, j.t_end FROM predictive_join(300) j JOIN ships s ON s.id = j.a JOIN ships o ON o.id = j.b ORDER BY j.t;
"""
ROWS = [("Anna", "Bruno", 95.0, 105.0), ("Clara", "Dora", 230.0, 245.0)]
PROGRAM = f"""import foresee
db = foresee.connect(":memory:")
db.executescript('''{QUESTION.rsplit("SELECT s", 1)[0]}''')
print(db.execute('''SELECT s{QUESTION.rsplit("SELECT s", 1)[1]}''').fetchall())
"""


def archive_of(target):
    ending = "zip" if target.startswith("win32") else "tar.gz"
    return RELEASE / f"foresee-{version()}-{target}.{ending}"


def unpack(archive, folder):
    with (tarfile.open(archive) if archive.name.endswith(".tar.gz") else zipfile.ZipFile(archive)) as files:
        files.extractall(folder)


class Release(Host):
    @classmethod
    def setUpClass(cls):
        if not (RELEASE / "SHA256SUMS").exists():
            skip("the release", f"{RELEASE} is not there: bash ext/hosts/pack.sh release packs it")
        if (RELEASE / "SHA256SUMS").stat().st_mtime < Native().module.stat().st_mtime:
            skip("the release", f"{RELEASE} is older than the build: bash ext/hosts/pack.sh release packs it")
        cls.packed = [name for name in table() if archive_of(name).exists()]

    def unpacked(self, name):
        """The module of a target's archive."""
        folder = self.folder / "unpacked"
        unpack(archive_of(name), folder)
        return folder / f"foresee-{version()}-{name}" / table()[name]["module"]

    def runnable(self):
        """The packed targets that something here runs, each with the module of its archive; the native build first."""
        found = [Native()]
        for name in self.packed:
            target = Target(name)
            if target.line["runner"] == "none":
                continue
            if target.why_not():
                skip(name, target.why_not())
            target.module = self.unpacked(name)
            found.append(target)
        return found


class Files(Release):
    def test_every_file_has_its_sum(self):
        sums = dict(reversed(line.split()) for line in (RELEASE / "SHA256SUMS").read_text().splitlines())
        files = {file.name for file in RELEASE.iterdir()} - {"SHA256SUMS"}
        self.assertEqual(set(sums), files)
        for name, expected in sums.items():
            self.assertEqual(hashlib.sha256((RELEASE / name).read_bytes()).hexdigest(), expected, name)

    def test_every_artefact_of_a_target_says_where_it_was_tested(self):
        lines = [line.split(" ", 2) for line in (RELEASE / "TESTED").read_text().splitlines()]
        tested = {name: (expected, how) for name, expected, how in lines}
        for target in self.packed:
            for name in (archive_of(target).name, f"foresee-{target}-{version()}.tgz"):
                expected, how = tested[name]
                self.assertEqual(hashlib.sha256((RELEASE / name).read_bytes()).hexdigest(), expected)
                runner = table()[target]["runner"]
                self.assertRegex(how, "^built only$" if runner == "none" else rf"^{runner}, \d{{5,}} rows$")
            self.assertTrue(any(table()[target]["wheel"] in name for name in tested), target)

    def test_an_archive_holds_one_folder_and_a_module_as_the_table_has_it(self):
        self.assertTrue(self.packed)
        for name in self.packed:
            module = self.unpacked(name)
            expected = {"README", "LICENSE", "THIRD_PARTY", module.name} | ({"UNTESTED"} if table()[name]["runner"] == "none" else set())
            self.assertEqual({file.name for file in module.parent.iterdir()}, expected)
            self.assertEqual(list(faults(Target(name), module)), [], name)
            self.assertIn("Boost Software License", (module.parent / "THIRD_PARTY").read_text())
            self.assertIn(f"foresee {version()} for {name}", (module.parent / "README").read_text())
            self.assertLess(archive_of(name).stat().st_size, 3_000_000)

    def test_no_module_holds_a_path_of_the_machine_that_built_it(self):
        for name in self.packed:
            self.assertNotIn(str(ROOT).encode(), self.unpacked(name).read_bytes(), name)

    def test_packages_of_a_target_hold_the_module_of_its_archive(self):
        for name in self.packed:
            module = self.unpacked(name)
            with tarfile.open(RELEASE / f"foresee-{name}-{version()}.tgz") as files:
                self.assertEqual(files.extractfile(f"package/{module.name}").read(), module.read_bytes())
            with zipfile.ZipFile(self.wheel_of(name)) as files:
                self.assertEqual(files.read(f"foresee/{module.name}"), module.read_bytes())

    def wheel_of(self, name):
        return next(RELEASE.glob(f"foresee-{version()}-py3-none-{table()[name]['wheel']}.whl"))


class Tools(Release):
    """sqlite3 and Python as the targets have them."""

    def check_sqlite(self, command, path):
        script = f".load {path}\n.mode list\n{QUESTION}"
        done = subprocess.run([str(word) for word in command], input=script, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        self.assertEqual((done.returncode, done.stdout.splitlines()), (0, ["|".join(map(str, row)) for row in ROWS]))

    def check_python(self, command, **environment):
        done = subprocess.run([str(word) for word in command], text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              env={**os.environ, **environment})
        self.assertEqual((done.returncode, done.stdout.strip()), (0, str(ROWS)))

    def installed(self, name, folder):
        """The wheel, as an installation lays it out."""
        with zipfile.ZipFile(next(RELEASE.glob(f"*{table()[name]['wheel']}.whl"))) as files:
            files.extractall(folder)

    def need(self, name, root):
        if name not in self.packed or not (ROOTS / root).exists():
            skip(name, "it is not packed, or its root was not fetched")
        if Target(name).why_not():
            skip(name, Target(name).why_not())

    def test_debian_11_takes_archive_and_wheel(self):
        self.need("linux-x64-gnu", "debian11")
        root = ROOTS / "debian11"
        if subprocess.run(["chroot", root, "/usr/bin/sqlite3", "-version"], capture_output=True).returncode != 0:
            skip("Debian 11", "this user may not change the root folder")
        with tempfile.TemporaryDirectory(dir=root) as folder:
            inside = "/" + Path(folder).name
            unpack(archive_of("linux-x64-gnu"), folder)
            self.installed("linux-x64-gnu", folder)
            Path(folder, "program.py").write_text(PROGRAM)
            self.check_sqlite(["chroot", root, "/usr/bin/sqlite3", ":memory:"], f"{inside}/foresee-{version()}-linux-x64-gnu/foresee")
            self.check_python(["chroot", root, "/usr/bin/python3.9", f"{inside}/program.py"], PYTHONPATH=inside)

    def test_debian_12_on_arm64_takes_archive_and_wheel(self):
        self.need("linux-arm64-gnu", "arm64")
        root, words = ROOTS / "arm64", Target("linux-arm64-gnu").runner()
        module = self.unpacked("linux-arm64-gnu")
        self.check_sqlite([*words, root / "usr/bin/sqlite3", ":memory:"], module.with_suffix(""))
        self.installed("linux-arm64-gnu", self.folder / "site")
        program = self.write("program.py", PROGRAM)
        self.check_python([*words, "-E", f"PYTHONHOME={root}/usr", "-E", f"PYTHONPATH={self.folder}/site", root / "usr/bin/python3.11", program])


class Answers(Release):
    def test_readmes_question_everywhere(self):
        script = self.write("question.sql", QUESTION)
        expected = ["|".join(value if isinstance(value, str) else struct.pack(">d", value).hex() for value in row) for row in ROWS]
        for target in self.runnable():
            self.assertEqual(target.run_script(self.folder / f"{target.folder.name}.db", script), expected, target.name)

    def test_degrees_agree_within_a_hundred_millionth(self):
        answers = [(target, target.run_script(self.folder / f"{target.folder.name}.db", SCRIPTS / "degrees.sql")) for target in self.runnable()]
        for target, rows in answers[1:]:
            self.assertEqual(len(rows), len(answers[0][1]), target.name)
            for one, other in zip(answers[0][1], rows):
                for a, b in zip(one.split("|"), other.split("|"), strict=True):
                    if len(a) == 16 and a != b:
                        a, b = (struct.unpack(">d", bytes.fromhex(digits))[0] for digits in (a, b))
                        self.assertLess(abs(a - b), 1e-8, target.name)
                    else:
                        self.assertEqual(a, b, target.name)

    def test_files_go_between_all_targets(self):
        """Each target writes a file, each other changes a copy, and both and the native build check it: one answer."""
        targets, answers = self.runnable(), {}
        for writer in targets:
            writer.run_script(self.folder / f"{writer.folder.name}.db", SCRIPTS / "rows.sql")
        for writer, changer in itertools.permutations(targets, 2):
            file = self.folder / "moved.db"
            file.write_bytes((self.folder / f"{writer.folder.name}.db").read_bytes())
            changer.run_script(file, SCRIPTS / "change.sql")
            for reader in (writer, targets[0]):
                answers[writer.folder.name, changer.folder.name, reader.folder.name] = reader.run_script(file, SCRIPTS / "check.sql")
        first, *others = answers.items()
        self.assertEqual(first[1][-1], "ok")
        self.assertEqual([line for line in first[1] if line.startswith("error")], [])
        for who, answer in others:
            self.assertIsNone(differences(first[1], answer), who)

    def test_a_program_that_fails_is_no_answer(self):
        with self.assertRaises(Failed):
            Native(module=ROOT / "build/nothing.so").run_script(self.folder / "a.db", SCRIPTS / "check.sql")


class Table(Host):
    def test_every_target_is_in_the_page_and_foreign_ones_have_a_preset(self):
        page, presets = (ROOT / "docs/hosts/archives.md").read_text(), (ROOT / "CMakePresets.json").read_text()
        for name, line in table().items():
            self.assertIn(f"`{name}`", page)
            if line["toolchain"] != "gcc":
                self.assertIn(f'{{"FORESEE_TARGET": "{name}"}}', presets)


class Roots(Host):
    def test_packages_with_other_sums_are_not_unpacked(self):
        need_commands("the roots of a release", "apt-get", "dpkg-deb", "sha256sum")
        shutil.copytree(ROOT / "ext/hosts/release", self.folder / "ext/hosts/release")
        for line in (ROOT / "ext/hosts/release/debian11.sha256").read_text().splitlines():
            self.write(f"debs/debian11/{line.split()[1]}", "another package")
        done = subprocess.run(["bash", "ext/hosts/release/fetch_roots.sh", "debian11"], cwd=self.folder, text=True, capture_output=True,
                              env={**os.environ, "FORESEE_DEBS": str(self.folder / "debs"), "FORESEE_DEBIAN_MIRROR": "http://127.0.0.1:9/none"})
        self.assertEqual(done.returncode, 75, done.stderr)
        self.assertIn("apt could not fetch the packages of debian11", done.stderr)
        self.assertFalse((self.folder / "build/roots/debian11").exists())


class MachO(Release):
    def test_macos_modules_need_the_system_alone_and_on_arm64_are_signed(self):
        names = [name for name in self.packed if name.startswith("darwin")]
        if not names:
            skip("macOS' modules", "FORESEE_UNTESTED=1 did not pack them")
        for name in names:
            found = read_format(self.unpacked(name))
            self.assertEqual(found.needed, ["/usr/lib/libSystem.B.dylib"])
            self.assertTrue(found.signed or found.machine == "x64")
            self.assertEqual(found.minimum_system, "13.0")
            self.assertEqual(found.name, "@rpath/foresee.dylib")
            self.assertIn("sqlite3_foresee_init", found.exported)


if __name__ == "__main__":
    main()
