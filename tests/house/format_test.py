"""Every source is formatted as .clang-format says, by the clang-format of Debian 12 (others break lines otherwise)."""
import re
import shutil
import subprocess
import unittest

from house import ROOT, main

VERSION = "14"


def sources():
    return sorted(path for folder in ("ext", "tests", "bench", "docs") for path in (ROOT / folder).rglob("*")
                  if path.suffix in {".h", ".cpp", ".c"})


class Format(unittest.TestCase):
    def test_every_source_is_formatted(self):
        program = shutil.which(f"clang-format-{VERSION}") or shutil.which("clang-format")
        if not program:
            self.skipTest("there is no clang-format")
        version = subprocess.run([program, "--version"], text=True, capture_output=True).stdout
        if not re.search(rf"version {VERSION}\.", version):
            self.skipTest(f"not clang-format {VERSION}: {version.strip()}")
        files = sources()
        self.assertGreater(len(files), 20)
        done = subprocess.run([program, "--dry-run", "--Werror", *map(str, files)], text=True, capture_output=True)
        self.assertEqual(done.returncode, 0, done.stderr)


if __name__ == "__main__":
    main()
