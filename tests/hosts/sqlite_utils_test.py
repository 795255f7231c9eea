"""Programs that others wrote: the lines of docs/hosts/shell.md for sqlite-utils, and files of ours where foresee is not loaded."""
import sqlite3
from contextlib import closing
from pathlib import Path

from hosts import BUILD, ROOT, Host, fenced_and_hidden, main, run, skip

UTILS = Path("/usr/bin/sqlite-utils")


def example():
    """The page's lines and their output."""
    page = fenced_and_hidden((ROOT / "docs/hosts/shell.md").read_text())
    return next((block.text, after.text) for block, after in zip(page, page[1:]) if block.kind == "sh sqlite-utils")


class SqliteUtils(Host):
    def setUp(self):
        super().setUp()
        if not UTILS.exists():
            skip("sqlite-utils", "there is no sqlite-utils of Debian")
        if not (BUILD / "foresee.so").exists():
            skip("sqlite-utils", f"{BUILD} is not built")

    def say(self, lines, fails=False):
        return run("sh", "-e", "-c", lines, folder=self.folder, fails=fails, PATH="/usr/bin:/bin", LD_LIBRARY_PATH=str(BUILD.resolve()))

    def names(self):
        return self.say("sqlite-utils tables fleet.db --csv --no-headers").split()

    def test_the_lines_of_the_page(self):
        lines, printed = example()
        self.assertEqual([line for line in self.say(lines).splitlines() if line], printed.splitlines())    # insert ends with an empty line
        self.assertEqual(self.names(), ["ships", "ships_node", "ships_map", "ships_meta", "ships_aux"])
        for command in ("insert --replace", "upsert --pk id"):
            self.say(f"sqlite-utils {command} fleet.db ships ships.csv --csv --load-extension foresee")
        self.assertEqual(self.say("sqlite-utils query fleet.db 'SELECT count(*) FROM ships' --load-extension foresee --csv --no-headers"), "2\n")
        self.say("sqlite-utils schema fleet.db\nsqlite-utils vacuum fleet.db")
        self.assertIn("no such module: moving_objects", self.say("sqlite-utils query fleet.db 'SELECT * FROM ships'", fails=True))

    def test_detecting_types_makes_an_ordinary_table(self):
        lines, _ = example()
        create, insert, _ = lines.split("sqlite-utils ")[1:]
        csv = lines.split("sqlite-utils ")[0]
        self.say(f"{csv}sqlite-utils {create}sqlite-utils {insert.strip()} --detect-types")
        self.assertEqual(self.names(), ["ships"])


class WithoutForesee(Host):
    """What docs/faq.md says of programs that open such a file and have not loaded foresee."""

    def test_what_works_and_what_does_not(self):
        path = self.folder / "fleet.db"
        with closing(sqlite3.connect(path, isolation_level=None)) as db:
            if not hasattr(db, "enable_load_extension") or not (BUILD / "foresee.so").exists():
                skip("files without foresee", "this Python loads no extensions, or nothing is built")
            db.enable_load_extension(True)
            db.load_extension(str(BUILD / "foresee"))
            db.execute("CREATE VIRTUAL TABLE ships USING moving_objects(id, x, y)")
            db.execute("INSERT INTO ships VALUES (1, 0, 0)")
            db.execute("CREATE TABLE ports(name)")
            db.execute(f"ATTACH '{self.folder}/copy.db' AS other")
            db.execute("CREATE TABLE other.ships AS SELECT * FROM ships")
        with closing(sqlite3.connect(path, isolation_level=None)) as db:
            db.execute("VACUUM")
            self.assertEqual(db.execute("PRAGMA integrity_check").fetchall(), [("ok",)])
            self.assertEqual(db.execute("PRAGMA table_info(ports)").fetchall()[0][1], "name")
            for refused in ("SELECT * FROM ships", "PRAGMA table_info(ships)", "DROP TABLE ships"):
                with self.assertRaisesRegex(sqlite3.Error, "no such module: moving_objects", msg=refused):
                    db.execute(refused)
        with closing(sqlite3.connect(self.folder / "copy.db")) as db:
            self.assertEqual(db.execute("SELECT * FROM ships").fetchall(), [(1, 0.0, 0.0)])


if __name__ == "__main__":
    main()
