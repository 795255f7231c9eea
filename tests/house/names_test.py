"""One name, one type: all headers stand in one namespace, and two types of one name are undefined behaviour that no
compiler reports where no file includes both (it has crashed a build).

    python3 names_test.py
"""
import re
import tempfile
import unittest
from collections import defaultdict
from pathlib import Path

from house import ROOT, main

DEFINITION = re.compile(r"^(?:struct|class|union|enum(?: class)?)\s+(?:\[\[.*?\]\]\s*)?(\w+)(?:\s+final)?\s*(?::[^:].*)?\{", re.M)


def shared_names(ext):
    """{name: headers} of the types that more than one header under `ext` defines at the top level."""
    headers = defaultdict(set)
    for path in sorted(Path(ext).rglob("*.h")):
        for name in DEFINITION.findall(path.read_text()):
            headers[name].add(str(path.relative_to(ext)))
    return {name: sorted(where) for name, where in headers.items() if len(where) > 1}, len(headers)


class Names(unittest.TestCase):
    def test_every_type_of_a_header_has_a_name_of_its_own(self):
        shared, seen = shared_names(ROOT / "ext")
        self.assertEqual(shared, {})
        self.assertGreater(seen, 50)

    def test_two_types_of_one_name_are_found(self):
        with tempfile.TemporaryDirectory() as folder:
            for module, text in {"a": "struct Name {\n};\n", "b": "class Name final : public Base {\n};\nstruct Other;\n",
                               "c": "struct Other {};\n"}.items():
                (Path(folder) / f"{module}.h").write_text(text)
            self.assertEqual(shared_names(folder)[0], {"Name": ["a.h", "b.h"]})


if __name__ == "__main__":
    main()
