"""The command line: python3 -m foresee feed | alerts | map; --help describes their options.

An error is one line and status 1, or 2 if an option is wrong.
"""
import argparse

from .process import name, not_negative, place, port, positive, run_command

EPILOG = {
    "feed": """\
examples:
  python3 -m foresee feed fleet.db --table ships --watch alerts --horizon 600 --within 926 < AIS_2022_01_03.csv
  nc receiver 10110 | python3 -m foresee feed fleet.db --table ships
  python3 -m foresee feed fleet.db --table ships --mqtt 'mqtt://broker.local/ais/#'

input, recognised by its first line: CSV with a header (mmsi, t, lat, lon, sog, cog, name, or the columns of NOAA and DMA), lines of
JSON with the same names, NMEA sentences (by gpsdecode). Speeds are knots, courses degrees from north, times Unix seconds or dates.""",
    "alerts": """\
examples:
  python3 -m foresee alerts fleet.db alerts
  python3 -m foresee alerts fleet.db alerts --news --json
  python3 -m foresee alerts fleet.db alerts --webhook https://example.org/hook

A line per change: + a pair is new, ~ its time moved, - it is over. For information, not for navigation.""",
    "map": """\
example:
  python3 -m foresee map fleet.db

Serves one page on this machine. Nothing is requested from any other. For information, not for navigation.""",
}


class Parser(argparse.ArgumentParser):
    """Without the usage beside an error, which is up to seven lines: --help shows it."""

    def error(self, message):
        name = self.prog.replace("python3 -m ", "")
        self.exit(2, f"{name}: {' '.join(message.split())}; see {self.prog} --help\n")


def command(commands, word, does):
    parser = commands.add_parser(word, help=does, description=does, epilog=EPILOG[word],
                                 formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file", metavar="FILE.db", help="the database")
    return parser


def arguments(given=None):
    parser = Parser(prog="python3 -m foresee", description="From reports to alerts: feed, alerts, map.")
    commands = parser.add_subparsers(dest="command", required=True, metavar="feed | alerts | map")

    feed = command(commands, "feed", "Stores position reports of ships in a table of moving objects.")
    feed.add_argument("--table", required=True, type=name, help="the table; it is created where it is not there")
    feed.add_argument("--origin", type=place, help="'LAT LON' of the plane (a new table: from the first report)")
    feed.add_argument("--watch", type=name, help="a watch of the table to create where it is not there")
    feed.add_argument("--horizon", type=not_negative, help="of the new watch, in seconds (600)")
    feed.add_argument("--within", type=not_negative, help="of the new watch, in metres (926, half a nautical mile)")
    feed.add_argument("--tolerance", type=not_negative,
                      help="of the new watch: smaller moves of a pair's time are no change, in seconds (30)")
    feed.add_argument("--format", dest="layout", choices=("auto", "csv", "json", "nmea"), default="auto",
                      help="of standard input (%(default)s)")
    feed.add_argument("--arrival", action="store_true", help="a line of JSON without a time has the time of its arrival")
    feed.add_argument("--resume", action="store_true", help="skip the lines of standard input that were committed before")
    feed.add_argument("--every", type=positive, default=1.0, help="seconds between transactions; 1,000 rows end one before (%(default)g)")
    feed.add_argument("--forget", type=positive, default=900.0,
                      help="seconds after its last report at which a ship ends, in a table with until (%(default)g)")
    feed.add_argument("--future", type=not_negative, default=300.0,
                      help="seconds by which a report may be later than the clock of this machine; later ones are bad (%(default)g)")
    feed.add_argument("--no-kinds", dest="kinds", action="store_false", help="do not write moored and under way into category and mask")
    feed.add_argument("--mqtt", metavar="URL", help="mqtt://[user:password@]host[:port]/topic, or mqtts: read from a broker")
    feed.add_argument("--client-id", help="of the persistent MQTT session (from host, file, table and topic)")

    alerts = command(commands, "alerts", "Follows a watch: a line per change, each at least once.")
    alerts.add_argument("watch", metavar="WATCH", type=name, help="the watch")
    alerts.add_argument("--json", action="store_true", help="lines of JSON")
    alerts.add_argument("--news", action="store_true", help="only new pairs whose encounter is still to come")
    alerts.add_argument("--webhook", metavar="URL", help="POST each change as JSON; what fails is repeated, in order")
    alerts.add_argument("--reader", help="whose position in the watch is kept (alerts; with --webhook, webhook)")
    alerts.add_argument("--from-start", action="store_true", help="the whole watch first, as for a new reader")
    alerts.add_argument("--once", action="store_true", help="end when all changes are delivered")
    alerts.add_argument("--poll", type=positive, default=0.05, help="seconds between two reads of the file (%(default)g)")

    page = command(commands, "map", "Serves a map of the ships and their alerts on 127.0.0.1.")
    page.add_argument("--table", type=name, help="the table (the only one)")
    page.add_argument("--port", type=port, default=8137, help="%(default)s; 0: any that is free")
    options, unknown = parser.parse_known_args(given)
    if unknown:         # argparse would name the program and not the command
        commands.choices[options.command].error(f"unrecognized arguments: {' '.join(unknown)}")
    return options


def main():
    options = arguments()
    if options.command == "feed":
        from .feed import run
    elif options.command == "alerts":
        from .alerts import run
    else:
        from .map_server import run
    run_command(options.command, lambda: run(options))


if __name__ == "__main__":
    main()
