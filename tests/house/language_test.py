"""Plain technical English: comments, messages, names and pages without the words of dialect.py, sentences and lines not too long.

    python3 language_test.py                              # what ctest runs: the paths of ENFORCED and ENFORCED_NAMES are clean
    python3 language_test.py --list ext/query docs/developers/recipes.md    # all findings in these paths, then counts per module; status 1 if any
    python3 language_test.py ext/query                    # the counts alone
    python3 language_test.py --prose ext/query            # --prose: leave out identifiers and file names

A finding is `file:line: "word": write "…"`. Not read: code, also in backticks and in examples; quotations; SQL. Messages that a test
compares are quotations of ext/, where they are read; of a test's own messages those after << are read.
"""
import re
import sys
import tempfile
import unittest
from collections import Counter
from pathlib import Path

from dialect import HEADINGS, LEGITIMATE_NAMES, NAMES, STORED_COLUMNS, WORDS
from house import ROOT, main
from prose import CPP, prose_of, split_code_line, without_raw_pages

# Paths that must be clean: prose, and the names of identifiers and files. A folder ends with a slash; of docs/ its pages are read.
ENFORCED = ("ext/", "tests/", "bench/", "docs/", "README.md", "CONTRIBUTING.md", "SECURITY.md", "CHANGELOG.md", "bench/README.md",
            "sql/data/README.md", "ext/hosts/man/foresee.3.in")
ENFORCED_NAMES = ("ext/", "tests/", "bench/")
PAGES = ("README.md", "CONTRIBUTING.md", "SECURITY.md", "CHANGELOG.md", "bench/README.md")
GROUPS = ("ext", "tests", "bench", "docs")  # read with --list and no paths
# Words that entries of one version share.
SHARED = ("older versions refuse such a table by name", "a table whose objects were all updated")

LONGEST_SENTENCE = 30  # words; 25 is the aim
LONGEST_LINE = 120
DOUBLED = 7  # words in a row that stand twice in one version of the CHANGELOG


class Finding:
    def __init__(self, file, line, word, write, of_a_name=False):
        self.file, self.line, self.word, self.write, self.of_a_name = file, line, word, write, of_a_name

    def __str__(self):
        return f'{self.file}:{self.line}: "{self.word}": write "{self.write}"'


def sentences(piece):
    """(offset, sentence) of each; those of a table end at its |."""
    start = 0
    end_of_one = r"\|" if piece.kind == "table" else r"(?<!e\.g)(?<!i\.e)(?<! v)(?<!\b[A-Z])[.?!…][)*]*(?=\s|$)"
    for end in [*(m.end() for m in re.finditer(end_of_one, piece.text)), len(piece.text)]:
        if piece.text[start:end].strip():
            yield start + len(piece.text[start:end]) - len(piece.text[start:end].lstrip()), piece.text[start:end]
        start = end


def words_in(sentence):
    """How many; formulas count as nothing, nor do sources in brackets, (Yu and Wu, 1999)."""
    without_sources = re.sub(r"\([^()]*\b(?:19|20)\d\d\b[^()]*\)", "", re.sub("¤+", "code", sentence))
    return len(re.findall(r"\b[^\W\d_]{2}[\w'-]*|\ba\b(?= [a-z]{2})", without_sources))


def findings_in_prose(name, pieces):
    found = []
    for piece in pieces:
        if piece.kind == "heading" and (denied := [write for pattern, write in HEADINGS if pattern.search(piece.text)]):
            found.append(Finding(name, piece.first_line, piece.text, denied[0]))
            continue
        for pattern, write in WORDS:
            for hit in pattern.finditer(piece.text):
                if not hit.group().isupper():  # SQL's BEGIN
                    found.append(Finding(name, piece.line_at(hit.start()), hit.group(), write))
        for start, sentence in sentences(piece):
            if (count := words_in(sentence)) > LONGEST_SENTENCE:
                opening = " ".join(sentence.split()[:4])
                found.append(Finding(name, piece.line_at(start), f"{opening} …", f"shorter sentences, not one of {count} words"))
    return found


def snake(identifier):
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", identifier).lower().strip("_")


def findings_in_name(name, line, identifier):
    words = snake(identifier)
    if LEGITIMATE_NAMES.match(words):
        return []
    if "/watch/" in name and STORED_COLUMNS.search(words):
        return []
    return [Finding(name, line, identifier, write, of_a_name=True) for pattern, write in NAMES if pattern.search(words)]


def findings_in_names(name, text):
    """Of the path and of the identifiers in the code, each at its first place."""
    found = [Finding(name, 1, part, f.write, of_a_name=True) for part in name.split("/")[1:]
             for f in findings_in_name(name, 1, part.split(".")[0] if "." in part else part)]
    found += [Finding(name, 1, "growing", "clearance", of_a_name=True)] if "/growing/" in name else []
    seen = set()
    for number, line in enumerate(without_raw_pages(text).splitlines(), 1):
        for identifier in re.findall(r"[A-Za-z_]\w*", split_code_line(line)[0] if not line.startswith("#") else ""):
            if identifier not in seen:
                seen.add(identifier)
                found += findings_in_name(name, number, identifier)
    return found


def findings_in_lines(name, text):
    is_page, fence, found = Path(name).suffix == ".md", False, []
    is_of_names = re.compile(r"[\w, ]+[.]|\.B .*") if name.endswith(".3.in") else None      # a list of columns, a signature
    for number, line in enumerate(text.splitlines(), 1):
        if is_page and line.lstrip().startswith("```"):
            fence = not fence
        if is_of_names and is_of_names.fullmatch(line):
            continue
        if len(line) > LONGEST_LINE and not fence and not (is_page and (line.lstrip().startswith("|") or line.startswith("    "))):
            found.append(Finding(name, number, line[:30].strip() + " …", f"at most {LONGEST_LINE} columns, not {len(line)}"))
    return found


def doubled(changelog):
    """What stands twice in one version, as a merge can leave it: a heading, or DOUBLED words in a row."""
    found = []
    for version in re.split(r"^## ", changelog, flags=re.M)[1:]:
        found += [heading for heading, count in Counter(re.findall(r"^### .+$", version, re.M)).items() if count > 1]
        words = [word for part in version.split() if (word := re.sub(r"[^\w]", "", part).lower())]
        rows = Counter(" ".join(words[i:i + DOUBLED]) for i in range(len(words) - DOUBLED + 1))
        found += [row for row, count in rows.items() if count > 1 and not any(row in shared for shared in SHARED)]
    return found


def is_quoted_by_a_test(name, text, piece):
    lines = text.splitlines()
    return name.startswith("tests/") and piece.kind == "message" and not any('<< "' in lines[number - 1] for number in piece.lines)


def findings(path, root=ROOT, names=True):
    """All findings in a file, in the order of its lines."""
    name, text = path.relative_to(root).as_posix(), path.read_text()
    pieces = [piece for piece in prose_of(path) if not is_quoted_by_a_test(name, text, piece)]
    found = findings_in_prose(name, pieces) + findings_in_lines(name, text)
    if names and path.suffix in CPP:
        found += findings_in_names(name, text)
    return sorted(found, key=lambda finding: finding.line)


def files_under(paths, root=ROOT):
    """The C++ files under these paths, and the pages of docs/ and ext/; other pages where they are named themselves."""
    found = []
    for path in map(lambda name: root / name, paths):
        read = {*CPP, ".md"} if {root / "docs", root / "ext"} & {path, *path.parents} else CPP
        found += [path] if path.is_file() else sorted(p for p in path.rglob("*") if p.suffix in read)
    return found


def module_of(name):
    parts = name.split("/")
    return name if name.endswith(".md") else "/".join(parts[:2] if parts[0] == "ext" or len(parts) > 2 else parts[:1])


def report(paths, show, names):
    files, found = files_under(paths), []
    for path in files:
        found += findings(path, names=names)
    if show:
        print("\n".join(map(str, found)))
    prose = Counter(module_of(f.file) for f in found if not f.of_a_name)
    of_names = Counter(module_of(f.file) for f in found if f.of_a_name)
    count = Counter(module_of(path.relative_to(ROOT).as_posix()) for path in files)
    for module in sorted(count):
        print(f"{module}: {prose[module]} in prose, {of_names[module]} names, in {count[module]} files")
    print(f"{len(files)} files read, {len(found)} findings")
    return len(found)


class Language(unittest.TestCase):
    def test_enforced_paths_are_clean(self):
        found = [f for path in files_under(ENFORCED) for f in findings(path, names=False)]
        found += [f for path in files_under(ENFORCED_NAMES) for f in findings(path) if f.of_a_name]
        self.assertEqual(list(map(str, found)), [], "see tests/house/language_test.py")

    def test_enforced_paths_exist(self):
        for name in ENFORCED + ENFORCED_NAMES + PAGES:
            self.assertTrue((ROOT / name).exists(), name)

    def test_nothing_stands_twice_in_the_changelog(self):
        self.assertEqual(doubled((ROOT / "CHANGELOG.md").read_text()), [])


class Checker(unittest.TestCase):
    def of(self, name, text, names=True):
        """The findings in one made-up file, as (line, word)."""
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
            return [(f.line, f.word) for f in findings(path, Path(folder), names)]

    def test_finding_says_file_line_word_and_what_to_write(self):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "a.h").write_text("// At a moment.\n")
            found = findings(Path(folder) / "a.h", Path(folder))
        self.assertEqual(list(map(str, found)), ['a.h:1: "moment": write "time, instant"'])

    def test_comments_messages_and_pages_are_read(self):
        self.assertEqual(self.of("ext/a.h", "#pragma once\n/// Is told of it.\nint x;  // nobody\n"), [(2, "told"), (3, "nobody")])
        self.assertEqual(self.of("ext/a.cpp", 'fail("there is none: " + shown(x));\n'), [(1, "is none")])
        self.assertEqual(self.of("a.md", "# Words\n\nWhoever reads\nand is told so.\n"), [(1, "Words"), (3, "Whoever"), (4, "told")])

    def test_messages_that_tests_compare_are_read_where_ext_has_them(self):
        self.assertEqual(self.of("tests/a.cpp", 'EXPECT_EQ(error, "ships: there is none");\n'), [])
        self.assertEqual(self.of("tests/a.cpp", 'EXPECT_EQ(error, none) << "there is none";\n'), [(1, "is none")])

    def test_a_word_at_the_end_of_a_line_is_found_with_the_next(self):
        self.assertEqual(self.of("ext/a.h", "// Some hundred nanoseconds a\n// pair, as they\n// lie.\n"),
                         [(1, "nanoseconds a pair"), (2, "as they lie")])

    def test_man_pages_are_read_without_macros_and_lists_of_names(self):
        text = ".SH NAME\nforesee \\- is told\n.SH WORDS\n.TP\n.B f(told, asked)\nWhoever asks\n.IR moment ,\ngets:\ntold, asked.\n.nf\ntold\n.fi\n"
        self.assertEqual(self.of("f.3.in", text), [(2, "told"), (3, "WORDS"), (6, "asks"), (6, "Whoever")])

    def test_legitimate_uses_pass(self):
        for text in ("v.begin() and `begin`, from [begin, end) with begin <= end", "part of a way to see at most ten", "the most recent one",
                     "within BEGIN and COMMIT", "in the way, on the way, under way", "the two stay in the leaf", "one lies within the other",
                     "it cannot tell", "tell the two rows apart", "a look-up", "has room for 8", "none is left", "none of the rows",
                     "the column 'moment'", "the word \"told\" is quoted", "people who read it", "the normal times an edge"):
            self.assertEqual([w for _, w in self.of("ext/a.h", f"// {text}.\n") if w != "begin"], [], text)

    def test_examples_code_and_sql_are_not_prose(self):
        self.assertEqual(self.of("ext/a.h", "// A point.\n//\n//   auto moment = ask(told);  // who\n", names=False), [])
        self.assertEqual(self.of("ext/a.cpp", 'run("SELECT told, asked FROM w WHERE moment = 1");\n'), [])
        self.assertEqual(self.of("ext/a.cpp", 'R"(\nwho is told\n)";\n'), [])
        self.assertEqual(self.of("a.md", "A page.\n\n```sql\n-- who\n```\n\n    who is told\n"), [])

    def test_a_long_sentence_is_found_where_it_starts(self):
        long = "It has words " * 11
        self.assertEqual(self.of("ext/a.h", f"// Short.\n// {long[:60]}\n// {long[60:]}.\n"), [(2, "It has words It …")])
        self.assertEqual(self.of("ext/a.h", "// It has words. It is short, e.g. so. " + "Is it? " * 30 + "\n", names=False)[0][1][:6], "// It ")
        self.assertEqual(self.of("a.md", "| " + "four words are here | " * 12 + "\n"), [])
        some = "some words " * 10
        self.assertEqual(self.of("ext/a.cpp", f'f({{"{some}",\n   "{some}"}});\n'), [])
        self.assertEqual(self.of("ext/a.cpp", f'f("{some}"\n  "{some}");\n'), [(1, "some words some words …")])

    def test_a_long_line_is_found_outside_of_tables(self):
        words = "Word. " * 21
        self.assertEqual(self.of("a.md", f"{words}\n| {words} |\n\n```\n{words}\n```\n"), [(1, f"{words[:30].strip()} …")])

    def test_names_are_found_once_and_by_their_words(self):
        self.assertEqual(self.of("ext/a.h", "struct PairWay { int most_leaps; };\nPairWay way_off(Stayed, sway);\n"),
                         [(1, "PairWay"), (1, "most_leaps"), (2, "way_off")])
        self.assertEqual(self.of("ext/contact/growing/plates.h", ""), [(1, "plates.h"), (1, "growing")])

    def test_columns_of_stored_watches_keep_their_names(self):
        self.assertEqual(self.of("ext/sqlite/watch/a.h", "int told, asked, moment;\n"), [(1, "moment")])

    def test_what_stands_twice_in_a_version_is_found(self):
        entry = "- `predictive_avoid` lost clear ranges on accelerated paths.\n"
        self.assertEqual(doubled("## 2\n\n" + entry + "\n## 1\n\n" + entry), [])
        self.assertEqual(doubled("## 2\n\n" + entry + entry.replace("ranges on", "ranges\n  on")),
                         ["predictive_avoid lost clear ranges on accelerated paths"])
        self.assertEqual(doubled("## 2\n\n### Fixed\n\n### Added\n\n### Fixed\n"), ["### Fixed"])

    def test_headings_that_do_not_name_their_subject(self):
        self.assertEqual(self.of("a.md", "# What bites\n## How a row is stored\n## Cost\n## How does it scale?\n"),
                         [(1, "What bites"), (2, "How a row is stored")])


if __name__ == "__main__":
    arguments = sys.argv[1:]
    flags = {a for a in arguments if a in ("--list", "--prose")}
    paths = [a for a in arguments if not a.startswith("-")]
    if flags or paths:
        sys.exit(1 if report(paths or (*GROUPS, *PAGES), "--list" in flags, "--prose" not in flags) else 0)
    main()
