"""python3 -m foresee alerts with real parts: lines of a watch that changes; killed at random it misses nothing and keeps the order.

FORESEE_LONG=1 kills it fifty times in place of a handful.
"""
import json
import random
import subprocess
import time

from hosts import main
from live import LONG, PYTHON, Command, WatchedShips, waited

KILLS = 50 if LONG else 3


class Alerts(WatchedShips):
    def test_a_line_per_change_with_names_tcpa_cpa_and_place(self):
        first = self.alerts()
        self.assertEqual(len(first), 1, first)
        # Half a nautical mile is at the end of the horizon, the closest approach two minutes later.
        self.assertRegex(first[0], r"^1970-01-01 00:00:10  \+  ANNA, DORA  TCPA 10\.\d min  CPA \d\d\d m  53\.9\d\d\d N 7\.9\d\d\d E$")
        self.assertEqual(self.alerts(), [])
        self.report("1,70,53.99,7.8612,14,91,ANNA\n2,70,53.985,7.9935,12,272,BRUNO\n")
        self.assertEqual([line.split("  ")[1:3] for line in self.alerts()], [["+", "ANNA, BRUNO"], ["~", "ANNA, DORA"]])
        self.report("1,80,53.99,7.8612,0,0,ANNA\n")
        lines = self.alerts()
        self.assertEqual([line.split("  ")[1:3] for line in lines], [["-", "ANNA, BRUNO"], ["-", "ANNA, DORA"]])
        self.assertTrue(all(line.endswith("  over") for line in lines))

    def test_json_has_what_the_watch_has(self):
        change, = (json.loads(line) for line in self.alerts("--json"))
        row = self.database().execute("SELECT w.a, w.b, w.t, j.t_cpa, j.d_cpa, w.now FROM alerts w, predictive_join(4200, 'ships', 926) j "
                                      "WHERE j.now = w.now AND j.a = w.a AND j.b = w.b").fetchone()
        self.assertEqual((change["a"], change["b"], change["t"], change["cpa_m"], change["now"]), row[:3] + row[4:])
        self.assertEqual(change["tcpa_min"], (row[3] - row[5]) / 60)
        self.assertEqual((change["op"], change["a_name"], change["b_name"], change["near"]), ("+", "ANNA", "DORA", False))
        there = self.database().execute("SELECT g.lat, g.lon FROM predictive_position(?, 'ships') p, plane_to_geo(p.x, p.y, 0, 0, 54, 8) g "
                                        "WHERE p.id = 1", (row[3],)).fetchone()
        self.assertAlmostEqual(change["lat"], there[0], delta=1e-8)
        self.assertAlmostEqual(change["lon"], there[1], delta=1e-8)

    def test_a_zone_has_a_time_of_entry_in_place_of_cpa(self):
        db = self.database()
        db.execute("CREATE VIRTUAL TABLE zones USING moving_objects(id, zone, +name TEXT, origin = '54 8')")
        db.execute("INSERT INTO zones VALUES (1, 'POLYGON((7.9 53.9, 7.95 53.9, 7.95 54, 7.9 54, 7.9 53.9))', 'reserve')")
        db.execute("CREATE VIRTUAL TABLE fence USING predictive_watch(ships, horizon = 1800, other = zones)")
        lines = self.command("alerts", self.file, "fence", "--once")[0].splitlines()
        self.assertRegex(lines[0], r"^1970-01-01 00:00:10  \+  ANNA, reserve  inside in 7\.6 min  53\.989\d N 7\.9000 E$")
        self.assertRegex(lines[-1], r"^1970-01-01 00:00:10  \+  DORA, reserve  inside  53\.9875 N 7\.9200 E$")
        change = json.loads(self.command("alerts", self.file, "fence", "--once", "--from-start", "--json")[0].splitlines()[0])
        t, = db.execute("SELECT t FROM fence WHERE a = 1").fetchone()
        self.assertEqual((change["entry_min"], change["tcpa_min"], change["cpa_m"]), ((t - 10) / 60, None, None))
        db.execute("CREATE VIRTUAL TABLE near USING predictive_watch(ships, horizon = 60, other = zones, within = 3000)")
        lines = self.command("alerts", self.file, "near", "--once")[0].splitlines()
        self.assertTrue(any("BRUNO, reserve  within 3000 m in 0." in line for line in lines), lines)

    def test_news_leaves_out_what_is_near_already(self):
        self.report("4,10,53.99,7.8505,14,91,ELSE\n")                # beside Anna
        self.assertEqual([line.split("  ")[2] for line in self.alerts("--news", "--reader", "news")], ["DORA, ELSE", "ANNA, DORA"])
        self.assertEqual(len(self.alerts()), 3)

    def test_readers_have_positions_of_their_own(self):
        self.assertEqual(self.alerts("--reader", "bridge"), self.alerts("--reader", "office"))
        self.assertEqual(self.alerts("--reader", "bridge"), [])
        self.assertEqual(len(self.alerts("--reader", "bridge", "--from-start")), 1)

    def test_a_watch_that_was_made_again_is_read_from_its_start(self):
        for t in range(20, 30):
            self.report(f"1,{t},53.99,7.85,14,{91 if t % 2 else 271},ANNA\n")
        self.alerts()
        db = self.database()
        db.execute("DROP TABLE alerts")
        db.execute("CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 600, within = 926)")
        out, errors = self.command("alerts", self.file, "alerts", "--once")
        self.assertIn("the whole watch follows", errors)
        self.assertEqual(len(out.splitlines()), 1)

    def test_a_watch_that_was_made_again_is_another_one_at_any_position(self):
        self.assertEqual(len(self.alerts()), 1)
        db = self.database()
        db.execute("DROP TABLE alerts")
        db.execute("CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 900, within = 5000)")
        out, errors = self.command("alerts", self.file, "ALERTS", "--once")     # a name in other letters is the same reader
        self.assertIn("alerts was created again: the whole watch follows", errors)
        self.assertEqual(len(out.splitlines()), 3)
        # A reader of an older version has no number of its watch.
        db.execute("ALTER TABLE foresee_readers DROP COLUMN created")
        self.assertEqual(len(self.alerts()), 3)
        self.assertEqual(self.command("alerts", self.file, "alerts", "--once"), ("", ""))

    def test_errors_are_one_line(self):
        for arguments, message in (((self.file, "nowhere"), "there is no watch nowhere; watches here: alerts"),
                                   ((self.folder / "gone.db", "alerts"), "there is no file"),
                                   ((self.file, "alerts", "--webhook", "ftp://x"), "--webhook is no web address"),
                                   ((self.file, "alerts", "--webhook", "http://a:b/"), "--webhook is no web address")):
            with self.subTest(message):
                errors = self.command("alerts", *arguments, fails=True)[1]
                self.assertEqual(errors.count("\n"), 1, errors)
                self.assertIn(f"foresee alerts: {message}", errors)

    def test_a_reader_of_the_lines_that_has_enough_ends_it(self):
        self.report("".join(f"{i},10,53.99,{7.85 + i / 1e4},14,91,S{i}\n" for i in range(10, 200)))
        shown = subprocess.run(f"{PYTHON} -m foresee alerts {self.file} alerts | head -1", shell=True, cwd=self.folder, env=self.environment,
                               text=True, capture_output=True, timeout=60)
        self.assertEqual((shown.stdout.count("\n"), shown.stderr), (1, ""))

    def test_killed_at_random_it_misses_no_line(self):
        chance, out = random.Random(41), self.folder / "alerts.jsonl"
        self.alerts()                                                # a position, from which on nothing may be missed
        start = self.published(0)[0]
        thread, runs, before = self.write_changes(8000 if LONG else 800, 0.001), [], 0
        for _ in range(KILLS):
            with out.open("a") as stdout:
                reader = Command(self, "alerts", self.file, "alerts", "--json", stdout=stdout)
                size = out.stat().st_size
                waited(lambda: out.stat().st_size > size or not thread.is_alive())
                time.sleep(chance.uniform(0.0, 0.1))
                reader.kill()
            runs.append([json.loads(line)["seq"] for line in out.read_text().splitlines()[before:]])
            before += len(runs[-1])
        thread.join()
        runs.append([json.loads(line)["seq"] for line in self.alerts("--json")])
        seen = [seq for run in runs for seq in run]
        self.assert_nothing_missed(runs, self.published(start))
        print(f"{KILLS} kills of alerts: {len(set(seen))} changes, none missed, {len(seen) - len(set(seen))} repeated")


if __name__ == "__main__":
    main()
