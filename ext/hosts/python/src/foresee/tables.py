"""The tables that feed writes and alerts and map read: in which frame they are, and where on the Earth a place of theirs is.

    table = Table(connection, "ships")
    table.prepare(forget=900.0, kinds=True)
    table.write(report)                          # within a transaction; False where a newer one is there
    table.in_degrees()                           # SQL of lat, lon, speed, course of p, or None where the table does not say

A table in degrees knows its origin itself. Of a table in metres the file remembers the origin that feed was given.
"""
from .files import quoted
from .process import Refusal
from .reports import REST_BELOW

KNOT = 1852 / 3600
IN_UNIT = {"mps": KNOT, "knots": 1.0, "kmh": 1.852}     # one knot in the units of a table
# Bits of `category`. Moored ships do not meet one another; both meet tables without kinds, such as zones, whose category is 1.
UNDER_WAY, MOORED = 1, 2


def create(connection, name, origin):
    """A new table in degrees, for ships that are moored or under way and end some time after their last report."""
    place = f", origin = '{origin[0]!r} {origin[1]!r}'" if origin else ""
    connection.execute(f"CREATE VIRTUAL TABLE {quoted(name)} USING moving_objects(id, t, lat, lon, speed, course, until, "
                       f"category, mask, +name TEXT, speed_unit = knots{place})")


class Table:
    def __init__(self, connection, name):
        self.connection = connection
        self.columns = [row[1].lower() for row in connection.execute(f"PRAGMA table_info({quoted(name)})")]
        if not self.columns:
            raise Refusal(f"there is no table {name}; create it, or let feed create it")
        kind = connection.execute("SELECT name, sql FROM sqlite_master WHERE lower(name) = lower(?)", (name,)).fetchone()
        if kind is None or "moving_objects" not in kind[1].lower():
            raise Refusal(f"{name} is not a table of moving objects; write the name of one")
        self.name = kind[0]     # as it was created: the keys of foresee_feed compare the case
        self.degrees = "lat" in self.columns and "lon" in self.columns
        self.globe, self.origin, self.unit = self.frame()
        self.named = next((column for column in ("name", "vesselname", "shipname") if column in self.columns), None)

    def frame(self):
        """(on the globe, origin, unit of speed): what a table in degrees says itself, else what the file remembers."""
        frame = None
        if self.degrees:
            frame, origin, unit = self.connection.execute("SELECT frame, origin, speed_unit FROM foresee_tables WHERE schema = 'main' "
                                                          "AND lower(name) = lower(?)", (self.name,)).fetchone()
        else:
            row = self.connection.execute("SELECT origin FROM foresee_feed WHERE tbl = ?", (self.name,)).fetchone() \
                if self.connection.execute("SELECT 1 FROM sqlite_master WHERE name = 'foresee_feed'").fetchone() else None
            origin, unit = row and row[0], None
        return frame == "globe", tuple(map(float, origin.split())) if origin else None, unit or "mps"

    def in_degrees(self):
        """(columns, source, inputs, inputs): lat, lon, speed in m/s and course of a row p of predictive_position, and what gives them.

        A table in degrees says lat, lon itself, NULL for a ship that has run far away. A plane has no place beyond 20,000 km.
        """
        if self.origin is None:
            self.globe, self.origin, self.unit = self.frame()   # a table in degrees has its origin from the first report on
        if self.origin is None and not self.globe:
            return None
        if self.degrees:
            return "p.lat, p.lon, p.speed / ?, p.course", "", (IN_UNIT[self.unit] / KNOT,), ()
        return ("g.lat, g.lon, g.speed, g.course", ", plane_to_geo(p.x, p.y, p.vx, p.vy, ?, ?) g "
                                                 "WHERE p.x * p.x + p.y * p.y < 4e14", (), self.origin)

    # Writing

    def prepare(self, forget, kinds):
        """What write() needs of the table; a Refusal names what it lacks."""
        needed = ("id", "t") + (("lat", "lon", "speed", "course") if self.degrees else ("x", "y", "vx", "vy"))
        missing = [column for column in needed if column not in self.columns]
        if missing:
            raise Refusal(f"{self.name} has no column {', '.join(missing)}; feed needs id, t, lat, lon, speed, course "
                          "(or id, t, x, y, vx, vy)")
        if not self.degrees and self.origin is None:
            raise Refusal(f"{self.name} is in metres, and its origin is not known; write --origin 'LAT LON'")
        self.motion = needed[1:]
        self.forget = forget if "until" in self.columns else None
        self.kinds = kinds and "category" in self.columns and "mask" in self.columns
        extra = (["until"] if self.forget is not None else []) + (["category", "mask"] if self.kinds else [])
        columns = [*self.motion, *extra] + ([self.named] if self.named else [])
        values = ["?"] * (len(columns) - 1) + ([f"coalesce(?, {self.named})"] if self.named else ["?"])
        self.update = (f"UPDATE {quoted(self.name)} SET {', '.join(f'{c} = {v}' for c, v in zip(columns, values))} WHERE id = ? AND t <= ?")
        self.insert = f"INSERT INTO {quoted(self.name)}({', '.join([*columns, 'id'])}) VALUES ({', '.join('?' * (len(columns) + 1))})"
        self.rename = f"UPDATE {quoted(self.name)} SET {self.named} = ? WHERE id = ? AND {self.named} IS NOT ?"
        self.exists = f"SELECT 1 FROM {quoted(self.name)} WHERE id = ?"

    def write(self, report):
        """Stores a report that is not older than what is there; whether it was."""
        if report.t is None:
            return bool(self.named) and self.connection.execute(self.rename, (report.name, report.id, report.name)).rowcount > 0
        values = [report.t, *self.motion_of(report)]
        if self.forget is not None:
            values.append(report.t + self.forget)
        if self.kinds:
            values += [MOORED, UNDER_WAY] if report.speed < REST_BELOW else [UNDER_WAY, MOORED | UNDER_WAY]
        if self.named:
            values.append(report.name)
        if self.connection.execute(self.update, (*values, report.id, report.t)).rowcount > 0:
            return True
        if self.connection.execute(self.exists, (report.id,)).fetchone():
            return False
        self.connection.execute(self.insert, (*values, report.id))
        return True

    def motion_of(self, report):
        if self.degrees:
            return report.lat, report.lon, report.speed * IN_UNIT[self.unit], report.course
        return self.connection.execute("SELECT x, y, vx, vy FROM geo_to_plane(?, ?, ?, ?, ?, ?)",
                                       (report.lat, report.lon, report.speed * KNOT, report.course or 0.0, *self.origin)).fetchone()
