"""What foresee_dask takes for shards: tables, CSV and Parquet; which time is `now`, and how names are written."""
import re
import sqlite3
import sys
from contextlib import closing

from fleet import EXTENSION, SHIPS, Fleet, here, main, ships, skip
from hosts import ROOT

from foresee_dask import plan as plans, tile_join
from foresee_dask.load import MOTION
from foresee_dask.question import Question

MOVERS = "id, x, y, plan, r"


def movers(count):
    """Objects with plans that start at 0, 2.5 or 60."""
    rows = []
    for i, t, x, y, vx, vy, *_ in ships(count):
        rows.append((i, None, None, f"LINESTRING M({x!r} {y!r} {t!r}, {x + 90 * vx!r} {y + 90 * vy!r} {t + 90!r})", 12))
    return rows


class Shards(Fleet):
    def plan(self, paths, count=8, question=Question("ships", 60.0), out=None):
        return plans.make(out or self.out, question, paths, EXTENSION, count, here)

    def check(self, plan, question, **tables):
        """The plan's tiles give the rows of the single join."""
        expected = self.single(question, **tables)
        self.assertGreater(len(expected), 20)
        for tile in plan.tiles:
            tile_join.all_of(plan, tile)
        self.assertEqual(self.of_tiles(plan.path("")), expected)

    def test_now_is_the_newest_of_all_shards(self):
        rows = ships(300)
        plan = self.plan([self.shard("old.db", ships=(SHIPS, [row for row in rows if row[1] < 60])),
                          self.shard("new.db", ships=(SHIPS, [row for row in rows if row[1] == 60]))])
        self.assertEqual(plan.question.now, 60.0)

    def test_now_is_the_newest_start_of_a_plan(self):
        rows, question = movers(300), Question("ships", 40.0)
        for name, paths in (("one", [self.shard("one.db", ships=(MOVERS, rows))]), ("three", self.shards(rows, 3, MOVERS))):
            plan = self.plan(paths, 5, question, self.folder / name)
            self.assertEqual(plan.question.now, 60.0)
            self.check(plan, question, ships=(MOVERS, rows))

    def test_now_of_empty_shards(self):
        empty = self.shard("empty.db", ships=(MOVERS, []), boats=("id, t, x, y", []))
        full = self.shard("full.db", ships=(MOVERS, movers(30)), boats=("id, t, x, y", [(1, -7, 0, 0)]))
        for number, (paths, table, now) in enumerate((([empty, full], "ships", 60.0), ([empty], "ships", 0.0), ([empty, full], "boats", -7.0),
                                                      ([empty], "boats", 0.0))):
            plan = self.plan(paths, 5, Question(table, 40.0), self.folder / f"{number}")
            self.assertEqual(plan.question.now, now)

    def test_tables_and_csv_become_shards(self):
        rows = ships(300)
        question = Question("ships", 60.0, now=60.0)
        plain = self.folder / "plain.db"
        with closing(sqlite3.connect(plain)) as db, db:
            db.execute("CREATE TABLE ships(name, Y, x, t, id, vx, vy, r)")
            db.executemany("INSERT INTO ships VALUES (?8, ?4, ?3, ?2, ?1, ?5, ?6, ?7)", rows[::3])
        text = self.folder / "text.csv"
        text.write_text("id,t,x,y,vx,vy,r,name\n" + "".join(",".join(map(repr, row[:7])) + ',"a, b"\n' for row in rows[1::3]))
        last = self.shard("last.db", ships=(SHIPS, rows[2::3]))
        for _ in range(2):
            plan = self.plan([plain, text, last], 4, question)
        for tile in plan.tiles:
            tile_join.all_of(plan, tile)
        self.assertEqual(self.of_tiles(), self.single(question, ships=(SHIPS, rows)))
        self.assertEqual(len(list((self.out / "shards").iterdir())), 2)

    def test_columns_of_motion_are_those_of_the_extension(self):
        words = re.findall(r'Word\{"(\w+)"', (ROOT / "ext/sqlite/table/column_vocabulary.cpp").read_text())
        self.assertEqual(set(MOTION), {"id", *words} - {"zone"})        # a table of zones needs an origin, which no CSV file has

    def test_parquet(self):
        try:
            import pyarrow
            import pyarrow.parquet
        except ImportError:
            skip("shards of Parquet", f"{sys.executable} has no pyarrow")
        rows = ships(200)
        columns = dict(zip(("id", "t", "x", "y", "vx", "vy", "r", "name"), zip(*rows)))
        pyarrow.parquet.write_table(pyarrow.table({name: list(column) for name, column in columns.items()}), self.folder / "a.parquet")
        question = Question("ships", 60.0, now=60.0)
        plan = self.plan([self.folder / "a.parquet"], 2, question)
        for tile in plan.tiles:
            tile_join.all_of(plan, tile)
        self.assertEqual(self.of_tiles(), self.single(question, ships=(SHIPS, rows)))

if __name__ == "__main__":
    main()
