"""Every SQL example in README.md and docs/ runs and prints what the page says (documents.py says how)."""
import unittest

from documents import error_rows, run_document
from house import ROOT, main


class Documents(unittest.TestCase):
    def test_every_example_does_what_the_page_says(self):
        hosts = ROOT / "docs/hosts"  # run by the tests of tests/hosts, but for the shell's
        pages = [page for page in sorted((ROOT / "docs").rglob("*.md")) if hosts not in page.parents or page.stem == "shell"]
        pages.append(ROOT / "README.md")
        blocks = errors = 0
        for page in pages:
            found, count = run_document(page.read_text(), page.relative_to(ROOT))
            blocks += count
            errors += len(error_rows(page.read_text()))
            with self.subTest(str(page.relative_to(ROOT))):
                self.assertEqual(found, [], "\n" + "\n".join(found))
        self.assertGreater(blocks, 400)
        self.assertGreater(errors, 250)


if __name__ == "__main__":
    main()
