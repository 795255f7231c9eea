"""Pages keep up with the sources: every path and link leads somewhere, also those in comments, and the lists of
docs/developers/recipes.md are the true ones (pages.py says how). And the check itself, tried on made-up pages.

    python3 recipes_test.py
"""
import tempfile
import unittest
from pathlib import Path

import pages
from house import ROOT, main


class Pages(unittest.TestCase):
    def test_every_path_and_link_leads_somewhere(self):
        files = pages.files_of(ROOT)
        hosts = ROOT / "docs/hosts"  # these pages speak of their readers' files; the site's build checks their links
        known = [page for page in sorted((ROOT / "docs").rglob("*.md")) if hosts not in page.parents]
        known += [*ROOT.glob("*.md"), *(ROOT / "bench").glob("*.md")]
        self.assertGreater(len(known), 8)
        for page in known:
            with self.subTest(page.name):
                found = pages.complaints_about_page(page, files)
                self.assertEqual(found, [], "\n" + "\n".join(found))

    def test_comments_and_scripts_send_nobody_nowhere(self):
        files = pages.files_of(ROOT)
        sources = [path for folder in pages.FOLDERS for path in (ROOT / folder).rglob("*") if path.suffix in pages.SOURCES]
        self.assertGreater(len(sources), 300)
        found = [line for path in sources for line in pages.complaints_about_source(path, ROOT, files)]
        self.assertEqual(found, [], "\n" + "\n".join(found))


class Recipes(unittest.TestCase):
    def test_every_list_of_files_is_the_true_one(self):
        found, lists = pages.complaints_about_lists(ROOT / "docs/developers/recipes.md", ROOT)
        self.assertEqual(found, [], "\n" + "\n".join(found))
        self.assertEqual(lists, 5)


class Check(unittest.TestCase):
    """On a tree of its own: ext/shape/ball.h names Shape::, ext/shape/point.h only in a comment."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        for name in pages.FOLDERS:
            (self.root / name).mkdir()
        (self.root / "ext/shape").mkdir()
        (self.root / "ext/shape/ball.h").write_text("use(Shape::ball);\n")
        (self.root / "ext/shape/point.h").write_text("// not Shape::point\n")

    def page(self, text):
        page = self.root / "docs/page.md"
        page.write_text(text)
        return page

    def complaints(self, text):
        return pages.complaints_about_page(self.page(text), pages.files_of(self.root))

    def test_paths_from_any_folder_on_the_way_are_found(self):
        self.assertEqual(self.complaints("See `ext/shape/ball.h`, shape/ball.h, `ball.h`, `shape/*.h` and `ext/shape/`."), [])

    def test_paths_and_folders_that_lead_nowhere_are_told(self):
        self.assertEqual(self.complaints("Words.\nSee `motion/ball.h`."), ["page.md:2: motion/ball.h is nowhere; there is ext/shape/ball.h"])
        self.assertEqual(self.complaints("```\n a drawing   ball.cpp\n```"), ["page.md:2: ball.cpp is nowhere"])
        (self.root / "ext/motion").mkdir()  # empty: git leaves it behind when its files move, a fresh clone has none
        self.assertEqual(self.complaints("See `ext/motion/`."), ["page.md:1: ext/motion/ is nowhere"])

    def test_examples_addresses_and_what_is_built_are_left_alone(self):
        self.assertEqual(self.complaints("```sql\nSELECT a.c FROM a;\n```\nhttps://example.org/x.md `build/x.csv` `<shape>.h`"), [])

    def test_links_lead_to_files_and_headings(self):
        self.assertEqual(self.complaints("# One: two\n[a](#one-two) [b](page.md) [c](../ext/shape/ball.h)"), [])
        self.assertEqual(self.complaints("# One\n[a](#two)"), ["page.md:2: the page has no heading #two"])
        self.assertEqual(self.complaints("[a](other.html)"), ["page.md:1: the link to other.html leads nowhere"])

    def test_a_comment_that_leads_nowhere_is_told(self):
        self.page("# One\n")
        source = self.root / "ext/shape/box.h"
        source.write_text("// docs/page.md#one, ball.h\n// docs/page.md#two, DESIGN.md\nuse(\"other.csv\");\n")
        self.assertEqual(pages.complaints_about_source(source, self.root, pages.files_of(self.root)),
                         ["ext/shape/box.h:2: DESIGN.md is nowhere", "ext/shape/box.h:2: docs/page.md has no heading #two"])

    def test_a_script_is_asked_for_paths_from_the_root(self):
        script = self.root / "tests/run.sh"
        script.write_text("cat out/x.csv ext/shape/ball.h ext/motion/ball.h\n")
        self.assertEqual(pages.complaints_about_source(script, self.root, pages.files_of(self.root)),
                         ["tests/run.sh:1: ext/motion/ball.h is nowhere; there is ext/shape/ball.h"])

    def test_a_list_must_be_the_true_one(self):
        def lists(*rows):
            table = "\n".join(f"| `{row}` | why |" for row in rows)
            return pages.complaints_about_lists(self.page(f"<!-- files that name Shape:: -->\n\n| file | |\n|---|---|\n{table}\n"), self.root)
        self.assertEqual(lists("ext/shape/ball.h"), ([], 1))
        self.assertEqual(lists("ext/shape/ball.h", "ext/shape/point.h"),
                         (["page.md: ext/shape/point.h is in the list, but does not name Shape::"], 1))
        self.assertEqual(lists("ext/shape/box.h")[0], ["page.md: ext/shape/ball.h names Shape:: and is not in the list",
                                                        "page.md: ext/shape/box.h is in the list, but does not name Shape::"])


if __name__ == "__main__":
    main()
