"""A new shape does not compile before it has a rule of distance (ext/contact/pair_rule.cpp)."""
import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from house import ROOT, main

COMPILER = os.environ.get("FORESEE_COMPILER", "g++")
FLAGS = ["-std=c++20", "-fsyntax-only", "-ffp-contract=off"]
ENUM = "enum class Shape : std::uint8_t {\n"


def header_of_shapes():
    found = [path for path in (ROOT / "ext/shape").glob("*.h") if ENUM in path.read_text()]
    assert len(found) == 1, found
    return found[0]


def compiled(more_shapes):
    """What the compiler says about the rule, with these shapes before the others."""
    header = header_of_shapes()
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / header.relative_to(ROOT / "ext")
        copy.parent.mkdir(parents=True)
        copy.write_text(header.read_text().replace(ENUM, ENUM + more_shapes))
        done = subprocess.run([COMPILER, *FLAGS, "-I", folder, "-I", str(ROOT / "ext"), str(ROOT / "ext/contact/pair_rule.cpp")],
                              text=True, errors="replace", capture_output=True)
    return done.returncode, done.stderr


@unittest.skipUnless(shutil.which(COMPILER), f"{COMPILER} is missing")
class PairRule(unittest.TestCase):
    def test_the_shapes_of_today_compile(self):
        self.assertEqual(compiled(""), (0, ""))

    def test_a_shape_without_a_rule_does_not(self):
        status, message = compiled("  capsule,\n")
        self.assertNotEqual(status, 0)
        self.assertIn("pair_rule.cpp", message)
        self.assertIn("capsule", message)


if __name__ == "__main__":
    main()
