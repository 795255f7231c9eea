"""What the commands share as programs: their end by signals, one line per error, values of options.

    run_command("feed", lambda: feed.run(options))      # ends the program with status 0, or with a line on stderr and status 1
"""
import os
import signal
import sqlite3
import sys
from argparse import ArgumentTypeError
from math import isfinite


class Refusal(Exception):
    """What cannot be done, in one line for people."""


class Stop:
    """Becomes true at SIGTERM or SIGINT; a second signal ends the program at once."""

    def __init__(self):
        self.is_requested = False
        for number in (signal.SIGTERM, signal.SIGINT):
            signal.signal(number, self.note)

    def note(self, number, frame):
        if self.is_requested:
            os._exit(128 + number)
        self.is_requested = True

    def __call__(self):
        return self.is_requested


def run_command(name, command):
    try:
        command()
    except (Refusal, sqlite3.Error, OSError, RuntimeError) as error:
        text = str(error) if isinstance(error, (Refusal, sqlite3.Error)) else f"{type(error).__name__}: {error}"
        sys.exit(f"foresee {name}: {' '.join(text.splitlines())}")
    except KeyboardInterrupt:
        sys.exit(130)


# Types of options: argparse shows their names where a value is wrong.

def positive(text):
    value = float(text)
    if not (value > 0 and isfinite(value)):
        raise ValueError
    return value


def not_negative(text):
    value = float(text)
    if not (value >= 0 and isfinite(value)):
        raise ValueError
    return value


def name(text):
    if not text:
        raise ArgumentTypeError("the name is empty; write for example ships")
    return text


def port(text):
    value = int(text)
    if not 0 <= value < 65536:
        raise ValueError
    return value


def place(text):
    """'53.9 7.9' or '53.9,7.9'."""
    lat, lon = (float(part) for part in text.replace(",", " ").split())
    if not (abs(lat) <= 90 and abs(lon) <= 180):
        raise ValueError
    return lat, lon


positive.__name__, not_negative.__name__, place.__name__ = "(not a number above 0)", "(not 0 or more)", "(not 'LATITUDE LONGITUDE')"
