"""Every SQL example in README.md and docs/ runs and prints what the page says (documents.py says how)."""
import unittest

from documents import run_document
from house import ROOT, main


class Documents(unittest.TestCase):
    def test_every_example_does_what_the_page_says(self):
        pages = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md")), ROOT / "docs/hosts/shell.md"]
        blocks = 0
        for page in pages:
            found, count = run_document(page.read_text(), page.name)
            blocks += count
            with self.subTest(page.name):
                self.assertEqual(found, [], "\n" + "\n".join(found))
        self.assertGreater(blocks, 20)


if __name__ == "__main__":
    main()
