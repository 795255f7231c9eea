"""Decoders of lines: CSV with a header, JSON lines, NMEA sentences (by Debian's gpsdecode). Each turns lines into reports.

    decoder = decoder_of("MMSI,BaseDateTime,LAT,LON,SOG,COG")       # by the first line
    reports, bad = decoder.read([(1, "MMSI,BaseDateTime,LAT,LON,SOG,COG"), (2, "1,2022-01-03T00:00:00,30,-90,7,90")])

read() takes (number, line) pairs and gives the reports, and (number, message) of each line that is no report.
"""
import csv
import time

from .nmea import Sentences
from .reports import FIELDS, NEEDED, QUANTITY, UNREADABLE, BadReport, by_quantity, json_object, report_of


CALLED = {"id": "the ship (mmsi)", "t": "the time (t, BaseDateTime or # Timestamp)", "lat": "the latitude (lat)",
          "lon": "the longitude (lon)", "speed": "the speed (sog)", "course": "the course (cog)"}


class MissingColumns(Exception):
    """A CSV file without a quantity that reports need."""


class Lines:
    """A decoder that takes one line after the other. `left_out` counts reports without a position or a speed."""

    left_out, is_header = 0, False

    def read(self, numbered):
        reports, bad = [], []
        for number, line in numbered:
            if not line.strip():
                continue
            try:
                report = self.report(line)
            except UNREADABLE as reason:
                bad.append((number, str(reason)))
            else:
                if report is not None:
                    reports.append(report)
                elif not self.is_header:
                    self.left_out += 1
        return reports, bad


class CsvLines(Lines):
    def __init__(self):
        self.header = None

    def report(self, line):
        values = next(csv.reader([line]))
        self.is_header = self.header is None or values == self.header
        if self.header is None:
            self.take_header(values)
        elif self.is_header:
            return None                     # of a file that was appended to another
        elif len(values) != len(self.header):
            raise BadReport(f"{len(values)} values, and the header has {len(self.header)} columns")
        else:
            return report_of({quantity: values[place] for quantity, place in self.columns if values[place]})
        return None

    def take_header(self, values):
        names = [value.strip().lower() for value in values]
        present = {QUANTITY[name] for name in names if name in QUANTITY}
        missing = [CALLED[quantity] for quantity in NEEDED if quantity not in present]
        if missing:
            raise MissingColumns(f"the first line has no column for {', '.join(missing)}; write a header")
        self.columns = [(quantity, min((i for i, name in enumerate(names) if name in FIELDS[quantity]),
                                       key=lambda i: FIELDS[quantity].index(names[i]))) for quantity in present]
        self.header = values


class JsonLines(Lines):
    def __init__(self, arrival):
        self.arrival = arrival

    def report(self, line):
        values = by_quantity(json_object(line))
        report = report_of(values, now=time.time())
        if report is not None and report.t is not None and "t" not in values and not self.arrival:
            raise BadReport("the time (t) is missing; with --arrival a report without one has the time of its arrival")
        return report


def decoder_of(first, layout="auto", arrival=False):
    """The decoder for a first line, or for a layout: csv, json or nmea. `arrival`: a JSON report without a time has the present one."""
    start = first.lstrip()[:1]
    if layout == "auto":
        layout = "json" if start == "{" else "nmea" if start in ("!", "$", "\\") else "csv"
    return JsonLines(arrival) if layout == "json" else {"csv": CsvLines, "nmea": Sentences}[layout]()
