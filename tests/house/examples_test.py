"""The examples of header comments compile: all of ext/ in one source, of which only syntax and types are checked (5 s).

    python3 examples_test.py            # with FORESEE_COMPILER, else g++

What an example uses and does not declare is in examples_given.py. Prefer examples that need nothing from there.
"""
import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from examples import blocks_of, examples_of, is_drawing, sources, statements
from examples_given import DRAWINGS, GIVEN
from house import ROOT, main

COMPILER = os.environ.get("FORESEE_COMPILER", "g++")
FLAGS = ["-std=c++20", "-fsyntax-only", "-Werror=narrowing", "-ffp-contract=off"]


def errors_of(root):
    """(what the compiler reports of the examples under `root`/ext, how many headers have one)."""
    text, count = sources(root)
    with tempfile.TemporaryDirectory() as folder:
        source = Path(folder) / "examples.cpp"
        source.write_text(text)
        done = subprocess.run([COMPILER, *FLAGS, "-I", str(root / "ext"), str(source)], text=True, errors="replace",
                              capture_output=True, cwd=root)
    return "" if done.returncode == 0 else done.stderr, count


@unittest.skipUnless(shutil.which(COMPILER), f"{COMPILER} is missing")
class Examples(unittest.TestCase):
    def test_every_example_of_a_header_compiles(self):
        errors, count = errors_of(ROOT)
        print(f"{count} headers have an example")
        self.assertEqual(errors, "", "\n" + errors[:20000])
        self.assertGreater(count, 100)

    def test_tables_have_nothing_that_no_example_needs(self):
        headers = {path.name: path.read_text() for path in (ROOT / "ext").rglob("*.h")}
        self.assertEqual(sorted(name for name in {**DRAWINGS, **GIVEN} if name not in headers), [])
        unused = [(name, given) for name in GIVEN for given in GIVEN[name]
                  if not re.search(rf"\b{given}\b", str(examples_of(name, headers[name])))]
        unused += [(name, opening) for name in DRAWINGS for opening in DRAWINGS[name]
                   if not any(is_drawing(name, lines, opening) for _, lines in blocks_of(headers[name]))]
        self.assertEqual(unused, [])

    def test_an_example_that_does_not_compile_is_found_at_its_line(self):
        for call, right in {"twice(4) == 8": True, "twice(4, 2) == 8": False, "twise(4) == 8": False}.items():
            with tempfile.TemporaryDirectory() as folder:
                header = Path(folder) / "ext/a/a.h"
                header.parent.mkdir(parents=True)
                header.write_text(f"// Doubles a number.\n//\n//   int a = twice(3);\n//   {call}          // 8\n//\n// Cost: one sum.\n"
                                  "#pragma once\n\nnamespace foresee {\n\nint twice(int);\n\n}\n")
                errors, count = errors_of(Path(folder))
                self.assertEqual((errors == "", count), (right, 1), errors)
                self.assertTrue(right or "ext/a/a.h:4:" in errors, errors)


class Statements(unittest.TestCase):
    def test_a_line_without_a_semicolon_is_an_expression(self):
        self.assertEqual(statements(["   a == 1   // one", "   b = 2;", "   c"]), ["a == 1;", "b = 2;", "c;"])

    def test_four_spaces_part_expressions(self):
        self.assertEqual(statements(["   f(1) == 2    f(2) == 4"]), ["f(1) == 2; f(2) == 4;"])

    def test_a_statement_goes_on_in_brackets_and_in_deeper_lines(self):
        self.assertEqual(statements(["   f(a,", "     b)"]), ["f(a,", "     b);"])
        self.assertEqual(statements(["   for (auto a : f(1,", "                   2))", "     use(a);"]),
                         ["for (auto a : f(1,", "                   2))", "use(a);"])

    def test_what_a_reader_fills_in(self):
        self.assertEqual(statements(["   A a = …;", "   if (a) …", "   f([] { …; return 1; });", "   …"]),
                         ["A a = Anything{};", "if (a) ;", "f([] {  return 1; });", ";"])

    def test_a_string_may_hold_a_comment(self):
        self.assertEqual(statements(['   f("a // b");    // c']), ['f("a // b");'])


if __name__ == "__main__":
    main()
