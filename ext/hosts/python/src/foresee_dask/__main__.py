"""The command line: python3 -m foresee_dask join | plan | merge; --help tells their options. Mistakes are one line and status 1."""
import argparse
from math import isfinite
from pathlib import Path

from . import in_one_line
from .question import Question


def _number(text):
    value = float(text)
    if not isfinite(value):
        raise ValueError
    return value


def _count(text):
    value = int(text)
    if value < 1:
        raise ValueError
    return value


_number.__name__, _count.__name__ = "number", "count of at least 1"


def arguments():
    parser = argparse.ArgumentParser(prog="python3 -m foresee_dask", description="Joins of foresee in tiles.")
    commands = parser.add_subparsers(dest="command", required=True)
    module = Path(__file__).resolve().parent.parent / "foresee" / "foresee.so"
    for name, does in (("join", "joins shards in tiles on Dask"), ("plan", "writes plan.json; tile_join does the tiles then")):
        command = commands.add_parser(name, help=does)
        command.add_argument("shards", nargs="+", help="foresee files; SQLite files with a plain table, CSV, Parquet (by pyarrow)")
        command.add_argument("--out", required=True, help="the folder of the answer")
        command.add_argument("--table", required=True)
        command.add_argument("--horizon", type=_number, required=True)
        command.add_argument("--within", type=_number, default=0.0)
        command.add_argument("--within-z", type=_number)
        command.add_argument("--other", help="a second table: a is from --table, b from --other")
        command.add_argument("--now", type=_number, help="the first moment asked about (the newest t of all shards)")
        command.add_argument("--columns", default="t", help="t,t_end,d_cpa,a.name ... (%(default)s); a and b always come")
        command.add_argument("--extension", default=str(module), required=not module.exists(), help="foresee.so, everywhere the same")
        command.add_argument("--tiles", type=_count, help="at most; 8 a worker at least, and one for every 400000 objects")
        command.add_argument("--workers", type=_count, help="processes on this machine (one a core)")
        if name == "join":
            command.add_argument("--scheduler", help="the address of a Dask scheduler, in place of processes here")
    command = commands.add_parser("merge", help="one table of all tiles' rows")
    command.add_argument("folder")
    command.add_argument("target")
    return parser.parse_args()


def asked(given):
    columns = tuple(column.strip() for column in given.columns.split(",") if column.strip())
    return Question(given.table, given.horizon, given.within, given.within_z, given.other, given.now,
                    tuple(column for column in columns if column not in ("a", "b")))


def main():
    given = arguments()
    if given.command == "merge":
        from .merge import merge
        print(f"{merge(given.folder, given.target)} rows in {given.target}")
    elif given.command == "plan":
        from .plan import make
        plan = make(given.out, asked(given), given.shards, given.extension, given.tiles,
                    lambda function, every: [function(*one) for one in every], given.workers or 1)
        for tile in plan.tiles:
            print(tile.name)
    else:
        from .run import join
        manifest = join(given.out, asked(given), given.shards, given.extension, given.tiles, given.workers, given.scheduler)
        print(f"{manifest['rows']} rows in {len(manifest['tiles'])} tiles: {given.out}")


if __name__ == "__main__":
    in_one_line(main)
