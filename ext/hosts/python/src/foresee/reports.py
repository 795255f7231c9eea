"""Position reports of ships: what a field is called in the layouts of AIS files and messages, and what its values mean.

    fields = {"MMSI": "211000001", "BaseDateTime": "2022-01-03T00:10:00", "LAT": "53.99", "LON": "7.85", "SOG": "14", "COG": "91"}
    report = report_of(by_quantity(fields))

The rules are those of sql/import_ais.sql: latitude 91, longitude 181, speed 102.3, course 360 and nothing are "not available". A ship
slower than half a knot lies still. A value that cannot be is a BadReport, which names field and value.
"""
import csv
import json
import re
from datetime import datetime, timezone
from math import isfinite
from typing import NamedTuple, Optional

REST_BELOW = 0.5        # knots: slower ships lie still, their course is noise
NO_SPEED = 102.15       # knots: 102.2 is "that or more", 102.3 "not available"
MAX_SHIP = 2**53 - 1    # larger whole numbers may have been rounded
NO_TIME = "neither Unix seconds nor a date with a time, as in 2023-11-14 22:13:20"

# quantity: the names of its field, compared in lower case. Speeds are knots.
FIELDS = {
    "id": ("mmsi", "id", "userid"),
    "t": ("t", "basedatetime", "base_date_time", "# timestamp", "timestamp", "time", "datetime", "msgtime", "rxtime",
          "tagblock_timestamp"),
    "lat": ("lat", "latitude"),
    "lon": ("lon", "longitude"),
    "speed": ("sog_kn", "sog", "speed"),
    "course": ("cog_deg", "cog", "course"),
    "name": ("name", "vesselname", "vessel_name", "shipname"),
    "kind": ("type of mobile",),
}
QUANTITY = {field: quantity for quantity, fields in FIELDS.items() for field in fields}
NEEDED = ("id", "t", "lat", "lon", "speed", "course")


class BadReport(ValueError):
    """A line that is no report, in words for people."""


# What a hostile line may raise: csv's own errors, numbers beyond all doubles and dates, objects in objects a thousand deep.
UNREADABLE = (BadReport, csv.Error, OverflowError, RecursionError)


class Report(NamedTuple):
    """A position (t, lat, lon, speed, course) or a name alone (t is None). Course is None where the ship lies still."""
    id: int
    t: Optional[float]
    lat: Optional[float] = None
    lon: Optional[float] = None
    speed: float = 0.0
    course: Optional[float] = None
    name: Optional[str] = None


def by_quantity(fields):
    """The values of a report by quantity; of two names for one the earlier in FIELDS counts."""
    found = {}
    for field, value in fields.items():
        name = str(field).strip().lower()
        quantity = QUANTITY.get(name)
        if name == "timestamp" and is_second(value):
            continue
        if quantity is not None and value not in (None, ""):
            rank = FIELDS[quantity].index(name)
            if quantity not in found or rank < found[quantity][0]:
                found[quantity] = (rank, value)
    return {quantity: value for quantity, (_, value) in found.items()}


def is_second(value):
    """AIS messages have a field timestamp with the second of the minute, and with 60 to 63 for "not available": no time."""
    return isinstance(value, int) and not isinstance(value, bool) and 0 <= value <= 63


def number(what, value):
    """A finite number; None for the absence of one."""
    if value is None or value == "" or value == "nan":
        return None
    try:
        # Python takes true for 1 and 1_0 for 10.
        result = float(None if isinstance(value, bool) or "_" in str(value) else value)
    except OverflowError:
        raise BadReport(f"{what} is {shortened(value)}, too large") from None
    except (TypeError, ValueError):
        raise BadReport(f"{what} is {shortened(value)}, not a number") from None
    if not isfinite(result):
        raise BadReport(f"{what} is {shortened(value)}, not finite")
    return result


def shortened(value):
    text = repr(value).lower() if isinstance(value, bool) else repr(value)
    return text if len(text) <= 40 else text[:37] + "..."


def seconds(value):
    """Unix seconds of a time: seconds, milli-, micro- or nanoseconds, ISO 8601, DMA's day/month/year, or fourteen digits. Without a
    zone it is UTC. None for the absence of a time."""
    text = str(value).strip()
    digits = re.fullmatch(r"((?:19|20)\d{6})T?(\d{6})(Z?)", text)
    if digits:
        day, clock = digits[1], digits[2]
        text = f"{day[:4]}-{day[4:6]}-{day[6:]}T{clock[:2]}:{clock[2:4]}:{clock[4:]}{digits[3]}"
    if ":" not in text:
        try:
            result = number("the time", value)
        except BadReport:
            raise BadReport(f"the time is {shortened(value)}, {NO_TIME}") from None
        if result is None:
            return None
        for units in (1e9, 1e6, 1e3):
            if abs(result) > 1e8 * units:
                return result / units
        return result
    danish = re.fullmatch(r"(\d\d)/(\d\d)/(\d{4}) (.*)", text)
    if danish:
        text = f"{danish[3]}-{danish[2]}-{danish[1]} {danish[4]}"
    # Python before 3.11 takes neither Z nor a fraction that is not of 3 or 6 digits.
    text = re.sub(r"\.(\d+)", lambda part: "." + part[1][:6].ljust(6, "0"), text)
    text = re.sub(r"(Z| ?UTC)$", "", text)
    try:
        time = datetime.fromisoformat(text)
    except ValueError:
        raise BadReport(f"the time is {shortened(value)}, {NO_TIME}") from None
    return (time if time.tzinfo else time.replace(tzinfo=timezone.utc)).timestamp()


def angle(what, value, limit, absent):
    """A latitude or longitude; None where it is not available."""
    result = number(what, value)
    if result is None or abs(result) == absent:
        return None
    if abs(result) > limit:
        raise BadReport(f"{what} is {result:g}, not within {limit} degrees")
    return result


def report_of(value, now=None, id=None):
    """The Report of values by quantity; None where it says nothing about the future. `now` and `id` hold where it has none itself."""
    if not str(value.get("kind", "Class A")).startswith("Class"):
        return None
    written = value.get("id", id)
    if isinstance(written, str) and re.search(r"\de", written.lower()):
        raise BadReport(f"the ship's number is {shortened(written)}, without its last digits: write them all")
    ship = number("the ship's number", written)
    if ship is None:
        raise BadReport("the ship's number (mmsi) is missing")
    if ship <= 0:
        raise BadReport(f"the ship's number is {ship:g}, not a number of a ship")
    if ship != int(ship):
        raise BadReport(f"the ship's number is {ship:g}, not a whole one")
    if abs(ship) > MAX_SHIP:
        raise BadReport(f"the ship's number is {shortened(written)}, more than {MAX_SHIP}; an MMSI has nine digits")
    name = str(value.get("name", "")).encode("utf-8", "replace").decode().replace("\0", "").strip(" @") or None
    lat, lon = angle("the latitude", value.get("lat"), 90, 91), angle("the longitude", value.get("lon"), 180, 181)
    speed, course = number("the speed", value.get("speed")), number("the course", value.get("course"))
    if speed is not None and speed < 0:
        raise BadReport(f"the speed is {speed:g}, less than 0")
    if course is not None and not 0 <= course <= 360:
        raise BadReport(f"the course is {course:g}, not from 0 to 360 degrees")
    still = speed is not None and speed < REST_BELOW
    course = None if still or course == 360 else course
    if lat is None or lon is None or speed is None or speed > NO_SPEED or (course is None and not still):
        return None if name is None else Report(int(ship), None, name=name)
    t = seconds(value["t"]) if "t" in value else now
    if t is None:
        raise BadReport("the time (t) is missing")
    return Report(int(ship), t, lat, lon, 0.0 if still else speed, course, name)


def json_object(text):
    """The object of a line of JSON."""
    try:
        fields = json.loads(text)
    except ValueError:
        raise BadReport(f"no JSON: {shortened(text)}") from None
    if not isinstance(fields, dict):
        raise BadReport(f"no JSON object: {shortened(text)}")
    return fields
