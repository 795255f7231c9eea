r"""NMEA sentences of AIS receivers, decoded by gpsdecode of Debian's gpsd-clients (gpsd-tools in newer releases).

    reports, bad = Sentences().read([(1, r"\c:1641168000*5A\!AIVDM,1,1,,A,13HOI:0P0000VOHLCnHQKwvL05Ip,0*23")])

The time of a report is that of its tag block (c:, Unix seconds), else the time of its arrival. gpsdecode holds its last sentences back
until more arrive, so each group of lines has a process of its own, which takes some milliseconds. It drops what it cannot decode,
and does not name the sentence of an output: outputs are matched with sentences by ship and type of message, in order.
"""
import re
import shutil
import subprocess
import time

from .reports import UNREADABLE, BadReport, by_quantity, json_object, report_of

FIELDS = ("mmsi", "lat", "lon", "speed", "course", "shipname")
POSITIONS_AND_NAMES = (1, 2, 3, 5, 9, 18, 19, 24, 27)
TAG = re.compile(r"^\\([^\\]*)\\")
SENTENCE = re.compile(r"^[!$][A-Z]{2}VD[MO],(\d),(\d),([^,]*),([^,]*),([^,]*),\d\*([0-9A-Fa-f]{2})$")
HELD = 100              # messages of which later sentences are awaited


class NoDecoder(Exception):
    """gpsdecode is not installed, or fails."""


def checksum(body):
    total = 0
    for character in body.encode("ascii", "replace"):
        total ^= character
    return total


def kind_of(payload):
    """(number of the ship, type of the message): in bits 8 to 37 and 0 to 5 of a payload of six bits per character; None where they
    are not there."""
    bits = 0
    for character in payload[:7]:
        value = ord(character) - 48
        bits = bits << 6 | (value - 8 if value > 40 else value) & 63
    return (bits >> 4 & 0x3FFFFFFF, bits >> 36) if len(payload) >= 7 else None


class Sentences:
    """A decoder of layouts.py for NMEA."""

    def __init__(self):
        if shutil.which("gpsdecode") is None:
            raise NoDecoder("there is no gpsdecode to read NMEA sentences; install gpsd-clients (Debian 12) or gpsd-tools (newer)")
        self.left_out = 0
        self.unfinished = {}                # (count, sequence, channel): the sentences so far of a message that has more

    def read(self, numbered):
        now, bad, sent, times = time.time(), [], [], []
        for number, line in numbered:
            if line.strip():
                try:
                    self.take(number, line.strip(), now, sent, times)
                except UNREADABLE as reason:
                    bad.append((number, str(reason)))
        return self.reports(self.decoded(sent), times, bad), bad

    def take(self, number, line, now, sent, times):
        """Appends a message to `sent` once it is whole, and its ship, its time and the number of its last line to `times`."""
        tag = TAG.match(line)
        seconds = re.search(r"(?:^|,)c:(\d+)", tag[1]) if tag else None
        sentence = line[tag.end():] if tag else line
        parts = SENTENCE.match(sentence)
        if not parts:
            raise BadReport(f"no AIS sentence: {line[:60]!r}")
        count, place, sequence, channel, payload, written = parts.groups()
        if checksum(sentence[1:-3]) != int(written, 16):
            raise BadReport(f"the checksum is wrong: {sentence[:60]!r}")
        t = float(seconds[1]) if seconds else now
        t = t / 1000 if t > 1e11 else t
        message = (count, sequence, channel)
        if place == "1":
            self.unfinished[message] = ([], kind_of(payload), t)
        elif message not in self.unfinished:
            return                          # its start was not received: nothing is wrong with this line
        whole, ship, t = self.unfinished[message]
        whole.append(sentence)
        if place == count:
            sent += whole
            times.append((ship, t, number))
            del self.unfinished[message]
        elif len(self.unfinished) > HELD:
            del self.unfinished[next(iter(self.unfinished))]

    def decoded(self, sent):
        if not sent:
            return []
        done = subprocess.run(["gpsdecode", "-j"], input=("\n".join(sent) + "\n").encode(), stdout=subprocess.PIPE,
                              stderr=subprocess.DEVNULL, start_new_session=True)
        if done.returncode != 0:
            raise NoDecoder(f"gpsdecode ended with status {done.returncode}; try gpsdecode -j with the same lines")
        return done.stdout.decode("utf-8", "replace").splitlines()

    def reports(self, lines, times, bad):
        """The reports of outputs of gpsdecode. Appends to `bad` those with numbers that a transmitter sends wrong."""
        reports, place = [], 0
        for line in lines:
            number = None
            try:
                fields = json_object(line)
                kind = (fields.get("mmsi"), fields.get("type"))
                match = next((i for i in range(place, len(times)) if times[i][0] == kind), None)
                if match is None or kind[1] not in POSITIONS_AND_NAMES:
                    continue
                place = match + 1           # two messages of type 24 have one output: the second is passed over
                _, t, number = times[match]
                report = report_of({**by_quantity({key: fields[key] for key in FIELDS if key in fields}), "t": t})
            except UNREADABLE as reason:
                if number is not None:
                    bad.append((number, str(reason)))
                continue
            if report is None:
                self.left_out += 1
            else:
                reports.append(report)
        return reports
