"""python3 -m foresee feed with real parts: files, gpsdecode, a broker that goes away; killed at random it loses nothing.

FORESEE_LONG=1 kills it a hundred times in place of a handful.
"""
import json
import random
import shutil
import threading
import time
import unittest

from hosts import main, skip
from live import LONG, NEW_YORK, START, Broker, Command, ForgetfulBroker, Live, made_up_report, totals, waited

KILLS = 50 if LONG else 3       # of each of the two sources

NMEA = r"""!AIVDM,1,1,,B,15M67FC000G?ufbE`FepT@3n00Sa,0*5C
\c:1641168000*5A\!AIVDM,1,1,,A,13HOI:0P0000VOHLCnHQKwvL05Ip,0*23
!AIVDM,1,1,,A,13HOI:0P0000VOHLCnHQKwvL05Ip,0*24
rubbish
!AIVDM,2,1,3,B,55P5TL01VIaAL@7WKO@mBplU@<PDhh000000001S;AJ::4A80?4i@E53,0*3E
!AIVDM,2,2,3,B,1@0000000000000,2*55
"""


def csv_of(reports):
    return "mmsi,t,lat,lon,sog,cog\n" + "".join(",".join(map(repr, report)) + "\n" for report in reports)


def json_of(report):
    return json.dumps(dict(zip(("mmsi", "t", "lat", "lon", "sog", "cog"), report)))


class StandardInput(Live):
    def feed(self, text, *options, fails=False):
        return self.command("feed", self.file, "--table", "ships", *options, text=text, fails=fails)[1].splitlines()

    def test_the_bundled_file_becomes_ships_in_degrees(self):
        errors = self.feed(NEW_YORK.read_text(), "--watch", "alerts")
        lines, stored, older, left_out, bad = totals(errors)
        self.assertEqual((lines, bad), (3066, 0))                  # the header is a line
        self.assertEqual(stored + older + left_out, 3065)
        db = self.database()
        self.assertEqual(db.execute("SELECT frame, speed_unit, objects FROM foresee_tables WHERE name = 'ships'").fetchall(),
                         [("degrees", "knots", 237)])
        self.assertEqual(db.execute("SELECT name FROM ships WHERE id = 367061610").fetchall(), [("IVORY WILLET",)])
        self.assertEqual(db.execute("SELECT name, horizon, within, ahead FROM predictive_watches").fetchall(), [("alerts", 600, 926, 300)])
        # No pair of moored ships.
        self.assertEqual(db.execute("SELECT count(*) FROM alerts w JOIN ships a ON a.id = w.a JOIN ships b ON b.id = w.b "
                                    "WHERE a.speed = 0 AND b.speed = 0").fetchone(), (0,))
        self.assertGreater(db.execute("SELECT count(*) FROM alerts").fetchone()[0], 20)

    def test_json_and_csv_give_the_same_ships(self):
        reports = [made_up_report(i, 10) for i in range(40)]
        self.feed("".join(json_of(report) + "\n" for report in reports))
        self.assert_holds(reports)
        self.feed(csv_of(reports))
        self.assert_holds(reports)

    def test_times_of_every_form(self):
        forms = [1641168000, 1641168000000, 1641168000000000, 1641168000000000000, "1641168000", "2022-01-03T00:00:00", "2022-01-03T00:00:00Z",
                 "2022-01-03 00:00:00 UTC", "2022-01-03T01:00:00+01:00", "2022-01-03T00:00:00.0000000Z", "03/01/2022 00:00:00",
                 "20220103000000", "20220103T000000Z"]
        self.feed("".join(json.dumps({"mmsi": i, "timestamp": t, "lat": 53, "lon": 7, "sog": 5, "cog": 5}) + "\n" for i, t in enumerate(forms, 1)))
        self.assertEqual(self.database().execute("SELECT id, t FROM ships").fetchall(), [(i, START) for i in range(1, len(forms) + 1)])

    def test_files_of_noaa_and_dma(self):
        noaa = ("MMSI,BaseDateTime,LAT,LON,SOG,COG,Heading,VesselName\n1,2022-01-03T00:00:00,53.5,7.5,11.0,215.5,215,ANNA\n"
                "2,2022-01-03T00:00:00,53.6,7.5,0.3,360.0,511,\n3,2022-01-03T00:00:00,53.6,7.5,8.0,360.0,511,\n")
        later = ("mmsi,base_date_time,longitude,latitude,sog,cog,heading,vessel_name\n1,2022-01-03 00:00:00,7.5,53.5,11.0,215.5,215,ANNA\n"
                 "2,2022-01-03 00:00:00,7.5,53.6,0.3,360.0,511,\n")
        dma = ("# Timestamp,Type of mobile,MMSI,Latitude,Longitude,Navigational status,ROT,SOG,COG,Heading,IMO,Callsign,Name\n"
               "03/01/2022 00:00:00,Class A,1,53.5,7.5,Under way using engine,0.0,11.0,215.5,215,Unknown,Unknown,ANNA\n"
               "03/01/2022 00:00:00,Class B,2,53.6,7.5,Unknown value,,0.3,,,Unknown,Unknown,\n"
               "03/01/2022 00:00:00,Base Station,4,53.6,7.5,Unknown value,,0.0,,,Unknown,Unknown,\n")
        for table, text in (("a", noaa), ("b", later), ("c", dma)):
            self.command("feed", self.file, "--table", table, "--origin", "53.5,7.5", text=text)
            rows = self.database().execute(f"SELECT id, t, round(lat, 8), round(lon, 8), round(speed, 8), round(course, 6), name FROM {table} "
                                           "ORDER BY id").fetchall()
            self.assertEqual(rows, [(1, START, 53.5, 7.5, 11, 215.5, "ANNA"), (2, START, 53.6, 7.5, 0, None, None)], table)

    def test_help_shows_examples(self):
        for command in ("feed", "alerts", "map"):
            self.assertIn(f"python3 -m foresee {command} fleet.db", self.command(command, "--help")[0])

    def test_bad_lines_are_named_and_end_nothing(self):
        good = [made_up_report(i, 3) for i in range(3)]
        text = csv_of(good).splitlines()
        text[2:2] = ["1,2", "x,1641168000,53,7,5,5", "4,then,53,7,5,5", "4,1641168000,95,7,5,5", "4,1641168000,53,7,-5,5", "4,1641168000,91,181,5,5",
                     "4,nan,53,7,5,5"]
        errors = self.feed("\n".join(text))
        for number, message in ((3, "2 values, and the header has 6 columns"), (4, "the ship's number is 'x', not a number"),
                                (5, "the time is 'then'"), (6, "the latitude is 95, not within 90 degrees"), (7, "the speed is -5, less than 0"),
                                (9, "the time (t) is missing")):
            self.assertTrue(any(f"line {number}: {message}" in line for line in errors), (number, message, errors))
        self.assertEqual(totals(errors), (11, 3, 0, 1, 6))
        self.assert_holds(good)

    def test_hostile_lines_are_bad_lines(self):
        good = [made_up_report(i, 3) for i in range(3)]
        text = csv_of(good).splitlines()
        text[2:2] = ["4,1641168000,53,7,5,5\r6", "4,1641168000,53,7,5," + "5" * 200_000, "1" * 400 + ",1641168000,53,7,5,5"]
        errors = self.feed("\n".join(text))
        self.assertEqual(totals(errors), (7, 3, 0, 0, 3))
        self.assert_holds(good)
        start = '{"mmsi": 4, "t": 1641168000, "lat": 53, "lon": 7, "sog": 5, "cog": 5'
        lines = [json_of(good[0]), "[" * 100_000, '{"a":' * 100_000, start.replace("53", "1" + "0" * 400) + "}",
                 start.replace("1641168000", '"0001-01-01T00:00:00+14:00"') + "}", start + ', "name": "\\ud800 ANNA"}', json_of(good[1]),
                 *(start.replace(" 4", f" {id}", 1) + "}" for id in ("true", '"1_0"', 2**63 + 1, 2**53 + 1))]
        errors = self.command("feed", self.folder / "other.db", "--table", "ships", text="\n".join(lines))[1]
        for message in ("true, not a number", "'1_0', not a number", "9223372036854775809, more than 9007199254740991; an MMSI has nine"):
            self.assertIn(f": the ship's number is {message}", errors)
        self.file = self.folder / "other.db"
        names = dict(self.database().execute("SELECT id, name FROM ships").fetchall())
        self.assertEqual((names[4], len(names)), ("? ANNA", 3))

    def test_what_the_table_refuses_is_a_bad_line(self):
        self.database().execute("CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy)")
        good = (1, START, 54.0, 8.0, 10.0, 90.0)
        errors = self.feed(csv_of([good, (2, START, -54.0, -172.0, 10.0, 90.0)]), "--origin", "54 8")
        self.assertTrue(any("ship 2: geo_to_plane: lat, lon are -54, -172: opposite the origin" in line for line in errors), errors)
        self.assertEqual(totals(errors)[4], 1)
        self.assertEqual(self.database().execute("SELECT id FROM ships").fetchall(), [(1,)])

    def test_damage_of_the_table_ends_the_feed(self):
        self.feed(csv_of([made_up_report(i, 1) for i in range(3)]))
        with self.database() as db:
            node, data = db.execute("SELECT nodeno, data FROM ships_node ORDER BY nodeno LIMIT 1").fetchone()
            db.execute("UPDATE ships_node SET data = ? WHERE nodeno = ?", (data[:40] + bytes([data[40] ^ 1]) + data[41:], node))
        errors = self.feed(csv_of([made_up_report(i, 2) for i in range(3)]), fails=True)
        self.assertIn("is damaged", errors[-1])
        self.assertFalse(any("bad" in line for line in errors), errors)

    def test_the_case_of_a_name_and_an_empty_first_line_do_not_matter(self):
        first, more = made_up_report(0, 1), made_up_report(1, 1)
        text = "\n" + csv_of([first])
        self.feed(text)
        errors = self.command("feed", self.file, "--table", "SHIPS", "--resume", text=text + csv_of([more]).split("\n", 1)[1])[1]
        self.assertIn("going on after line 3", errors)
        self.assertEqual(self.database().execute("SELECT count(*) FROM foresee_feed").fetchone(), (1,))
        self.assertEqual(self.database().execute("SELECT count(*) FROM ships").fetchone(), (1 + (more[0] != first[0]),))

    def test_ships_that_are_too_far_are_named_once_and_counted(self):
        good = [made_up_report(0, 1)]
        errors = self.feed(csv_of([*good, *((5 + i, START, -33.9, 151.2, 5.0, 5.0) for i in range(30))]))
        self.assertEqual(len(errors), 2, errors)
        self.assertRegex(errors[0], r"ship 5: 1\d+ km from the origin '53\.9 7\.8', the limit is 1500 km; .* --origin 'LAT LON' places a new table$")
        self.assertIn(", 0 bad, 30 too far from the origin; ", errors[1])
        self.assert_holds(good)

    def test_an_older_report_does_not_replace_a_newer_one(self):
        newer, older = made_up_report(5, 1), made_up_report(3, 1)
        self.assertEqual(totals(self.feed(csv_of([newer, older])))[1:3], (1, 1))
        self.assert_holds([newer])

    def test_a_report_without_a_position_is_not_an_older_one(self):
        errors = self.feed("mmsi,t,lat,lon,sog,cog,name\n1,1641168000,53,7,5,5,ANNA\n2,1641168000,91,7,5,5,BRUNO\n3,1641168000,53,7,102.3,360,\n")
        self.assertEqual(totals(errors), (4, 1, 0, 2, 0))

    def test_a_name_that_came_once_is_kept(self):
        self.feed("mmsi,t,lat,lon,sog,cog,name\n1,10,53,7,5,5,ANNA\n1,20,53,7,5,5,\n")
        self.assertEqual(self.database().execute("SELECT t, name FROM ships").fetchall(), [(20, "ANNA")])

    def test_a_plain_table_needs_an_origin(self):
        self.database().execute("CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy)")
        self.assertIn("write --origin 'LAT LON'", self.feed("", fails=True)[-1])
        self.feed("mmsi,t,lat,lon,sog,cog\n1,10,54,8,36,90\n", "--origin", "54 8")
        row = self.database().execute("SELECT round(x, 6), round(y, 6), round(vx * 3600 / 1852, 6), round(vy, 6) FROM ships").fetchone()
        self.assertEqual(row, (0, 0, 36, 0))

    def test_errors_are_one_line(self):
        for options, text, message in ((("--table", "ships"), "a,b\n", "the first line has no column for the ship (mmsi), the time"),
                                       (("--table", "foresee_feed"), "", "foresee_feed is not a table of moving objects"),
                                       (("--table", "ships", "--mqtt", "http://x/"), "", "http: no address of a broker"),
                                       (("--table", "ships", "--mqtt", "mqtt://127.0.0.1:99999/x"), "", "mqtt: no address of a broker")):
            with self.subTest(message):
                errors = self.command("feed", self.file, *options, text=text, fails=True)[1]
                self.assertEqual(errors.count("\n"), 1, errors)
                self.assertIn(f"foresee feed: {message}", errors)

    def test_a_wrong_option_is_one_line_and_status_2(self):
        for arguments, message in (((), "foresee: the following arguments are required: feed | alerts | map; see python3 -m foresee --help"),
                                   (("feed", "a.db"), "foresee feed: the following arguments are required: --table; see python3 -m foresee feed --help"),
                                   (("feed", "a.db", "--table", "ships", "--a\nb"), "foresee feed: unrecognized arguments: --a b; see "),
                                   (("feed", "a.db", "--table", ""), "foresee feed: argument --table: the name is empty; write for example ships; see "),
                                   (("alerts", "a.db", "alerts", "--poll", "0"), "foresee alerts: argument --poll: invalid "),
                                   (("map", "a.db", "--zoom"), "foresee map: unrecognized arguments: --zoom; see python3 -m foresee map --help"),
                                   (("map", "a.db", "--port", "65536"), "foresee map: argument --port: invalid port value: '65536'; see "),
                                   (("map", "a.db", "--port", "y"), "foresee map: argument --port: invalid port value: 'y'; see ")):
            with self.subTest(arguments):
                command = Command(self, *arguments)
                self.assertEqual((command.finish(), len(command.errors)), (2, 1), command.errors)
                self.assertIn(message, command.errors[0])

    def test_sentences_of_a_receiver(self):
        if shutil.which("gpsdecode") is None:
            skip("feed of NMEA sentences", "there is no gpsdecode (gpsd-clients)")
        before = time.time()
        self.command("feed", self.file, "--table", "ships", text="mmsi,t,lat,lon,sog,cog\n369190000,10,50,0,5,5\n")
        errors = self.feed(NMEA)
        self.assertTrue(any("line 3: the checksum is wrong" in line for line in errors), errors)
        self.assertTrue(any("line 4: no AIS sentence: 'rubbish'" in line for line in errors), errors)
        rows = dict((row[0], row[1:]) for row in self.database().execute("SELECT id, t, round(lat, 5), round(lon, 5), name FROM ships"))
        self.assertEqual(rows[227006760], (1641168000, 49.47558, 0.13138, None))
        self.assertEqual(rows[369190000][3], "MT.MITCHELL")
        # The other one is off California, more than 1,500 km from the origin that the first report gave.
        self.assertTrue(any("ship 366053209: " in line for line in errors), errors)
        self.assertLess(before, time.time())

    def test_killed_at_random_it_goes_on_after_the_last_committed_line(self):
        # A ship per line: a line that is left out is a ship that is missing.
        count, chance, resumed = 40_000, random.Random(37), []
        reports = [made_up_report(i, count) for i in range(count)]
        path = self.write("reports.csv", csv_of(reports))
        for kill in range(KILLS + 1):
            with path.open() as stdin:
                feed = Command(self, "feed", self.file, "--table", "ships", "--resume", stdin=stdin)
                waited(lambda: feed.said("going on after line") or feed.process.poll() is not None, what="the feed")
                resumed += [int(line.rsplit(" ", 1)[1]) for line in feed.errors if "going on after line" in line]
                if kill < KILLS:
                    time.sleep(chance.uniform(0.0, 0.25))
                    ended = feed.process.poll() is not None
                    feed.kill()
                else:
                    self.assertEqual(feed.finish(), 0)
            if kill == KILLS or ended:
                self.assertEqual(self.database().execute("SELECT line FROM foresee_feed").fetchone(), (count + 1,))
                self.assert_holds(reports)
                self.database().executescript("DELETE FROM ships; UPDATE foresee_feed SET line = 1")      # all over again
        inside = sum(1 < line <= count for line in resumed)
        self.assertGreater(inside, 0, "no kill came between two commits")
        print(f"{KILLS} kills of a feed from standard input, {inside} between two commits: nothing lost")


class OverMqtt(Live):
    def start(self, *options):
        feed = Command(self, "feed", self.file, "--table", "ships", "--mqtt", self.broker.url, *options)
        waited(lambda: feed.said("connected to 127.0.0.1") or feed.process.poll() is not None, what="the connection")
        return feed

    def stored(self):
        row = self.database().execute("SELECT messages FROM foresee_feed").fetchone()
        return row[0] if row else 0

    def all_at(self, t, ships):
        """Have all the ships reported at t?"""
        return [row[0] for row in self.positions().values()] == [t] * ships

    def test_a_broker_that_goes_away_and_comes_back(self):
        self.broker = Broker(self)
        feed = self.start()
        waited(lambda: self.file.exists() and self.database().execute("SELECT 1 FROM sqlite_master WHERE name = 'ships'").fetchone())
        reports = [made_up_report(i, 50) for i in range(150)]
        self.broker.publish((f"ais/{report[0]}", json_of(report)) for report in reports[:100])
        waited(lambda: self.stored() >= 100, what="the first hundred")
        self.broker.stop()
        waited(lambda: feed.said("no connection to 127.0.0.1"), what="the attempts to connect")
        self.broker.start()
        waited(lambda: sum("connected to" in line for line in feed.errors) == 2, what="the second connection")
        # A message without a number takes that of its topic; bad ones are named by their topic.
        no_number = {key: value for key, value in json.loads(json_of(reports[-1])).items() if key != "mmsi"}
        self.broker.publish([("ais/x", "{"), *((f"ais/{report[0]}", json_of(report)) for report in reports[100:-1]),
                             (f"ais/{reports[-1][0]}/location", json.dumps(no_number))])
        waited(lambda: feed.said("ais/x: no JSON") and self.all_at(START + 2, 50), what="the rest")
        self.assertEqual(feed.end(), 0)
        self.assert_holds(reports)

    def test_killed_at_random_it_loses_no_message(self):
        self.kill_at_random("")

    def test_killed_at_random_with_a_broker_that_waits_for_no_acknowledgement(self):
        self.kill_at_random("max_inflight_messages 0\n")

    def kill_at_random(self, settings):
        self.broker = Broker(self, settings)
        chance, ships, count = random.Random(73), 400, 200 * 400 if LONG else 15 * 400
        reports = [made_up_report(i, ships) for i in range(count)]
        feed = self.start()                 # the session is there from now on
        publisher = threading.Thread(target=self.broker.publish, args=([(f"ais/{report[0]}", json_of(report)) for report in reports],))
        publisher.start()
        for _ in range(KILLS):
            time.sleep(chance.uniform(0.0, 0.3))
            feed.kill()
            feed = self.start()
        publisher.join()
        waited(lambda: self.all_at(reports[-1][1], ships), 120, "the last message")
        time.sleep(0.3)
        self.assertEqual(feed.end(), 0)
        self.assert_holds(reports[-ships:])
        self.assertEqual(self.stored(), count)
        print(f"{KILLS} kills of a feed over MQTT: {count} messages, none lost, none stored twice")

    def test_a_message_that_comes_again_changes_nothing(self):
        first, moved, other = (json_of(made_up_report(i, 1)) for i in (0, 1, 2))
        no_time = json.dumps({"mmsi": 7, "lat": 53.9, "lon": 7.8, "sog": 5, "cog": 5})
        self.broker = ForgetfulBroker(self, [
            [(1, False, first), (2, False, no_time)],
            [(1, True, first), (2, True, no_time), (3, False, moved)],          # two come again, one is new
            [(3, True, other), (1, False, first)]])                             # the identifiers of others, for new messages
        feed = self.start()
        waited(lambda: self.stored() >= 5, what="the third connection")
        self.assertEqual(feed.end(), 0)
        self.assertEqual(self.stored(), 5)
        self.assertIn(", 2 sent again; ", feed.errors[-1])
        self.assertEqual(self.positions()[211000000][0], START + 2)

    def test_only_the_last_messages_are_kept(self):
        self.broker = Broker(self)
        feed = self.start()
        self.broker.publish((f"ais/{i}", json_of(made_up_report(i, 50))) for i in range(6000))
        waited(lambda: self.stored() == 6000, 60, "the messages")
        self.assertEqual(feed.end(), 0)
        self.assertEqual(self.database().execute("SELECT count(*), count(DISTINCT session) FROM foresee_messages").fetchone(), (5000, 1))


if __name__ == "__main__":
    main()
