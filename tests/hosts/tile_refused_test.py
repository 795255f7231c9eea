"""What foresee_dask refuses, in one line and status 1, before anything is lost: mixtures, damage, a full disk."""
import os
import shutil
import sqlite3
import subprocess
import sys
from contextlib import closing

from fleet import SHIPS, Fleet, environment, main, ships, skip

from foresee_dask.question import Question


class Refused(Fleet):
    """Each in one line; plan is what join begins with."""

    def setUp(self):
        super().setUp()
        self.rows = ships(60)

    def plan(self, *more, **options):
        return self.refused("plan", *self.asking(*more), **options)

    def test_one_id_in_two_shards(self):
        paths = [self.shard("a.db", ships=(SHIPS, self.rows[:30])), self.shard("b.db", ships=(SHIPS, self.rows[40:])),
                 self.shard("c.db", ships=(SHIPS, self.rows[29:41]))]
        said = self.plan(*paths)
        self.assertIn("ships: id 29 is in two shards: ", said)
        self.assertIn(str(paths[0]), said)
        self.assertIn(str(paths[2]), said)
        self.assertFalse((self.out / "plan.json").exists())

    def test_a_shard_given_twice(self):
        path = self.shard("a.db", ships=(SHIPS, self.rows))
        (self.folder / "b.db").symlink_to(path)
        self.assertIn(f"a shard is given twice: {path} and {self.folder}/b.db", self.plan(path, self.folder / "b.db"))

    def test_declarations_that_differ(self):
        said = self.plan(self.shard("a.db", ships=(SHIPS, [])), self.shard("b.db", ships=("id, x, y, r", [])))
        self.assertIn("a.db has (id, t, x, y, vx, vy, r)", said)
        self.assertIn("b.db has (id, x, y, r)", said)

    def test_plans_in_degrees(self):
        trips = "id, lat, lon, plan, origin = '54 8'", []
        self.assertIn("a.db: ships has plans in degrees, which several shards cannot join: write them in metres, by geo_to_plane, or",
                      self.plan(self.shard("a.db", ships=trips), self.shard("b.db", ships=trips)))

    def test_frames_that_differ(self):
        def shard(name, table="ships", *options):
            columns = "id, lat, lon, r" if "frame" not in "".join(options) else "id, x, y, r"
            return self.shard(name, **{table: (", ".join((columns, *options)), [(1, 54, 8, 5)])})

        said = self.plan(shard("a.db", "ships", "origin = '54 8'"), shard("b.db", "ships", "origin = '54.1 8'"))
        self.assertIn("coordinates do not match: ships of ", said)
        self.assertIn("a.db has origin '54 8', ships of ", said)
        self.assertIn("b.db has origin '54.1 8'; create all of them with one origin or frame", said)
        said = self.plan(shard("c.db", "ships", "frame = 'a'"), self.shard("d.db", ships=("id, x, y, r", [])))
        self.assertIn("c.db has frame 'a', ships of ", said)
        self.assertIn("d.db has no frame; ", said)
        said = self.plan("--other", "boats", shard("e.db", "ships", "origin = '54 8'"), shard("f.db", "boats"),
                         shard("g.db", "boats", "origin = '53 8'"))
        self.assertIn("ships of ", said)
        self.assertIn("boats of ", said)
        (self.folder / "h.csv").write_text("id,lat,lon\n1,54,8\n")
        self.assertIn("h.csv: x and y are needed; load lat, lon into a foresee file", self.plan(self.folder / "h.csv"))

    def test_a_missing_shard_and_what_is_none(self):
        there = self.shard("a.db", ships=(SHIPS, self.rows))
        self.assertIn("none.db cannot be opened: there is no such file", self.plan(there, self.folder / "none.db"))
        (self.folder / "text.db").write_text("no database, but long enough to be looked at" * 100)
        self.assertIn("text.db cannot be read: file is not a database", self.plan(there, self.folder / "text.db"))
        self.assertIn("other.db has no moving_objects table ships", self.plan(there, self.shard("other.db", boats=(SHIPS, []))))
        damaged = self.shard("damaged.db", ships=(SHIPS, self.rows))
        with closing(sqlite3.connect(damaged)) as db, db:
            db.execute("UPDATE ships_node SET data = zeroblob(length(data))")
        self.assertIn("damaged.db cannot be read: ", self.plan(there, damaged))
        (self.folder / "a.csv").write_text("id,x,y\n1,2\n")
        self.assertIn("a.csv: a row has fewer values", self.plan(self.folder / "a.csv"))
        (self.folder / "b.csv").write_text("id,x,y\n1,east,2\n")
        self.assertIn("b.csv: ", self.plan(self.folder / "b.csv"))
        self.assertIn("c.csv: id and x are needed", (self.folder / "c.csv").write_text("a,b\n") and self.plan(self.folder / "c.csv"))

    def test_a_question_that_is_wrong(self):
        path = self.shard("a.db", ships=(SHIPS, self.rows))
        self.assertIn("columns: no such column: speed", self.plan(path, "--columns", "speed"))
        self.assertIn("has no column +flag", self.plan(path, "--columns", "a.flag"))
        self.assertIn("within_z is for tables with x, y and z", self.plan(path, "--within-z", "5"))
        self.assertIn("within must be a finite number >= 0", self.plan(path, "--within=-5"))
        self.assertIn("no shard has a moving_objects table crates", self.plan(path, "--other", "crates"))

    def test_another_answer_in_the_folder(self):
        path = self.shard("a.db", ships=(SHIPS, self.rows))
        again = self.shard("b.db", ships=(SHIPS, [(1000, 0, 0, 0, 0, 0, 1, None)]))
        self.assertEqual(self.command("plan", *self.asking(path)).returncode, 0)
        self.assertEqual(self.command("plan", *self.asking(path)).returncode, 0)
        self.assertIn("holds another answer: horizon is 60.0 there and 61.0 here", self.refused("plan", *self.asking(path, horizon=61)))
        self.assertIn("now is not given there and 5.0 here", self.plan(path, "--now", "5"))
        self.assertIn(f"shard {again} is here and not there", self.plan(path, again))
        file = self.out / "plan.json"
        written = file.read_text()
        file.write_text(written.replace("Commit: ", "Commit: 0"))
        self.assertIn("the extension is Version: ", self.plan(path))
        self.assertIn("one commit for all", self.refused(self.out, before=("-m", "foresee_dask.tile_join")))
        file.write_text(written)
        with closing(self.open(path)) as db:
            db.execute("DELETE FROM ships WHERE id = 7")
        self.assertIn(f"shard {path} has changed since", self.plan(path))
        self.assertIn("has changed since the run began", self.refused(self.out, before=("-m", "foresee_dask.tile_join")))

    def test_files_of_two_answers_are_not_mixed(self):
        path = self.shard("a.db", ships=(SHIPS, self.rows))
        for out, horizon in ((self.out, 60), (self.folder / "b", 61)):
            self.assertEqual(self.command("plan", *self.asking(path, out=out, horizon=horizon)).returncode, 0)
        self.assertEqual(self.command(self.out, "00000", before=("-m", "foresee_dask.tile_join")).returncode, 0)
        shutil.copy(self.out / "pairs-00000.db", self.folder / "b")
        self.assertIn("is of another answer", self.refused(self.folder / "b", before=("-m", "foresee_dask.tile_join")))
        self.assertIn("is not whole", self.refused("merge", self.out, self.folder / "all.db"))
        (self.out / "plan.json").unlink()
        self.assertIn("holds pairs and no plan.json", self.plan(path))
        self.assertFalse((self.folder / "all.db").exists())

    def test_an_extension_that_does_not_load(self):
        path = self.shard("a.db", ships=(SHIPS, self.rows))
        said = self.refused("plan", "--extension", self.folder / "none.so", "--table", "ships", "--horizon", 60, "--out", self.out, path)
        self.assertIn("none.so cannot be loaded on ", said)

    def test_a_python_without_extensions(self):
        program = ("import runpy, sqlite3\n"
                   "class Connection:\n    def __init__(self, *given, **options): pass\n"
                   "sqlite3.connect = Connection\nrunpy.run_module('foresee_dask', run_name='__main__')")
        said = self.refused("plan", *self.asking(self.shard("a.db", ships=(SHIPS, self.rows))), before=("-c", program))
        self.assertIn("cannot load extensions into SQLite: write /usr/bin/python3", said)

    def test_a_full_disk(self):
        small, rows = self.folder / "small", ships(2000)
        small.mkdir()
        path = self.shard("a.db", ships=(SHIPS, rows))
        question = Question("ships", 60.0, within=200.0, now=60.0)
        asked = " ".join(map(str, self.asking("--tiles", "1", "--within", "200", path, out=small)))
        tile = f"{sys.executable} -m foresee_dask.tile_join {small}"
        (self.folder / "script").write_text(f"""mount -t tmpfs -o size=64k tmpfs {small} || exit 99
            {sys.executable} -m foresee_dask plan {asked}
            {tile}
            echo $? $(ls -A {small})
            mount -o remount,size=64m {small} && {tile} && {sys.executable} -m foresee_dask merge {small} {self.folder}/all.db""")
        done = subprocess.run(["unshare", "-rm", "sh", self.folder / "script"], text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              env=environment(), timeout=120) if shutil.which("unshare") else None
        if done is None or (done.returncode != 0 and not done.stdout):
            skip("a full disk", "a small file system cannot be mounted here")
        expected = self.single(question, ships=(SHIPS, rows))
        self.assertEqual(done.stderr, f"foresee_dask: no room on disk for {small}/pairs-00000.db: database or disk is full\n")
        self.assertEqual(done.stdout.splitlines(), ["00000", "1 plan.json", f"00000: {len(expected)} rows",
                                                    f"{len(expected)} rows in {self.folder}/all.db"])
        with closing(sqlite3.connect(self.folder / "all.db")) as db:
            self.assertEqual(db.execute("SELECT * FROM pairs").fetchall(), expected)


if __name__ == "__main__":
    main()
