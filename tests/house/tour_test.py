"""Every step of sql/tour/ prints what its .expected file says.

    python3 tour_test.py --write    # writes the .expected files anew: read the difference before you commit it
"""
import sys
import unittest

from house import ROOT, SHARED_DATA, main, shell

TOUR = ROOT / "sql/tour"
REAL = "05_real_ships"  # needs the AIS data beside the clone


def printed(step):
    """What the sqlite3 shell prints for a step; the real ships come from where FORESEE_SHARED_DATA says."""
    return shell(step.read_text().replace("../shared/data", str(SHARED_DATA)))[1]


def steps():
    return sorted(TOUR.glob("*.sql"))


class Tour(unittest.TestCase):
    maxDiff = None

    def test_every_step_prints_what_is_expected(self):
        names = [step.stem for step in steps()]
        self.assertEqual([name[:2] for name in names], [f"{i + 1:02}" for i in range(len(names))])
        self.assertGreaterEqual(len(names), 5)
        for step in steps():
            if step.stem != REAL:
                with self.subTest(step.name):
                    self.assertEqual(printed(step), step.with_suffix(".expected").read_text())


class RealShips(unittest.TestCase):
    maxDiff = None

    def test_the_real_ships_meet_as_expected(self):
        if not (SHARED_DATA / "ships_us_20220103.csv.gz").exists():
            self.skipTest(f"no AIS data in {SHARED_DATA}")
        step = TOUR / f"{REAL}.sql"
        self.assertEqual(printed(step), step.with_suffix(".expected").read_text())


if __name__ == "__main__":
    if sys.argv[1:] == ["--write"]:
        for step in steps():
            step.with_suffix(".expected").write_text(printed(step))
    else:
        main()
