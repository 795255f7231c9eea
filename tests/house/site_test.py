"""The docs site of ext/hosts/docs/: it builds with --strict, holds every page and what pages link to, and asks no other host for
anything; a link that leads nowhere fails. Where mkdocs is missing the pages are laid out all the same."""
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from house import ROOT, main

sys.path.insert(0, str(ROOT / "ext/hosts/docs"))
sys.dont_write_bytecode = True
import stage  # noqa: E402

THEME = Path("/usr/share/mkdocs/themes/material")
REQUEST = re.compile(r'<(?:script|img|iframe|source)[^>]*\ssrc="(?:https?:)?//|<link[^>]*\shref="(?:https?:)?//')


class Staged(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def site(self):
        site = stage.Site(self.folder / "site")
        site.write()
        return site

    def test_every_page_is_there_and_in_the_navigation_once(self):
        site = self.site()
        names = [name for entry in site.nav() for names in entry.values() for name in names]
        self.assertEqual(sorted(names), sorted(set(site.names.values())))
        self.assertEqual(names[0], "index.md")
        self.assertLessEqual({"sql_reference.md", "pictures.md", "changelog.md"}, set(names))
        for name in names:
            self.assertTrue((site.pages / name).exists(), name)

    def test_links_lead_to_pages_pictures_and_copies_of_sources(self):
        index = (self.site().pages / "index.md").read_text()
        for wanted in ("(sql_reference.md)", "(pictures/harbour.svg)", "(sources/sql/import_ais.sql.txt)", "(contributing.md)"):
            self.assertIn(wanted, index)
        self.assertNotIn("](docs/", index)
        self.assertNotIn("```sql error", (self.folder / "site/pages/sql_reference.md").read_text())
        self.assertTrue((self.folder / "site/pages/sources/sql/import_ais.sql.txt").exists())

    def test_a_link_that_leads_nowhere_is_told(self):
        site = stage.Site(self.folder / "site")
        site.linked(ROOT / "README.md", "", "gone", "docs/gone.md")
        site.linked(ROOT / "docs/shapes.md", "", "out", "../../etc/passwd")
        self.assertEqual(site.wrong, ["README.md: the link to docs/gone.md leads nowhere",
                                      "docs/shapes.md: the link to ../../etc/passwd leads nowhere"])

    def test_it_builds_and_asks_no_other_host(self):
        if not shutil.which("mkdocs") or not THEME.exists():
            why = "mkdocs and its material theme are not installed (Debian: mkdocs-material)"
            print(f"SKIPPED: the docs site, because {why}", flush=True)
            self.skipTest(why)
        done = subprocess.run(["bash", ROOT / "ext/hosts/docs/build.sh", self.folder / "built"], text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        self.assertEqual(done.returncode, 0, done.stdout)
        pages = list((self.folder / "built").rglob("*.html"))
        self.assertGreater(len(pages), 15)
        for page in pages:
            self.assertIsNone(REQUEST.search(page.read_text()), page.name)
        self.assertIn("predictive_track", (self.folder / "built/search/search_index.json").read_text())


if __name__ == "__main__":
    main()
