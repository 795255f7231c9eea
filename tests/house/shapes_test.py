"""What docs/how-to/hulls.md shows beyond its examples: the recipe makes hulls of real ships."""
import csv
import functools
import unittest

from documents import examples
from house import ROOT, SHARED_DATA, main, shell

MOMENT = 1641168600  # 2022-01-03 00:10:00


def recipe():
    """The block of the page that makes ais_hulls of ais_reports and ais_ships."""
    blocks = [block.text for block in examples((ROOT / "docs/how-to/hulls.md").read_text()) if "TABLE ais_hulls" in block.text]
    assert len(blocks) == 1
    return blocks[0]


@functools.cache
def answers(reports):
    """The rows that the questions about the hulls of these reports print."""
    join = f"FROM predictive_join(600, 'ais_hulls', 50, NULL, {MOMENT}, '%s') ORDER BY a, b;"
    status, output = shell("\n".join([
        ".load build/release/foresee", ".mode csv", f".import --csv \"|gzip -dc {reports}\" ais_reports",
        "CREATE TABLE ais_parameters(name TEXT PRIMARY KEY, value REAL);",
        f"INSERT INTO ais_parameters VALUES ('moment', {MOMENT}), ('centre_lat', 30), ('centre_lon', -90.5);",
        ".read sql/import_ais.sql", recipe(),
        "SELECT count(*), count(shape), sum(r > 0), count(DISTINCT shape), (SELECT count(*) FROM ais_hulls_shape) FROM ais_hulls;",
        f"SELECT n_before, n_after FROM predictive_explain(600, 'ais_hulls', 50, NULL, {MOMENT}) WHERE stage = 'refinement';",
        *(f"SELECT '{method}', a, b, printf('%!.17g,%!.17g', t, t_end) {join % method}" for method in ("grid", "tree", "scan")),
        "INSERT INTO ais_hulls(ais_hulls) VALUES ('integrity-check');", ""]), "-bail")
    if status:
        raise AssertionError(output)
    return list(csv.reader(output.splitlines()))


class RealHulls(unittest.TestCase):
    """Of the Lower Mississippi, where about half of the ships say neither heading nor course, or no width."""

    def setUp(self):
        reports = SHARED_DATA / "ships_us_20220103.csv.gz"
        if not reports.exists():
            self.skipTest(f"no AIS data in {SHARED_DATA}")
        self.counts, self.refined, *self.pairs = answers(reports)

    def test_each_ship_is_a_hull_a_disc_or_a_point(self):
        ships, hulls, discs, outlines, stored = map(int, self.counts)
        self.assertEqual((ships, hulls, discs), (1135, 574, 499))
        self.assertEqual(outlines, stored)  # each once

    def test_all_methods_find_the_same_pairs_at_the_same_moments(self):
        grid, tree, scan = ([pair[1:] for pair in self.pairs if pair[0] == method] for method in ("grid", "tree", "scan"))
        self.assertLessEqual(abs(len(grid) - 374), 0.02 * 374)  # projected by this machine's sine
        self.assertEqual(grid, tree)
        self.assertEqual(grid, scan)

    def test_the_refinement_lets_pairs_of_boxes_go_and_keeps_the_rows(self):
        before, after = map(int, self.refined)
        self.assertGreater(before, 1.05 * after)
        self.assertEqual(after, sum(pair[0] == "grid" for pair in self.pairs))


if __name__ == "__main__":
    main()
