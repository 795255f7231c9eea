"""sql/packages.sh: installs what is missing and nothing else; without apt it says what is missing and begins nothing."""
import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from house import ROOT, main

FAKE_APT = """#!/bin/bash
echo "apt-get $* ($DEBIAN_FRONTEND)" >> "$APT_LOG"
if [ "$1" = install ]; then printf '#!/bin/bash\\n' > "$FAKES/frobnicate"; chmod +x "$FAKES/frobnicate"; fi
"""


class Packages(unittest.TestCase):
    def need(self, *needs, apt):
        """need_packages on a machine that has bash, id and, if `apt`, a made-up apt-get: (status, output, apt's calls)."""
        with tempfile.TemporaryDirectory() as folder:
            fakes, log = Path(folder) / "bin", Path(folder) / "apt.log"
            fakes.mkdir()
            for program in ("bash", "env", "chmod"):
                (fakes / program).symlink_to(shutil.which(program))
            self.program(fakes / "id", "#!/bin/bash\necho 0\n")
            if apt:
                self.program(fakes / "apt-get", FAKE_APT)
            done = subprocess.run(
                ["bash", "-c", 'set -euo pipefail; . "$1"; shift; need_packages "$@"; echo ready', "-", ROOT / "sql/packages.sh",
                 *needs], env=dict(os.environ, PATH=str(fakes), FAKES=str(fakes), APT_LOG=str(log)), text=True,
                stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            return done.returncode, done.stdout, log.read_text().splitlines() if log.exists() else []

    def program(self, path, text):
        path.write_text(text)
        path.chmod(0o755)

    def test_nothing_is_installed_when_nothing_is_missing(self):
        self.assertEqual(self.need("bash: command bash", apt=True), (0, "ready\n", []))

    def test_only_what_is_missing_is_installed_without_a_question(self):
        status, output, calls = self.need("bash: command bash", "frob-tools: command frobnicate", apt=True)
        self.assertEqual(status, 0, output)
        self.assertEqual(len(calls), 2, calls)
        self.assertTrue(calls[0].startswith("apt-get update"))
        self.assertRegex(calls[1], r"^apt-get install -y .* frob-tools \(noninteractive\)$")

    def test_a_file_may_be_the_sign_of_a_package(self):
        self.assertEqual(self.need("bash: file /bin/ba*", apt=True), (0, "ready\n", []))
        _, _, calls = self.need("crates: file /nowhere/crate-*/Cargo.toml", apt=True)
        self.assertRegex(calls[1], " crates ")

    def test_without_apt_it_says_what_is_missing(self):
        status, output, _ = self.need("frob-tools: command frobnicate", "bash: command bash", "libx: command x", apt=False)
        self.assertEqual(status, 1)
        self.assertIn("Missing on this machine (by their Debian names): frob-tools libx", output)
        self.assertNotIn("ready", output)

    def test_what_apt_cannot_bring_is_named(self):
        status, output, _ = self.need("gone: command no_such_program", apt=True)
        self.assertEqual(status, 1)
        self.assertIn("gone", output)
        self.assertNotIn("ready", output)


if __name__ == "__main__":
    main()
