"""What is asked? A join's inputs and the columns wanted; two questions are compared field by field.

    Question("ships", 600.0, within=926.0, columns=("t", "d_cpa", "a.name"))

`a.name` is the column +name of a's row. The fingerprint stands in every file of an answer, so that files of two questions never mix.
"""
import dataclasses
import hashlib
import json
from typing import Optional, Tuple

from . import Refusal

OUTPUTS = ("t", "t_end", "dt", "dt_end", "t_cpa", "dt_cpa", "d_cpa")


def quoted(name):
    return '"' + name.replace('"', '""') + '"'


def same_name(a, b):
    """SQLite ignores the case of names."""
    return a.lower() == b.lower()


@dataclasses.dataclass(frozen=True)
class Question:
    table: str
    horizon: float
    within: float = 0.0
    within_z: Optional[float] = None
    other: Optional[str] = None
    now: Optional[float] = None
    columns: Tuple[str, ...] = ("t",)

    @staticmethod
    def of(fields):
        return Question(**{**fields, "columns": tuple(fields["columns"])})

    def at(self, now):
        return dataclasses.replace(self, now=now)

    def tables(self):
        """The tables whose rows are needed, each once."""
        return [self.table] if self.other is None or same_name(self.other, self.table) else [self.table, self.other]

    def carried(self, table):
        """The columns with + of `table` that the answer shows."""
        sides = [side for side, of in (("a.", self.table), ("b.", self.other or self.table)) if same_name(of, table)]
        return sorted({column[2:] for column in self.columns if column[:2] in sides})

    def check(self):
        for column in self.columns:
            if column not in OUTPUTS and column[:2] not in ("a.", "b."):
                raise Refusal(f"columns: no such column: {column}; there are {', '.join(OUTPUTS)}, and a.name for a column +name")
        if len(set(self.columns)) < len(self.columns):
            raise Refusal(f"columns: one is named twice: {','.join(self.columns)}")

    def sweep(self, table, schema):
        """predictive_sweep of one table, and its inputs."""
        return "predictive_sweep(?, ?, ?, ?, ?, ?)", (self.horizon, table, self.within, self.now, self.within_z, schema)

    def rows(self, schema, bounds):
        """The SELECT of one tile's rows, ordered, and its inputs."""
        def shown(column):
            if column in OUTPUTS:
                return "j." + column
            table = self.table if column[0] == "a" else self.other or self.table
            return f"(SELECT o.{quoted(column[2:])} FROM {schema}.{quoted(table)} o WHERE o.id = j.{column[0]})"

        outputs = ", ".join(["j.a", "j.b", *map(shown, self.columns)])
        return (f"SELECT {outputs} FROM predictive_join(?, ?, ?, ?, ?, NULL, ?, ?, ?, ?, ?, ?) j ORDER BY j.a, j.b",
                (self.horizon, self.table, self.within, self.other, self.now, self.within_z, schema, *bounds))

    def pairs_table(self, schema="main"):
        """Sorted by a and b; a pair that came twice would be an error."""
        outputs = [quoted(column) + (" REAL" if column in OUTPUTS else "") for column in self.columns]
        return f"CREATE TABLE {schema}.pairs({', '.join(['a INTEGER', 'b INTEGER', *outputs])}, PRIMARY KEY(a, b)) WITHOUT ROWID"


def differences(here, there):
    """'horizon is 600 there and 300 here', for each field that differs."""
    a, b = dataclasses.asdict(here), dataclasses.asdict(there)

    def shown(value):
        return ",".join(value) if isinstance(value, tuple) else "not given" if value is None else f"{value}"
    return "; ".join(f"{name} is {shown(b[name])} there and {shown(a[name])} here" for name in a if a[name] != b[name])


def fingerprint(*what):
    """Of all that decides an answer, as 16 hexadecimal digits."""
    return hashlib.sha256(json.dumps(what, sort_keys=True).encode()).hexdigest()[:16]
