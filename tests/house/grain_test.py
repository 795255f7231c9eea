"""The size of files and folders of C++, headers with a single user, and includes of tests that serve no purpose.

    python3 grain_test.py                # what ctest runs
    python3 grain_test.py --list         # the private headers, with the lines of header, of its user and of both in one file

A private header is a header of ext/ that exactly one file includes, besides its own .cpp, in the same module, and no test or
benchmark. It is folded into its user where the result has at most 300 lines and one subject. Those that stay are in PRIVATE.
"""
import re
import sys
import tempfile
import unittest
from collections import defaultdict
from pathlib import Path

from house import ROOT, main
from prose import split_code_line, without_raw_pages

LIMITS = {
    "C++ files of ext/": 572,
    "private headers": 32,
    "private headers without a reason": 0,
    "files over 300 lines": 0,
    "folders over 26 files": 0,
    "includes without a use in tests": 0,
}
LONGEST_FILE = 300
FULLEST_FOLDER = 26

# The private headers that stay, each with the reason why it is not part of its user.
PRIVATE = {
    "contact/certified/endpoint_rounding.h": "the rounded ends of an interval; union_pair.h would have over 300 lines",
    "query/join/movers/leg_join.h": "the join of plans, with an interface of its own; join.cpp would have over 300 lines",
    "query/join/movers/leg_tree.h": "a tree over the legs of a slab; join_candidates.cpp needs no pages otherwise",
    "query/nearest/nearest_rows.h": "the ranking of distances, apart from the search; nearest.cpp would have over 300 lines",
    "query/window/mover_window.h": "windows over plans, apart from those over rows; window.cpp would have over 300 lines",
    "query/legs/slab_legs.h": "legs of one slab; leg_join.cpp would have over 300 lines",
    "sqlite/watch/pair_keys.h": "two shadow tables with an interface of their own; watch_rows.cpp would have over 300 lines",
    "storage/nodes/object_spill.h": "a temporary file of objects; tree_load.cpp would have over 300 lines",
    "storage/table/integrity_check.h": "the public header of integrity_check.cpp, which has 243 lines",
    "storage/table/table_contents.h": "what the layers of a table share; with table_reader.h a header of two subjects",
    "storage/table/stored_forms.h": "a cache of outlines and meshes, a participant of the journal of its own",
    "contact/boxes/box_lanes_kernel.h": "one file with its kernel has 320 lines: it settles meetings, the kernel settles ends",
    "contact/certified/certain_slope.h": "one file with closest_approach.cpp has 309 lines; a subject of its own, signs of the slope",
    "contact/mesh/containment.h": "the interface of ray tests, which compile apart from mesh_contact.cpp",
    "contact/mesh/disc_tests.h": "node tests by bounding discs, which compile apart from mesh_contact.cpp",
    "contact/mesh/space_sum.h": "the Minkowski sum of two pieces in space; mesh_contact.cpp would have over 500 lines",
    "contact/mesh/triangle_filter.h": "a stage of its own, in plain doubles and not in bounded ones",
    "contact/set/advancement.h": "with set_pair.h it would have over 400 lines",
    "sqlite/functions/function_plan.h": "planning of a call, apart from the virtual table; both in one file exceed 300 lines",
    "sqlite/names/table_lookups.h": "the cache of table look-ups has a contract of its own, apart from the connection's state",
    "sqlite/table/frame_options.h": "columns and options of a frame, apart from parsing; both in one file exceed 300 lines",
    "sqlite/table/row_write.h": "the body of xUpdate, apart from the other methods; both in one file exceed 300 lines",
    "sqlite/watch/declare_watch.h": "parsing of a watch's declaration, apart from its methods; both in one file exceed 300 lines",
    "motion/motion_set.h": "sets of vectors, which two files of changes build; with changes.h over 250 lines and two subjects",
    "query/avoid/range_bisection.h": "the interface of range_bisection.cpp; with avoid.cpp it would have over 500 lines",
    "query/avoid/proven_ranges.h": "the interface of proven_ranges.cpp; with avoid.cpp it would have over 300 lines",
    "index/gpcd_grid/lanes.h": "with grid.h it would have over 450 lines; the lanes of one stripe are a subject of their own",
    "index/gpcd_grid/scan_vectors.h": "with scan.kernel.cpp it would have over 340 lines; registers per instruction set, no algorithm",
    "index/tpr_tree/visit_cost.h": "the cost model, with tree_state.h a header of two subjects",
}

INCLUDE = re.compile(r'^#include "([^"]+)"', re.M)
SKIPPED_NAMES = {"if", "for", "while", "switch", "return", "sizeof", "alignas", "decltype", "noexcept", "static_assert", "requires",
                 "operator", "defined", "explicit", "const", "template", "typename", "class", "__attribute__", "throw", "delete", "auto"}


def cpp_files(root, folder):
    return sorted(path for path in (root / folder).rglob("*") if path.suffix in {".h", ".cpp"})


def lines_of(path):
    return path.read_text().count("\n")


def long_files(root):
    """{file: lines} of those over LONGEST_FILE."""
    return {path.relative_to(root).as_posix(): lines_of(path) for folder in ("ext", "tests") for path in cpp_files(root, folder)
            if lines_of(path) > LONGEST_FILE}


def full_folders(root):
    """{folder: files directly in it} of those over FULLEST_FOLDER."""
    count = defaultdict(int)
    for folder in ("ext", "tests"):
        for path in cpp_files(root, folder):
            count[path.parent.relative_to(root).as_posix()] += 1
    return {folder: files for folder, files in count.items() if files > FULLEST_FOLDER}


def users_of_headers(root):
    """{header of ext/, as it is included: files that include it, as paths from the root}. Examples of docs/ count too."""
    users = defaultdict(set)
    for folder in ("ext", "tests", "bench", "docs"):
        for path in (root / folder).rglob("*"):
            if path.suffix in {".h", ".cpp", ".c"}:
                for header in INCLUDE.findall(path.read_text()):
                    if (root / "ext" / header).exists():
                        users[header].add(path.relative_to(root).as_posix())
    return users


def is_own_source(header, file):
    """Whether `file` is box_lanes.cpp or box_lanes.kernel.cpp, of box_lanes.h."""
    return file.endswith(".cpp") and file.startswith("ext/" + header.removesuffix("h")) and "/" not in file[len("ext/" + header):]


def private_headers(root):
    """{header: its only user}, both as paths from ext/."""
    found = {}
    for header, users in users_of_headers(root).items():
        others = [user for user in users if not is_own_source(header, user)]
        if len(others) == 1 and others[0].startswith("ext/" + header.split("/")[0] + "/"):
            found[header] = others[0].removeprefix("ext/")
    return dict(sorted(found.items()))


def own_source(root, file):
    """Of mesh.h mesh.cpp, if there is one; of a .cpp the file itself."""
    source = Path(file).with_suffix(".cpp")
    return source.as_posix() if (root / "ext" / source).exists() else None


def merged_lines(root, header, user):
    """The lines of the longest file once the header is part of its user, and the header's own .cpp part of the user's."""
    text = (root / "ext" / header).read_text()
    frame = re.findall(r"^(?:#pragma once|#include .*|namespace .*\{|\}  // namespace.*|)\n", text, re.M)
    merged = {user: lines_of(root / "ext" / user) + text.count("\n") - len(frame) + 4}
    if source := own_source(root, header):
        target = own_source(root, user) or source
        before = merged.get(target) or (lines_of(root / "ext" / target) if target != source else 0)
        merged[target] = before + lines_of(root / "ext" / source)
    return max(merged.values())


def code_of(text):
    """The text without comments and literals."""
    lines = []
    for line in without_raw_pages(text).splitlines():
        lines.append(line if line.startswith("#") else split_code_line(line)[0])
    return "\n".join(lines)


def outside_of_bodies(code):
    """What stands in the namespaces themselves: bodies of classes, functions and enumerations become {}."""
    kept, opened = [], []
    for part in re.split(r"([{}])", re.sub(r"^#.*(?:\\\n.*)*", "", code, flags=re.M)):
        if part == "{":
            is_space = not any(kind == "body" for kind in opened) and re.search(r"namespace[\w\s:]*$|extern\s*\"\"\s*$", "".join(kept)[-80:])
            if not is_space and "body" not in opened:
                kept.append("{}")
            opened.append("space" if is_space else "body")
        elif part == "}":
            if opened:
                opened.pop()
        elif "body" not in opened:
            kept.append(part)
    return "".join(kept)


def declared_names(text):
    """The names that a header declares in its namespaces: types, functions, variables, concepts, enumerators and macros."""
    code = code_of(text)
    names = set(re.findall(r"^#define (\w+)", code, re.M))
    for body in re.findall(r"\benum\b(?! class)[^{};]*\{([^}]*)\}", code):
        names |= set(re.findall(r"(?:^|,)\s*(\w+)", body))
    flat = outside_of_bodies(code)
    names |= set(re.findall(r"\b(?:struct|class|union|enum(?: class)?|concept|using)\s+(?:\[\[.*?\]\]\s*|alignas\(.*?\)\s*)?(\w+)", flat))
    names |= set(re.findall(r"(\w+)\s*(?:<[^<>;]*>)?\(", flat))
    names |= set(re.findall(r"(\w+)(?:\[\w*\])*\s*(?:=|\{\}\s*;|;)", flat))
    return {name for name in names - SKIPPED_NAMES if not name.isdigit()}


def useless_includes(root):
    """[(file under tests/, header)]: the file has no name that the header declares, nor where it declares none, its includes."""
    declared, found = {}, []

    def names_of(header):
        if header not in declared:
            text = (root / "ext" / header).read_text()
            declared[header] = declared_names(text)
            if not declared[header]:
                declared[header] = set().union(*(names_of(other) for other in INCLUDE.findall(text) if (root / "ext" / other).exists()))
        return declared[header]

    for path in cpp_files(root, "tests"):
        text = path.read_text()
        words = set(re.findall(r"\w+", code_of(text)))
        for header in INCLUDE.findall(text):
            if (root / "ext" / header).exists() and names_of(header) and not names_of(header) & words:
                found.append((path.relative_to(root).as_posix(), header))
    return found


def list_private(root):
    for header, user in private_headers(root).items():
        merged = merged_lines(root, header, user)
        print(f"{header}: {lines_of(root / 'ext' / header)} lines, {user}: {lines_of(root / 'ext' / user)}, both: {merged}"
              f"{'' if merged <= LONGEST_FILE else ', too long'}{'; ' + PRIVATE[header] if header in PRIVATE else ''}")
    for file, header in useless_includes(root):
        print(f"{file} includes {header} and uses nothing of it")


class Grain(unittest.TestCase):
    def holds(self, what, found):
        limit = LIMITS[what]
        shown = "\n".join([str(one) for one in (found.items() if isinstance(found, dict) else found)][:100])
        self.assertLessEqual(len(found), limit, f"{what}: {len(found)}, limit {limit}\n{shown}")

    def test_files_of_ext_are_few_enough(self):
        self.holds("C++ files of ext/", cpp_files(ROOT, "ext"))

    def test_no_file_is_too_long(self):
        self.holds("files over 300 lines", long_files(ROOT))

    def test_no_folder_is_too_full(self):
        self.holds("folders over 26 files", full_folders(ROOT))

    def test_private_headers_are_few_and_have_a_reason(self):
        private = private_headers(ROOT)
        self.holds("private headers", private)
        self.holds("private headers without a reason", [header for header in private if header not in PRIVATE])
        self.assertEqual(sorted(set(PRIVATE) - set(private)), [], "listed in PRIVATE, but not private")

    def test_tests_use_what_they_include(self):
        self.holds("includes without a use in tests", useless_includes(ROOT))


class Checker(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)

    def write(self, files):
        for name, text in files.items():
            path = self.root / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)

    def test_long_files_and_full_folders(self):
        self.write({"ext/a/long.cpp": "\n" * 301, "tests/a/right.h": "\n" * 300, "ext/a/data.txt": "\n" * 400})
        self.write({f"ext/b/{i}.h": "" for i in range(27)} | {f"ext/c/{i}.h": "" for i in range(26)})
        self.assertEqual(long_files(self.root), {"ext/a/long.cpp": 301})
        self.assertEqual(full_folders(self.root), {"ext/b": 27})

    def test_a_header_with_one_user_is_private(self):
        self.write({"ext/a/x.h": "", "ext/a/x.cpp": '#include "a/x.h"\n', "ext/a/x.kernel.cpp": '#include "a/x.h"\n',
                    "ext/a/in/y.cpp": '#include "a/x.h"\n'})
        self.assertEqual(private_headers(self.root), {"a/x.h": "a/in/y.cpp"})

    def test_a_header_with_users_elsewhere_is_not_private(self):
        users = {"ext/a/z.cpp": "another file", "tests/a/x_test.cpp": "a test", "bench/x.cpp": "a benchmark"}
        for user, why in users.items():
            self.write({"ext/a/x.h": "", "ext/a/y.cpp": '#include "a/x.h"\n', user: '#include "a/x.h"\n'})
            self.assertEqual(private_headers(self.root), {}, why)
            (self.root / user).unlink()
        self.write({"ext/a/y.cpp": "", "ext/b/y.cpp": '#include "a/x.h"\n'})
        self.assertEqual(private_headers(self.root), {}, "its user is in another module")

    def test_merged_lines_leave_out_the_frame_of_the_header(self):
        self.write({"ext/a/x.h": "// X.\n#pragma once\n\n#include <a>\n\nnamespace foresee {\n\nint x;\n\n}  // namespace foresee\n",
                    "ext/a/y.cpp": "\n" * 10, "ext/a/z.h": "\n" * 20})
        self.assertEqual(merged_lines(self.root, "a/x.h", "a/y.cpp"), 10 + 2 + 4)
        self.write({"ext/a/x.cpp": "\n" * 50})
        self.assertEqual(merged_lines(self.root, "a/x.h", "a/y.cpp"), 10 + 2 + 4 + 50)
        self.assertEqual(merged_lines(self.root, "a/x.h", "a/z.h"), 50)
        self.write({"ext/a/z.cpp": "\n" * 30})
        self.assertEqual(merged_lines(self.root, "a/x.h", "a/z.h"), 80)

    def test_names_that_a_header_declares(self):
        names = declared_names("""#define LIMIT 3
            namespace foresee { // not this
            template <class T> struct Type { int member; void method(); };
            enum Kind { first, second = 3 };
            enum class Closed { hidden };
            using Alias = Type<int>;
            inline constexpr int number = 4;
            extern const double table[8];
            template <int D> double run(const Alias& argument, int other = 2) { int local = 3; return local; }
            }""")
        self.assertLessEqual({"LIMIT", "Type", "Kind", "first", "second", "Closed", "Alias", "number", "table", "run"}, names)
        self.assertEqual({"member", "method", "hidden", "local", "foresee", "not", "this"} & names, set())

    def test_an_include_without_a_use_is_found(self):
        self.write({"ext/a/x.h": "struct X {};\n", "ext/a/all.h": '#include "a/x.h"\n',
                    "tests/a/used.cpp": '#include "a/x.h"\nX x;\n', "tests/a/behind.cpp": '#include "a/all.h"\nX x;\n',
                    "tests/a/useless.cpp": '#include "a/x.h"\nint y;  // X\n'})
        self.assertEqual(useless_includes(self.root), [("tests/a/useless.cpp", "a/x.h")])


if __name__ == "__main__":
    if sys.argv[1:] == ["--list"]:
        list_private(ROOT)
    else:
        main()
