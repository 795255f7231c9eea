"""Every step of sql/tour/ prints what its .expected file says.

    python3 tour_test.py --write    # writes the .expected files anew: read the difference before you commit it
"""
import sys
import unittest

from house import ROOT, main, shell

TOUR = ROOT / "sql/tour"


def printed(step):
    """What the sqlite3 shell prints for a step."""
    return shell(step.read_text())[1]


def steps():
    return sorted(TOUR.glob("*.sql"))


class Tour(unittest.TestCase):
    maxDiff = None

    def test_every_step_prints_what_is_expected(self):
        names = [step.stem for step in steps()]
        self.assertEqual([name[:2] for name in names], [f"{i + 1:02}" for i in range(len(names))])
        self.assertGreaterEqual(len(names), 5)
        for step in steps():
            with self.subTest(step.name):
                self.assertEqual(printed(step), step.with_suffix(".expected").read_text())


if __name__ == "__main__":
    if sys.argv[1:] == ["--write"]:
        for step in steps():
            step.with_suffix(".expected").write_text(printed(step))
    else:
        main()
