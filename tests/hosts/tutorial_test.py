"""docs/tutorials/ais_to_alerts.md: every command runs in order and prints what the page says, on the bundled file and on one in
NOAA's layout that this test makes; at most 25 lines to copy.

    python3 tutorial_test.py --write        # writes what the commands print into the page: read the difference before you commit it
"""
import os
import re
import shutil
import subprocess
import sys
import urllib.request

from hosts import ROOT, fenced_and_hidden, main, need_commands
from live import PYTHON, Live, free_port, waited

PAGE = ROOT / "docs/tutorials/ais_to_alerts.md"
NOAA = ("MMSI,BaseDateTime,LAT,LON,SOG,COG,Heading,VesselName,IMO,CallSign,VesselType,Status,Length,Width,Draft,Cargo,TransceiverClass\n"
        "211000001,2022-01-03T00:00:00,53.99,7.85,14.0,91.0,91,ANNA,,,70,0,180,30,,,A\n"
        "211000002,2022-01-03T00:00:02,53.985,7.97,12.0,272.0,271,BRUNO,,,70,0,120,20,,,A\n"
        "211000001,2022-01-03T00:02:00,53.9899,7.863,14.0,91.0,91,ANNA,,,70,0,180,30,,,A\n"
        "211000002,2022-01-03T00:02:02,53.9852,7.958,12.0,272.0,271,BRUNO,,,70,0,120,20,,,A\n"
        "211000003,2022-01-03T00:02:05,-33.9,151.2,8.0,10.0,10,TOO FAR,,,70,0,120,20,,,A\n")


def blocks():
    """(command, expected or None) of each bash block; the page's first one installs the wheel, as this test has already."""
    page = fenced_and_hidden(PAGE.read_text())
    found = []
    for block, after in zip(page, [*page[1:], None]):
        if block.kind == "bash":
            found.append((block.text, after.text if after and after.kind == "text" else None))
    return found


def timeless(text):
    return re.sub(r"\d+ lines per second", "N lines per second", text).strip()


def with_output(found, output):
    """A bash block with what it printed in the text block behind it, if there is one."""
    return found[1] + (f"\n```text\n{timeless(output)}\n```" if found[2] else "")


class Tutorial(Live):
    maxDiff = None

    def setUp(self):
        super().setUp()
        need_commands("the tutorial", "sqlite3")
        (self.folder / "sql").symlink_to(ROOT / "sql")
        self.write("AIS_2022_01_03.csv", NOAA)
        python = self.write("fleet/bin/python", f"#!/bin/sh\nPYTHONPATH={self.site} exec {PYTHON} \"$@\"\n")
        python.chmod(0o755)
        (self.folder / "build/release").mkdir(parents=True)
        shutil.copy(self.site / "foresee/foresee.so", self.folder / "build/release/foresee.so")

    def printed(self, command):
        done = subprocess.run(["bash", "-c", command + "\nwait %1 2>/dev/null || true" if " &\n" in command else command], cwd=self.folder,
                              env=self.environment, text=True, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=120)
        self.assertEqual(done.returncode, 0, f"{command}\n{done.stdout}")
        return done.stdout

    def shows_the_map(self, command):
        port = free_port()
        server = subprocess.Popen(["bash", "-c", f"exec {command.strip()} --port {port}"], cwd=self.folder, stdout=subprocess.PIPE, text=True)
        self.addCleanup(server.wait)
        self.addCleanup(server.stdout.close)
        self.addCleanup(server.kill)
        self.assertIn(f"http://127.0.0.1:{port}/", server.stdout.readline())
        with urllib.request.urlopen(f"http://127.0.0.1:{port}/state") as answer:
            self.assertIn(b"AMBER DOLPHIN", answer.read())

    def follows_a_feed(self, command):
        """The two terminals: alerts in the background until the feed has ended."""
        create, follow, feed = command.strip().splitlines()
        self.printed(create)
        reader = subprocess.Popen(["bash", "-c", "exec " + follow.rstrip("& ")], cwd=self.folder)
        self.addCleanup(reader.wait)
        self.addCleanup(reader.kill)
        self.printed(feed)
        lines = self.folder / "alerts.jsonl"
        waited(lambda: lines.exists() and lines.read_text().count('"op": "+"') > 50, what="the alerts")

    def run_all(self):
        """What each command printed, in order."""
        outputs = []
        for command, _ in blocks()[1:]:
            if " map " in command:
                self.shows_the_map(command)
                outputs.append(None)
            elif " &\n" in command:
                self.follows_a_feed(command)
                outputs.append(None)
            else:
                outputs.append(self.printed(command))
        return outputs

    def test_every_command_does_what_the_page_says(self):
        outputs = self.run_all()
        if "--write" in WRITE:
            rewritten = iter([None, *outputs])
            text = re.sub(r"(```bash\n(?:(?!```).)*```\n)(\n```text\n(?:(?!```).)*```)?", lambda found: with_output(found, next(rewritten)),
                          PAGE.read_text(), flags=re.S)
            PAGE.write_text(text)
        for (command, expected), output in zip(blocks()[1:], outputs):
            if expected is not None:
                with self.subTest(command):
                    self.assertEqual(timeless(output), timeless(expected))
        # The file in NOAA's layout: one encounter, and the ship on the other side of the Earth is named.
        own = next(output for (command, _), output in zip(blocks()[1:], outputs) if "own.db" in command)
        self.assertRegex(own, r"(?m)^2022-01-03 00:02:02  \+  ANNA, BRUNO  TCPA \d\.\d min  CPA \d+ m  53\.98\d\d N 7\.9\d\d\d E$")
        self.assertIn("ship 211000003: ", own)

    def test_there_are_few_lines_to_copy(self):
        lines = [line for command, _ in blocks() for line in command.splitlines()]
        self.assertLessEqual(len(lines), 25)

    def test_the_first_block_installs_what_wheel_test_installs(self):
        self.assertEqual(blocks()[0][0].splitlines()[0], "bash ext/hosts/pack.sh wheel")
        self.assertTrue(os.access(ROOT / "ext/hosts/pack.sh", os.R_OK))


WRITE = [argument for argument in sys.argv if argument == "--write"]
if __name__ == "__main__":
    sys.argv = [argument for argument in sys.argv if argument != "--write"]
    main()
