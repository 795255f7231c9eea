"""Runs the SQL examples of a Markdown file, in order, in the sqlite3 shell with the extension, on one fresh database.

What is run:
    ```sql            a block: it must succeed
    ```sql error      a block that must fail, with at most 160 characters; the ```text block that follows holds what it must say
    ```text           after a ```sql block: what it prints, line by line, in the shell's box mode
    <!-- sql setup    until -->: run before what follows, not shown to readers
    <!-- sql errors --> and a table: the statement in the first column of every row must fail and say what stands in
                      the second, with at most 160 characters

Every block is a shell of its own: temporary tables and `.mode` end with it, the database stays.
"""
import re
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Optional

from house import shell

FENCE = re.compile(r"^```(.*)$")
ERROR_ROW = re.compile(r"^\| `(.+)` \| (.+) \|$")
MESSAGE = re.compile(r"^(?:Runtime error|Parse error|Error)(?: near line \d+)?: (.*?)(?: \(\d+\))?$", re.M)
LIST = re.compile(r" \(moving_objects tables here: .*\)$")
LONGEST_MESSAGE = 160


@dataclass
class Block:
    kind: str  # "sql", "sql error", "setup" or another fence's tag
    line: int
    text: str
    expected: Optional[str] = None


def fenced_and_hidden(document):
    """The fenced blocks and hidden set-ups of a document, in order."""
    found, open_block, end = [], None, None
    for number, line in enumerate(document.splitlines(), 1):
        if open_block is None:
            fence = FENCE.match(line)
            if fence:
                open_block, end = Block(fence.group(1).strip(), number, ""), "```"
            elif line.strip() == "<!-- sql setup":
                open_block, end = Block("setup", number, ""), "-->"
        elif line.strip() == end:
            found.append(open_block)
            open_block = None
        else:
            open_block.text += line + "\n"
    if open_block is not None:
        raise ValueError(f"line {open_block.line}: the block never ends")
    return found


def error_rows(document):
    """The rows of those tables that are marked as errors."""
    found, marked = [], False
    for number, line in enumerate(document.splitlines(), 1):
        row = ERROR_ROW.match(line)
        if line.strip() == "<!-- sql errors -->":
            marked = True
        elif line.strip() and not line.startswith("|"):
            marked = False
        elif marked and row:
            found.append(Block("sql error", number, row.group(1) + ";", row.group(2)))
    return found


def examples(document):
    """The blocks to run; a `text` block has become the `expected` of the block before it."""
    runnable, previous = error_rows(document), None
    for block in fenced_and_hidden(document):
        if block.kind in ("sql", "sql error", "setup"):
            runnable.append(block)
        elif block.kind == "text" and previous is not None and previous.kind.startswith("sql"):
            previous.expected = block.text
        previous = block
    return sorted(runnable, key=lambda block: block.line)


def lines(text):
    return [line.rstrip() for line in text.strip().splitlines()]


def message_of(output):
    """The message of the error that the shell prints, without a list of tables at its end; "" if it prints none."""
    found = MESSAGE.search(output)
    return LIST.sub("", found[1]) if found else ""


def complaint(block, status, output):
    """What is wrong with a block's outcome; None if nothing."""
    if block.kind == "sql error":
        if status == 0:
            return "was to fail, and did not"
        missing = [line for line in lines(block.expected or "") if line.strip() not in output]
        if not block.expected or missing:
            return f"failed as it should, but says\n{output}"
        if (length := len(message_of(output))) > LONGEST_MESSAGE:
            return f"says more than {LONGEST_MESSAGE} characters, {length}:\n{output}"
        if not length:
            return f"prints no message:\n{output}"
    elif status != 0:
        return f"fails:\n{output}"
    elif block.expected is not None and lines(output) != lines(block.expected):
        return f"prints\n{output}"
    return None


def run_document(document, name):
    """(complaints, number of blocks run)."""
    found, blocks = [], examples(document)
    with tempfile.TemporaryDirectory() as folder:
        for block in blocks:
            loads = [] if ".load" in block.text else ["-cmd", ".load build/release/foresee"]
            status, output = shell(block.text, "-box", "-bail", *loads, database=Path(folder) / "example.db")
            wrong = complaint(block, status, output)
            if wrong:
                found.append(f"{name}:{block.line}: the {block.kind} block {wrong}")
    return found, len(blocks)
