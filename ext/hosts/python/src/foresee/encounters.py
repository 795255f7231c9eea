"""A change of a watch in words and numbers for people: names, time to the closest approach, its distance, its place.

    encounters = Encounters(db, watch_of(db, "alerts"))
    encounters.describe((7, "+", 1, 2, 1641168629.0, 1641168600.0))

gives a dictionary that JSON can hold. TCPA, CPA and place are those of the pair as the tables have it now; they are None once it is gone.
A pair enters a watch at the end of its horizon, mostly before its closest approach: that is searched for up to an hour beyond the horizon.
With a table of areas (a column `zone`, or `shape` without a velocity) the distance to its position says nothing: then `entry_min` is the
time until the object comes within the distance, place is where it does, and TCPA and CPA are None.
"""
from .files import quoted
from .tables import Table

KEYS = ("watch", "seq", "op", "a", "b", "a_name", "b_name", "now", "t", "near", "tcpa_min", "cpa_m", "lat", "lon", "x", "y", "within_m",
        "entry_min")


BEYOND = 3600.0         # seconds beyond the horizon


class Encounters:
    def __init__(self, db, watch):
        self.db, self.watch = db, watch
        self.first = Table(db, watch.tbl)
        self.second = Table(db, watch.other) if watch.other else self.first
        columns = self.second.columns
        self.is_of_areas = "zone" in columns or ("shape" in columns and "vx" not in columns and "speed" not in columns)
        self.pair = f"SELECT t, t_cpa, d_cpa FROM {quoted(watch.name)} WHERE a = ? AND b = ?"

    def name(self, table, number):
        """Its name, else its number."""
        if table.named:
            row = self.db.execute(f"SELECT {table.named} FROM {quoted(table.name)} WHERE id = ?", (number,)).fetchone()
            if row and row[0]:
                return printable(str(row[0]))
        return str(number)

    def place_at(self, number, t):
        """(latitude, longitude, x, y) of an object of the first table at a time, as far as they are known."""
        position = "predictive_position(?, ?) p"
        row = self.db.execute(f"SELECT x, y FROM {position} WHERE id = ?", (t, self.first.name, number)).fetchone()
        if row is None or row[1] is None:
            return None, None, row and row[0], None
        there = self.first.in_degrees()
        if there is None:
            return None, None, *row
        place = self.db.execute(f"SELECT {there[0]} FROM {position}{there[1]}{' AND' if there[1] else ' WHERE'} p.id = ?",
                                (*there[2], t, self.first.name, *there[3], number)).fetchone()
        return (*(place[:2] if place else (None, None)), *row)

    def describe(self, row):
        seq, op, a, b, t, now = row
        closest = None if op == "-" else self.db.execute(self.pair, (a, b)).fetchone()
        measured = {"tcpa_min": None, "cpa_m": None, "entry_min": None}
        place = (None, None, None, None)
        if closest is not None:
            start, t_cpa, distance = self.closest(a, b, closest, now)
            measured = self.measures(start, t_cpa, distance, now)
            place = self.place_at(a, max(start, now) if self.is_of_areas else t_cpa)
        near = t is not None and t <= now
        return dict(zip(KEYS, (self.watch.name, seq, op, a, b, self.name(self.first, a), self.name(self.second, b), now, t, near,
                               measured["tcpa_min"], measured["cpa_m"], *place, self.watch.within, measured["entry_min"])))

    def closest(self, a, b, row, now):
        """(t, t_cpa, d_cpa) of a pair of the watch, also where its closest approach is beyond the horizon."""
        start, t_cpa, distance = row
        if self.is_of_areas or t_cpa < now + self.watch.horizon * (1 - 1e-9):
            return row
        watch = self.watch
        upright = () if watch.within_z is None else (watch.within_z,)
        further = self.db.execute("SELECT t_cpa, d_cpa FROM predictive_join(?, ?, ?, ?) WHERE now = ? AND a = ? AND b = ?"
                                  f"{' AND within_z = ?' if upright else ''}",
                                  (watch.horizon + BEYOND, watch.tbl, watch.within, watch.other, now, a, b, *upright)).fetchone()
        return (start, *further) if further else row

    def measures(self, t, t_cpa, distance, now):
        if self.is_of_areas:
            return {"tcpa_min": None, "cpa_m": None, "entry_min": max(t - now, 0.0) / 60}
        return {"tcpa_min": max(t_cpa - now, 0.0) / 60, "cpa_m": distance, "entry_min": None}


def printable(text):
    """Without the control characters that could rewrite a terminal."""
    return "".join(character if character.isprintable() else "?" for character in text)
