"""docs/reference/ and the man page: generated pages are current, every function is there with its signature, all pages have one skeleton."""
import re
import sys
import unittest

from documents import fenced_and_hidden
from house import ROOT, main, shell

sys.path.insert(0, str(ROOT / "ext/hosts/docs"))
sys.dont_write_bytecode = True
import make_reference  # noqa: E402

FUNCTION = re.compile(r"^(?:predictive|geo|foresee|plan)_|_to_geo$")
SECTIONS = ["Inputs", "Outputs", "Pitfalls", "Cost", "Errors"]
# The column `call` is the key of a call's rows, and no input (ext/sqlite/functions/table_function.h).
COLUMNS = """SELECT m.name || '(' || coalesce(group_concat(x.name, ', ') FILTER (WHERE x.hidden = 1 AND x.name <> 'call'), '') || ') → '
  || group_concat(x.name, ', ') FILTER (WHERE x.hidden = 0) FROM pragma_module_list m, pragma_table_xinfo(m.name) x
  WHERE m.name GLOB 'predictive_*' OR m.name GLOB '*geo*' OR m.name GLOB 'foresee_*'
  OR m.name GLOB 'plan_*' GROUP BY m.name;"""
SCALARS = "SELECT DISTINCT name FROM pragma_function_list WHERE name GLOB 'geo_*' OR name GLOB 'foresee_*' OR name GLOB 'plan_*';"
MODULES = """SELECT name FROM pragma_module_list WHERE name GLOB 'predictive_*' OR name GLOB '*geo*' OR name GLOB 'foresee_*'
  OR name GLOB 'plan_*';"""


def said(script):
    status, output = shell(script, "-list", "-noheader", "-cmd", ".load build/release/foresee")
    assert status == 0, output
    return output.splitlines()


class Generated(unittest.TestCase):
    maxDiff = None

    def test_generated_pages_are_current(self):
        for path, text in make_reference.generated().items():
            self.assertEqual(path.read_text(), text, "run python3 ext/hosts/docs/make_reference.py")

    def test_every_page_is_in_a_group_and_has_a_summary_of_one_line(self):
        texts = make_reference.pages()
        grouped = [name for names in make_reference.GROUPS.values() for name in names]
        self.assertEqual(sorted(grouped), sorted([*texts, "errors"]))
        for name, text in texts.items():
            self.assertRegex(text, r"\A# .+\n\n[^\n]+\n\n", name)
            self.assertLessEqual(len(make_reference.summary(text)), 120, name)


class Functions(unittest.TestCase):
    def setUp(self):
        self.pages = make_reference.pages()

    def functions(self):
        return {name: text for name, text in self.pages.items() if FUNCTION.search(name)}

    def test_every_function_has_a_page(self):
        self.assertEqual(sorted(said(MODULES) + said(SCALARS)), sorted(self.functions()))

    def test_signatures_are_those_of_the_module(self):
        rows = said(COLUMNS)
        self.assertGreater(len(rows), 12)
        for row in rows:
            name = row.partition("(")[0]
            if name != "predictive_watch":  # a table of its own: CREATE VIRTUAL TABLE declares it
                self.assertIn(row, " ".join(self.pages[name].split()))

    def test_the_man_page_has_the_signatures_of_the_module(self):
        page = (ROOT / "ext/hosts/man/foresee.3.in").read_text()
        for row in said(COLUMNS):
            signature, _, outputs = row.partition(" → ")
            entry = re.search(rf"^\.B {re.escape(signature)}\n(.*?)^\.TP", page, re.M | re.S)
            self.assertIsNotNone(entry, f"the man page has no entry {signature}")
            if not signature.startswith("predictive_watches("):
                self.assertTrue(entry.group(1).endswith(f"\n{outputs}.\n"), f"{signature} returns {outputs}")

    def test_pages_have_one_skeleton_and_start_with_an_example(self):
        for name, text in self.functions().items():
            with self.subTest(name):
                headings = re.findall(r"^## (.+)$", text, re.M)
                self.assertEqual([heading for heading in headings if heading in SECTIONS], SECTIONS)
                before = text[:text.index("\n## Inputs")]
                self.assertEqual(text.split("\n\n")[2].split("\n")[0], "```sql")
                self.assertEqual(fenced_and_hidden(before)[0].kind, "sql")

    def test_errors_are_folded(self):
        for name, text in self.pages.items():
            for start in re.finditer("<!-- sql errors -->", text):
                before = text[:start.start()]
                self.assertGreater(before.count("<details>"), before.count("</details>"), name)


class Safety(unittest.TestCase):
    def test_pages_that_avoid_or_watch_carry_the_notice(self):
        marked = re.compile(r"^[^-\n]*\b(?:predictive_avoid\(|predictive_(?:watch|changes)\()", re.M)
        for page in sorted((ROOT / "docs").rglob("*.md")):
            if any(block.kind == "sql" and marked.search(block.text) for block in fenced_and_hidden(page.read_text())):
                self.assertRegex(page.read_text(), r"\]\([./\w-]*safety\.md\)", page.relative_to(ROOT))

    def test_the_notice_says_what_voids_a_proof(self):
        page = " ".join((ROOT / "docs/explanation/safety.md").read_text().split())
        for words in ("not a navigation system", "COLREGs) apply", "Stale reports", "Wrong reports", "Motion that changes"):
            self.assertIn(words, page)


if __name__ == "__main__":
    main()
