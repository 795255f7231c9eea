"""The docs site of ext/hosts/docs/: it builds with --strict, holds every page and what pages link to, and asks no other host for
anything; a link that leads nowhere fails. Where mkdocs is missing the pages are laid out all the same."""
import posixpath
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from house import ROOT, main
from pages import anchors

sys.path.insert(0, str(ROOT / "ext/hosts/docs"))
sys.dont_write_bytecode = True
import moved  # noqa: E402
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
        self.assertLessEqual({"reference/predictive_join.md", "how-to/maps_and_pictures.md", "changelog.md"}, set(names))
        for name in names:
            self.assertTrue((site.pages / name).exists(), name)

    def test_links_lead_to_pages_pictures_and_copies_of_sources(self):
        index = (self.site().pages / "index.md").read_text()
        for wanted in ("(reference/index.md)", "(pictures/new_york.svg)", "(sources/sql/import_ais.sql.txt)", "(contributing.md)"):
            self.assertIn(wanted, index)
        self.assertNotIn("](docs/", index)
        join = (self.folder / "site/pages/reference/predictive_join.md").read_text()
        self.assertNotIn("sql errors", join)
        self.assertIn('<details markdown="1">', join)
        self.assertTrue((self.folder / "site/pages/sources/sql/import_ais.sql.txt").exists())

    def test_a_link_that_leads_nowhere_is_told(self):
        site = stage.Site(self.folder / "site")
        site.linked(ROOT / "README.md", "", "gone", "docs/gone.md")
        site.linked(ROOT / "docs/how-to/hulls.md", "", "out", "../../../etc/passwd")
        self.assertEqual(site.wrong, ["README.md: the link to docs/gone.md leads nowhere",
                                      "docs/how-to/hulls.md: the link to ../../../etc/passwd leads nowhere"])

    def test_old_addresses_lead_to_pages_and_headings_that_exist(self):
        site = self.site()
        pages = {name[:-3]: (site.pages / name).read_text() for name in site.names.values()}
        places = [*moved.MOVED.values(), *(place for headings in moved.ANCHORS.values() for place in headings.values())]
        for place in places:
            page, _, heading = place.partition("#")
            self.assertIn(page, pages)
            if heading:
                self.assertIn(heading, anchors(pages[page]), place)
        for old in moved.MOVED:
            self.assertNotIn(old, pages)
            self.assertIn(posixpath.relpath(moved.MOVED[old], posixpath.dirname(old) or ".") + ".html",
                          (site.pages / (old + ".html")).read_text())
        self.assertLessEqual(set(moved.ANCHORS), set(moved.MOVED))

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
