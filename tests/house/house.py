"""What the scripts of this folder share: the paths, the sqlite3 shell with the extension, visible skips."""
import os
import subprocess
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
EXTENSION = Path(os.environ.get("FORESEE_EXTENSION", ROOT / "build/release/foresee.so"))
SHARED_DATA = Path(os.environ.get("FORESEE_SHARED_DATA", ROOT.parent / "shared/data"))

SKIPPED = 77  # what CMakeLists.txt names as SKIP_RETURN_CODE


def with_extension(text):
    """`text` with the path of the extension that users are told replaced by the one under test."""
    return text.replace("build/release/foresee", str(EXTENSION.with_suffix("")))


def shell(script, *arguments, database=":memory:"):
    """Runs `script` in the sqlite3 shell from the root; returns (status, all that it prints)."""
    done = subprocess.run(
        ["sqlite3", "-batch", "-init", os.devnull, *map(with_extension, arguments), str(database)], input=with_extension(script), text=True,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, cwd=ROOT, timeout=300)
    return done.returncode, done.stdout


def main():
    """unittest.main(), except that a program of which every test was skipped says so to ctest."""
    program = unittest.main(exit=False, verbosity=2)
    result = program.result
    if not result.wasSuccessful() or result.testsRun + len(result.skipped) == 0:
        sys.exit(1)
    # A class that is skipped as a whole counts as skipped, and not as run.
    sys.exit(SKIPPED if len(result.skipped) >= result.testsRun else 0)
