"""python3 -m foresee feed: what it says of a watch, an origin, a time or a ship that is not as the options or the columns suggest."""
import json
import shutil
import time

from hosts import main, skip
from live import START, Live, totals

SHIPS = "mmsi,t,lat,lon,sog,cog\n1,{0},53.99,7.85,14,91\n2,{0},53.985,8.0,12,272\n"


def sentence(fields, tag=None):
    """An AIS sentence of (value, bits) pairs."""
    bits = "".join(f"{value & (1 << width) - 1:0{width}b}" for value, width in fields)
    bits += "0" * (-len(bits) % 6)
    numbers = [int(bits[i:i + 6], 2) for i in range(0, len(bits), 6)]
    body = f"AIVDM,1,1,,A,{''.join(chr(number + 48 + 8 * (number > 39)) for number in numbers)},0"
    total = 0
    for character in body:
        total ^= ord(character)
    return (f"\\c:{tag}*00\\" if tag else "") + f"!{body}*{total:02X}"


def position(ship, t, lat, lon):
    return sentence([(1, 6), (0, 2), (ship, 30), (0, 4), (-128, 8), (100, 10), (0, 1), (round(lon * 600000), 28), (round(lat * 600000), 27),
                     (900, 12), (511, 9), (0, 6), (0, 2), (0, 3), (0, 1), (0, 19)], t)


def binary_message(ship, t):
    return sentence([(8, 6), (0, 2), (ship, 30), (0, 2), (200, 10), (10, 6), (0, 48)], t)


class FeedWatch(Live):
    def feed(self, text, *options, fails=False):
        return self.command("feed", self.file, "--table", "ships", *options, text=text, fails=fails)[1].splitlines()

    def watch(self, columns="now, pairs, early"):
        return self.database().execute(f"SELECT {columns} FROM predictive_watches").fetchall()

    def test_the_watch_goes_on_after_a_pause_that_is_longer_than_ahead(self):
        self.feed(SHIPS.format(START), "--watch", "alerts", "--horizon", "700")
        self.feed(SHIPS.format(START + 7200), "--watch", "alerts")
        self.assertEqual(self.watch(), [(START + 7200, 1, 2)])

    def test_a_ship_whose_clock_is_fast_does_not_end_the_others(self):
        self.feed(SHIPS.format(START), "--watch", "alerts", "--horizon", "700", "--forget", "900")
        self.feed(f"mmsi,t,lat,lon,sog,cog\n3,{START + 1700},53.5,7.5,5,5\n")
        self.assertEqual(self.watch(), [(START, 1, 1)])

    def test_reports_of_the_future_are_bad(self):
        now = round(time.time())
        lines = f"mmsi,t,lat,lon,sog,cog\n1,{now + 200},53.99,7.85,14,91\n2,{now + 1700},53.985,8.0,12,272\n"
        errors = self.feed(lines)
        self.assertRegex(errors[0], r"^foresee feed: ship 2: its report is 1\d\d\d s later than the clock of this machine, more than --future 300$")
        self.assertEqual(totals(errors), (3, 1, 0, 0, 1))
        self.assertEqual(totals(self.feed(lines, "--future", "1e9"))[1:], (2, 0, 0, 0))

    def test_a_watch_that_is_there_keeps_its_table_and_its_options(self):
        self.feed(SHIPS.format(START), "--watch", "alerts")
        errors = self.feed(SHIPS.format(START + 1), "--watch", "ALERTS", "--within", "5000", "--horizon", "600")
        self.assertEqual(errors[0], "foresee feed: ALERTS is there and has within = 926: --within is for a new watch")
        self.assertEqual(len(errors), 2, errors)
        errors = self.command("feed", self.file, "--table", "boats", "--watch", "alerts", text=SHIPS.format(START), fails=True)[1]
        self.assertEqual(errors, "foresee feed: alerts is a watch of ships, not of boats; write another name after --watch\n")
        self.assertEqual(self.database().execute("SELECT count(*) FROM sqlite_schema WHERE name = 'boats'").fetchone(), (0,))

    def test_the_name_of_a_table_is_no_watch(self):
        errors = self.feed("mmsi,t,lat,lon,sog,cog\n", "--watch", "ships", fails=True)
        self.assertEqual(errors[-1], "foresee feed: ships is a table, not a watch; write another name after --watch")

    def test_an_origin_is_for_a_new_table(self):
        self.feed(SHIPS.format(START), "--origin", "54 8")
        self.feed(SHIPS.format(START + 1), "--origin", "54 8")
        errors = self.feed(SHIPS.format(START + 2), "--origin", "7.9 53.9", fails=True)
        self.assertEqual(errors, ["foresee feed: ships has the origin 54 8: --origin is for a new table; leave it out, or write another "
                                  "--table"])
        self.database().execute("CREATE VIRTUAL TABLE boats USING moving_objects(id, t, lat, lon, speed, course)")
        errors = self.command("feed", self.file, "--table", "boats", "--origin", "54 8", text="", fails=True)[1]
        self.assertIn("boats takes its origin from its first report: --origin is for a new table", errors)

    def test_json_without_a_time(self):
        report = {"mmsi": 1, "lat": 53, "lon": 7, "sog": 5, "cog": 5}
        lines = "".join(json.dumps({**report, **more}) + "\n" for more in ({}, {"received_at": START}, {"Timestamp": 43}, {"datetime": ""}))
        errors = self.feed(lines)
        self.assertEqual(totals(errors), (4, 0, 0, 0, 4))
        self.assertEqual(errors[0], "foresee feed: line 1: the time (t) is missing; with --arrival a report without one has the time of its "
                                    "arrival")
        self.assertEqual(totals(self.feed(json.dumps({**report, "mmsi": 3, "t": 50}) + "\n"))[1], 1)      # seconds of a simulation
        self.assertEqual(totals(self.feed(lines, "--arrival"))[1], 4)
        self.feed(json.dumps({**report, "mmsi": 2, "datetime": "2022-01-03 00:00:00"}) + "\n")
        self.assertEqual(self.database().execute("SELECT t FROM ships WHERE id = 2").fetchall(), [(START,)])

    def test_numbers_that_name_no_ship(self):
        errors = self.feed(f"mmsi,t,lat,lon,sog,cog\n2.11E+08,{START},53,7,5,5\n0,{START},53,7,5,5\n-5,{START},53,7,5,5\n7.0,{START},53,7,5,5\n")
        self.assertEqual(errors[0], "foresee feed: line 2: the ship's number is '2.11E+08', without its last digits: write them all")
        self.assertIn("line 3: the ship's number is 0, not a number of a ship", errors[1])
        self.assertEqual(totals(errors), (5, 1, 0, 0, 3))

    def test_a_time_that_is_a_date_alone(self):
        errors = self.feed("mmsi,t,lat,lon,sog,cog\n1,2023-11-14,53,7,5,5\n")
        self.assertEqual(errors[0], "foresee feed: line 2: the time is '2023-11-14', neither Unix seconds nor a date with a time, as in "
                                    "2023-11-14 22:13:20")

    def test_sentences_of_other_types_and_with_wrong_numbers(self):
        if shutil.which("gpsdecode") is None:
            skip("feed of NMEA sentences", "there is no gpsdecode (gpsd-clients)")
        ship, others = 211000001, [sentence([(1, 6), (0, 2), (211000100 + i, 30), (0, 130)], START) for i in range(3)]
        lines = [position(ship, START, 53.9, 7.8), binary_message(ship, START + 10), position(ship, START + 60, 53.9, 7.81),
                 binary_message(ship, START + 70), position(ship, START + 300, 53.9, 7.85), position(211000002, START + 300, 53.9, 7.9), *others]
        errors = self.feed("\n".join(lines) + "\n")
        self.assertEqual(self.positions()[ship][0], START + 300, errors)
        # Two messages with a name have one output of gpsdecode.
        names = [sentence([(24, 6), (0, 2), (ship, 30), (0, 2), (1, 6), (0, 114)], START + 400),
                 sentence([(24, 6), (0, 2), (ship, 30), (1, 2), (0, 128)], START + 401)]
        self.feed("\n".join([*names, *names, position(ship, START + 500, 53.9, 7.86), *others]) + "\n")
        self.assertEqual(self.positions()[ship][0], START + 500)
        wrong = self.feed(position(211000003, START, 100.0, 7.8) + "\n" + "\n".join(others) + "\n")
        self.assertEqual(totals(wrong)[4], 1, wrong)


if __name__ == "__main__":
    main()
