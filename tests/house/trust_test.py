"""SECURITY.md, docs/stability.md, CITATION.cff and the sources: what they say of versions, formats and files is so."""
import re
import unicodedata
import unittest

from house import ROOT, main

VERSION = re.search(r"project\(foresee VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)


def constant(path, name):
    return re.search(rf"\b{name}\s*=\s*\"?([\w]+)", (ROOT / "ext" / path).read_text()).group(1)


class Citation(unittest.TestCase):
    def setUp(self):
        self.text = (ROOT / "CITATION.cff").read_text()

    def test_required_keys_are_there(self):
        keys = re.findall(r"^([\w-]+):", self.text, re.M)
        self.assertLessEqual({"cff-version", "message", "title", "authors", "version", "license", "type"}, set(keys))
        self.assertEqual(len(keys), len(set(keys)))
        self.assertRegex(self.text, r'(?m)^authors:\n  - name: "The foresee developers"$')

    def test_version_and_licence_are_those_of_the_project(self):
        self.assertIn(f"\nversion: {VERSION}\n", self.text)
        self.assertRegex((ROOT / "CHANGELOG.md").read_text(), rf"(?m)^## {re.escape(VERSION)} - " +
                         re.search(r'date-released: "([\d-]+)"', self.text).group(1))
        self.assertIn("license: MIT\n", self.text)
        self.assertIn("MIT License", (ROOT / "LICENSE").read_text())


class Stability(unittest.TestCase):
    def setUp(self):
        self.text = (ROOT / "docs/stability.md").read_text()

    def test_the_table_names_the_formats_and_features_of_the_code(self):
        newest = [row for row in self.text.splitlines() if row.startswith("| next |")][0]
        written = set(re.findall(r"`(\w+)`", newest))
        code = "".join((ROOT / f"ext/format/features.{end}").read_text() for end in ("h", "cpp"))
        known = re.findall(r'map_blocks = "(\w+)"', code) + re.findall(r'\{"(\w+)", \[\]\(Table', code)
        self.assertEqual(written, set(known))
        cells = [cell.strip() for cell in newest.strip("|").split("|")]
        self.assertEqual(cells[1], constant("format/node_format.h", "version"))

    def test_every_released_version_has_a_row(self):
        for version in re.findall(r"(?m)^## ([\d.]+)", (ROOT / "CHANGELOG.md").read_text()):
            self.assertIn(f"| {version} |", self.text)


class Sources(unittest.TestCase):
    def test_every_file_that_is_named_exists_and_every_doi_has_a_year(self):
        text = (ROOT / "docs/explanation/sources.md").read_text()
        for path in re.findall(r"`(ext/[\w./]+)`", text):
            self.assertTrue((ROOT / path).exists(), path)
        for row in re.findall(r"(?m)^\|.*doi\.org.*", text):
            self.assertRegex(row, r"\b(19|20)\d\d\b")

    def test_sources_cited_in_headers_are_on_the_page(self):
        letters = unicodedata.normalize("NFD", (ROOT / "docs/explanation/sources.md").read_text())
        text = "".join(letter for letter in letters if not unicodedata.combining(letter))
        cited = set()
        for header in (ROOT / "ext").rglob("*.h"):
            comment = " ".join(line.lstrip("/ ") for line in header.read_text().splitlines() if line.startswith("//"))
            cited |= set(re.findall(r"\b([A-Z][a-zé]+)(?:,| and [A-Z]\w+|, [A-Z]\. [A-Z]\w+)*,? (?:et al\. )?\(?(?:19|20)\d\d\b", comment))
        for name in cited - {"AIS", "January"}:
            self.assertIn(name, text)


if __name__ == "__main__":
    main()
