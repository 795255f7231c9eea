"""Checks the order of modules: reads the #include lines under ext/ and reports those that break docs/developers/architecture.md.

    python3 modules.py ext tests        # prints one line a violation; status 1 if there is any

The order: sqlite -> query -> index -> contact -> shape -> motion -> numbers -> base. A module may include modules to its
right and no others, with exceptions: geography may include shape, motion and base; format these, geography and the page and
tree interface of index; database base alone; storage what format may, format and database. Only sqlite may include storage.
SQLite's headers are for database, storage and sqlite alone. Modules inside a module have an order too; files directly in a
module may include them and be included. No headers include each other in a circle. Every folder of tests/ is a module of ext/,
except for those of TESTS_OF_NO_MODULE. A test that is named after a file stands in that file's module.
"""
import re
import sys
from pathlib import Path

ORDER = ["query", "index", "contact", "shape", "motion", "numbers", "base"]
MAY_INCLUDE = {module: set(ORDER[i + 1:]) for i, module in enumerate(ORDER)}
MAY_INCLUDE["geography"] = {"shape", "motion", "base"}
MAY_INCLUDE["format"] = {"geography", *MAY_INCLUDE["geography"]}
MAY_INCLUDE["database"] = {"base"}
MAY_INCLUDE["storage"] = {"format", "database", *MAY_INCLUDE["format"]}
MAY_INCLUDE["sqlite"] = {"storage", "format", "database", "geography", *ORDER}
MAY_INCLUDE["hosts"] = {"sqlite"}
# What the index asks of a place to keep pages, and of plans, which storage supplies; and the tree that it makes of them.
PAGE_INTERFACE = {"index/pages.h", "index/chunk_source.h", "index/tpr_tree/tpr_tree.h", "index/tpr_tree/node.h"}
SEES_PAGES = {"format", "storage"}
SEES_SQLITE = {"database", "storage", "sqlite", "hosts"}
# The modules inside a module: each may include those to its right.
INSIDE = {
    "contact": ["clearance", "mesh", "outline", "boxes", "set", "certified", "exact", "minkowski", "constraint"],
    "index": ["paper_grid", "gpcd_grid", "tpr_tree"],
    "shape": ["mesh", "outline"],
    "query": ["avoid", "watch", "join", "tile", "sweep", "window", "nearest", "position", "legs"],
    "storage": ["table", "tree", "nodes", "rows"],
    "sqlite": ["watch", "functions", "names", "table"],
}
# Folders of tests/ that are of no one module, and files that tests read.
TESTS_OF_NO_MODULE = {"house", "fuzz", "portability", "release", "storage/files", "sqlite/faults", "sqlite/lives"}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def inner_module(parts):
    """The module inside a module that a path leads to, or None for what lies at the module's door."""
    return parts[1] if len(parts) > 2 else None


def complaint(source, target):
    """Why the file `source` may not include `target`, both as paths under ext; None if it may."""
    module = source.parts[0]
    name = target.rsplit("/", 1)[-1]
    if name.startswith("sqlite3") and module not in SEES_SQLITE:
        return f"only {' and '.join(sorted(SEES_SQLITE))} see SQLite"
    if target.startswith(".") or "/../" in target:
        return "include by module, as in \"motion/vec.h\", not by relative path"
    other = target.split("/", 1)[0] if "/" in target else None
    if other == module:
        return complaint_inside(module, inner_module(source.parts), inner_module(target.split("/")))
    if other not in MAY_INCLUDE:
        return None
    if module in SEES_PAGES and target in PAGE_INTERFACE:
        return None
    if other not in MAY_INCLUDE[module]:
        return f"{module} may include {', '.join(sorted(MAY_INCLUDE[module])) or 'no other module'}"
    return None


def complaint_inside(module, here, there):
    """The same for two places of one module."""
    if here is None or there is None or here == there:
        return None
    order = INSIDE.get(module, [])
    for place in (here, there):
        if place not in order:
            return f"{module}/{place} has no place in the order of the modules inside {module}"
    if order.index(there) < order.index(here):
        return f"{module}/{here} may include {', '.join(order[order.index(here) + 1:]) or 'no other module inside'}"
    return None


def circle(includes):
    """The files of a circle of includes, or []. `includes`: {file: [included files]}."""
    done, path = set(), []

    def visit(file):
        if file in path:
            return path[path.index(file):] + [file]
        if file in done:
            return []
        path.append(file)
        for other in includes.get(file, []):
            if found := visit(other):
                return found
        done.add(path.pop())
        return []

    for file in includes:
        if found := visit(file):
            return found
    return []


def violations(ext):
    """(sentences, number of files read) for all sources under the folder `ext`."""
    found, files, includes = [], 0, {}
    for path in sorted(p for p in Path(ext).rglob("*") if p.suffix in {".h", ".hpp", ".cpp", ".c", ".inc"}):
        files += 1
        inside = path.relative_to(ext)
        module = inside.parts[0]
        if module not in MAY_INCLUDE or len(inside.parts) < 2:
            found.append(f"{inside}: not in a module")
            continue
        targets = includes[inside.as_posix()] = []
        for number, line in enumerate(path.read_text().splitlines(), 1):
            match = INCLUDE.match(line)
            if match and match.group(1) == '"':
                targets.append(match.group(2))
            reason = match and complaint(inside, match.group(2))
            if reason:
                found.append(f"{inside}:{number}: includes {match.group(2)}: {reason}")
    if files_of_circle := circle(includes):
        found.append("a circle of includes: " + " -> ".join(files_of_circle))
    return found, files


def strange_folders(ext, tests):
    """A sentence for each folder under `tests` that has no module under `ext`."""
    found = []
    for folder in sorted(path for path in Path(tests).rglob("*") if path.is_dir() and any(p.is_file() for p in path.iterdir())):
        name = folder.relative_to(tests).as_posix()
        of_no_module = any(f"{name}/".startswith(f"{other}/") for other in TESTS_OF_NO_MODULE)
        if not of_no_module and folder.name != "__pycache__" and not (Path(ext) / name).is_dir():
            found.append(f"tests/{name}: there is no ext/{name}")
    return found


def misplaced_tests(ext, tests):
    """A sentence for each tests/…/name_test.cpp that is not in the module of name.h or name.cpp."""
    found = []
    for test in sorted(Path(tests).rglob("*_test.cpp")):
        here = test.parent.relative_to(tests)
        module = Path(ext) / (here.parts[0] if here.parts else "")
        modules = {path.parent.relative_to(ext).as_posix() for path in module.rglob(test.name.replace("_test.cpp", ".*"))}
        if modules and here.as_posix() not in modules:
            found.append(f"tests/{here.as_posix()}/{test.name}: what it tests is in ext/{', ext/'.join(sorted(modules))}")
    return found


if __name__ == "__main__":
    sentences, read = violations(sys.argv[1])
    sentences += strange_folders(sys.argv[1], sys.argv[2]) + misplaced_tests(sys.argv[1], sys.argv[2])
    print("\n".join(sentences))
    print(f"{read} files read, {len(sentences)} violations")
    sys.exit(1 if sentences or read == 0 else 0)
