"""The man page tells every function with its inputs and outputs, as the module has them, and groff finds no fault."""
import re

from hosts import main, need_commands, run, version
from installed import Installed

COLUMNS = """SELECT m.name, group_concat(x.name, ', ') FILTER (WHERE x.hidden = 1), group_concat(x.name, ', ') FILTER (WHERE x.hidden = 0)
  FROM pragma_module_list m, pragma_table_xinfo(m.name) x WHERE m.name GLOB 'predictive_*' OR m.name GLOB 'geo_*'
  OR m.name GLOB '*_to_geo' OR m.name GLOB 'plan_*' GROUP BY 1"""


class ManPage(Installed):
    what = "the man page"
    commands = ("cmake", "sqlite3")

    def setUp(self):
        super().setUp()
        self.page = (self.prefix / "share/man/man3/foresee.3").read_text()

    def test_functions_are_as_the_module_has_them(self):
        rows = run("sqlite3", "-batch", "-separator", "|", ":memory:", f".load {self.library}/foresee", COLUMNS).splitlines()
        self.assertGreater(len(rows), 10)
        for name, inputs, outputs in (row.split("|") for row in rows):
            said = re.search(rf"^\.B {name}\(([^)]*)\)\n(.*?)^\.TP", self.page, re.M | re.S)
            self.assertIsNotNone(said, f"{name} is not on the page")
            self.assertEqual(said.group(1), inputs, name)
            if name != "predictive_watches":
                self.assertTrue(said.group(2).endswith(f"\n{outputs}.\n"), f"{name} gives {outputs}")

    def test_it_names_the_version(self):
        self.assertIn(f"foresee {version()}", self.page)

    def test_it_is_a_man_page_without_fault(self):
        need_commands("groff's look at the man page", "groff")
        self.assertEqual(run("groff", "-man", "-Tutf8", "-ww", "-z", self.prefix / "share/man/man3/foresee.3"), "")


if __name__ == "__main__":
    main()
