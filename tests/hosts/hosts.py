"""What the tests of the hosts share: what was built and packed, commands, visible skips, the examples of a page.

Nothing here is taken from the source tree but the pages: a host is tested with what was installed or packed.
"""
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/house"))
from documents import fenced_and_hidden  # noqa: E402
from house import main  # noqa: E402,F401

BUILD = Path(os.environ.get("FORESEE_BUILD", ROOT / "build/release"))
PACKAGES = Path(os.environ.get("FORESEE_PACKAGES", ROOT / "build/packages"))
MEETING = "Anna and Bruno touch after 95 s\n"


def skip(what, why):
    """Leaves the test out, and says so where a reader of the log finds it."""
    print(f"SKIPPED: {what}, because {why}", flush=True)
    raise unittest.SkipTest(why)


def need_commands(what, *commands):
    for command in commands:
        if shutil.which(command) is None:
            skip(what, f"there is no {command}")


def packed(what, pattern):
    """The file that ext/hosts/pack.sh has written."""
    files = sorted(PACKAGES.glob(pattern), key=lambda file: file.stat().st_mtime)
    if not files:
        skip(what, f"{PACKAGES} holds no {pattern}: run ext/hosts/pack.sh")
    return files[-1]


def run(*command, folder=None, fails=False, **environment):
    """What a command prints; it must succeed, or with `fails` must not."""
    done = subprocess.run([str(part) for part in command], cwd=folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          env={**os.environ, **environment}, timeout=900)
    if (done.returncode != 0) != fails:
        raise AssertionError(f"{' '.join(map(str, command))}\nended with status {done.returncode}:\n{done.stdout}")
    return done.stdout


def blocks(page, kind):
    """The texts of a page's blocks of one kind, in order."""
    return [block.text for block in fenced_and_hidden((ROOT / "docs/hosts" / page).read_text()) if block.kind == kind]


def version():
    """That of project(), which every package has."""
    text = (ROOT / "CMakeLists.txt").read_text()
    return text.split("project(foresee VERSION ")[1].split()[0]


class Host(unittest.TestCase):
    """A test with a folder of its own, far from the sources."""

    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="foresee-hosts-"))
        self.addCleanup(shutil.rmtree, self.folder)

    def write(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return path
