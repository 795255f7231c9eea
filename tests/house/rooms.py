"""Does every room keep to its place? Reads the #include lines under ext/ and says which break DESIGN's order.

    python3 rooms.py ext        # prints one line a violation; status 1 if there is any

The order: sqlite -> query -> index -> contact -> shape -> motion -> numbers -> base. A room may include rooms to its
right and no others, with two doors of their own: storage may include shape, motion, base and the page and tree interface
of index, and only sqlite may include storage. SQLite's headers are for storage and sqlite alone.
"""
import re
import sys
from pathlib import Path

ORDER = ["query", "index", "contact", "shape", "motion", "numbers", "base"]
MAY_INCLUDE = {room: set(ORDER[i + 1:]) for i, room in enumerate(ORDER)}
MAY_INCLUDE["storage"] = {"shape", "motion", "base"}
MAY_INCLUDE["sqlite"] = {"storage", *ORDER}
# What the index asks of a place to keep pages, which storage supplies; and the tree that it makes of them.
PAGE_INTERFACE = {"index/pages.h", "index/tpr_tree/tpr_tree.h"}
SEES_SQLITE = {"storage", "sqlite"}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def complaint(room, target):
    """Why a file of `room` may not include `target`; None if it may."""
    name = target.rsplit("/", 1)[-1]
    if name.startswith("sqlite3") and room not in SEES_SQLITE:
        return f"only {' and '.join(sorted(SEES_SQLITE))} see SQLite"
    if target.startswith(".") or "/../" in target:
        return "include by room, as in \"motion/vec.h\", not by relative path"
    other = target.split("/", 1)[0] if "/" in target else None
    if other not in MAY_INCLUDE or other == room:
        return None
    if room == "storage" and target in PAGE_INTERFACE:
        return None
    if other not in MAY_INCLUDE[room]:
        return f"{room} may include {', '.join(sorted(MAY_INCLUDE[room])) or 'no other room'}"
    return None


def violations(ext):
    """(sentences, number of files read) for all sources under the folder `ext`."""
    found, files = [], 0
    for path in sorted(p for p in Path(ext).rglob("*") if p.suffix in {".h", ".hpp", ".cpp", ".c", ".inc"}):
        files += 1
        inside = path.relative_to(ext)
        room = inside.parts[0]
        if room not in MAY_INCLUDE or len(inside.parts) < 2:
            found.append(f"{inside}: not in a room")
            continue
        for number, line in enumerate(path.read_text().splitlines(), 1):
            match = INCLUDE.match(line)
            reason = match and complaint(room, match.group(2))
            if reason:
                found.append(f"{inside}:{number}: includes {match.group(2)}: {reason}")
    return found, files


if __name__ == "__main__":
    sentences, read = violations(sys.argv[1])
    print("\n".join(sentences))
    print(f"{read} files read, {len(sentences)} violations")
    sys.exit(1 if sentences or read == 0 else 0)
