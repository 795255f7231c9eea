"""What the pages say about the sources, and whether it is so: paths, links, and which files name a word.

    complaints_about_page(ROOT / "docs/developers/recipes.md", files_of(ROOT))      # a sentence for each path or link that leads nowhere
    complaints_about_source(ROOT / "ext/base/simd.h", ROOT, files)       # the same for comments
    complaints_about_lists(page, ROOT)                                   # and for each list of files that is not the true one

A path may be written from the root, from ext/ or from any folder on the way, as `storage/nodes/node_history.h` or `node_history.h`; with *
it stands for any that fit. SQL examples and addresses are not looked at, nor what is built.

A list of files is a table behind `<!-- files that name WORD -->`: the first column has every file under ext/ whose code,
not counting comments, has the word, and no others.
"""
import re
from fnmatch import fnmatch
from pathlib import Path

FOLDERS = ("ext", "tests", "bench", "docs", "sql")
SOURCES = {".h", ".cpp", ".c", ".sh", ".sql", ".gnuplot", ".txt"}
SUFFIXES = "h|cpp|c|py|sh|sql|md|csv|txt|svg|json|map|gnuplot"
PATH = re.compile(rf"(?<![\w./<>*-])(?:[\w.*-]+/)*[\w*][\w.*-]*\.(?:{SUFFIXES})(?![\w/])")
FOLDER = re.compile(r"`((?:[\w.-]+/)+)`")
LINK = re.compile(r"\]\(([^)\s]+)\)")
ADDRESS = re.compile(r"\bhttps?://\S+")
ROOTED = re.compile(rf"(?<![\w./-])(?:{'|'.join(FOLDERS)})/[\w./-]+\.(?:{SUFFIXES})\b")
ANCHORED = re.compile(r"(docs/[\w/-]+\.md)#([\w-]+)")
LIST = re.compile(r"^<!-- files that name (\S+) -->$")
ELSEWHERE = ("build/", "FOLDER/", "AIS_2022_01_03.csv", "sqlite3.c", "sqlite3.h", "sqlite3ext.h")


def files_of(root):
    """All files that pages may speak of, as paths from the root; folders end with a slash.

    A folder counts if it holds a file: git leaves moved files' empty folders behind, and a fresh clone has none.
    """
    root = Path(root)
    files = [path for folder in FOLDERS for path in (root / folder).rglob("*") if path.is_file()]
    found = {path.relative_to(root) for path in files if "__pycache__" not in path.parts}
    folders = {folder for path in found for folder in path.parents if folder.name}
    return ({path.name for path in root.iterdir() if path.is_file()} | {path.as_posix() for path in found} |
            {folder.as_posix() + "/" for folder in folders})


def is_there(name, files):
    return any(file == name or file.endswith("/" + name) or fnmatch(file, name) or fnmatch(file, "*/" + name) for file in files)


def nowhere(name, files):
    """'x.h is nowhere', and where a file of that name is, if there is one."""
    last = name.rstrip("/").rsplit("/", 1)[-1]
    others = sorted(file for file in files if file.rstrip("/").rsplit("/", 1)[-1] == last)
    return f"{name} is nowhere" + (f"; there is {', '.join(others)}" if others else "")


def anchors(text):
    """What the headings of a page are called in links."""
    headings = re.findall(r"^#+ (.+)$", re.sub(r"^```.*?^```", "", text, flags=re.M | re.S), re.M)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def link_complaint(page, target):
    if target.startswith("http"):
        return None
    name, _, anchor = target.partition("#")
    file = page.parent / name if name else page
    if not file.exists():
        return f"the link to {target} leads nowhere"
    if anchor and anchor not in anchors(file.read_text()):
        return f"{name or 'the page'} has no heading #{anchor}"
    return None


def complaints_about_page(page, files):
    found, fence = [], None
    for number, line in enumerate(page.read_text().splitlines(), 1):
        if line.startswith("```"):
            fence = None if fence is not None else line[3:].strip()
            continue
        if fence is not None and fence.startswith("sql"):
            continue
        words = ADDRESS.sub("", line)
        reasons = [link_complaint(page, target) for target in LINK.findall(words)] if fence is None else []
        rest = LINK.sub("]", words)
        names = PATH.findall(rest) + FOLDER.findall(rest)
        reasons += [nowhere(name, files) for name in names if not name.startswith(ELSEWHERE) and not is_there(name, files)]
        found += [f"{page.name}:{number}: {reason}" for reason in reasons if reason]
    return found


def paths_of_source(line, suffix):
    """The paths that a line of a source sends its reader to: in C++ those of comments, elsewhere those from the root."""
    if suffix not in {".h", ".cpp", ".c"}:
        return ROOTED.findall(line)
    comment = re.search(r"//.*", ADDRESS.sub("", line))
    return PATH.findall(comment.group()) if comment else []


def complaints_about_source(source, root, files):
    found = []
    for number, line in enumerate(source.read_text().splitlines(), 1):
        reasons = [nowhere(name, files) for name in paths_of_source(line, source.suffix)
                   if not name.startswith(ELSEWHERE) and not is_there(name, files)]
        for name, anchor in ANCHORED.findall(line):
            if (root / name).exists() and anchor not in anchors((root / name).read_text()):
                reasons.append(f"{name} has no heading #{anchor}")
        found += [f"{source.relative_to(root)}:{number}: {reason}" for reason in reasons]
    return found


def files_that_name(word, root):
    """Files under ext/ with the word in their code."""
    found, named = set(), re.compile(rf"(?<!\w){re.escape(word)}")
    for path in (root / "ext").rglob("*"):
        if path.suffix in {".h", ".cpp"} and named.search(re.sub(r"//.*", "", path.read_text())):
            found.add(path.relative_to(root).as_posix())
    return found


def complaints_about_lists(page, root):
    """(complaints, number of lists)."""
    found, lists, word, listed = [], 0, None, set()
    for line in [*page.read_text().splitlines(), ""]:
        marked = LIST.match(line)
        if marked:
            word, listed, lists = marked.group(1), set(), lists + 1
        elif word and line.startswith("|"):
            listed |= set(re.findall(r"`([^`]+)`", line.split("|")[1]))
        elif word and listed:
            true = files_that_name(word, root)
            found += [f"{page.name}: {file} names {word} and is not in the list" for file in sorted(true - listed)]
            found += [f"{page.name}: {file} is in the list, but does not name {word}" for file in sorted(listed - true)]
            word = None
    return found, lists
