"""Joins of foresee in tiles: many files, many processes, many machines; the rows are those of the single join.

    python3 -m foresee_dask join --extension build/release/foresee.so --table ships --horizon 600 --out pairs/ ships-*.db
    python3 -m foresee_dask merge pairs/ pairs.db

docs/how-to/tiles_on_dask.md tells the rest. Only run.py knows Dask.
"""


import logging
import os
import signal
import sqlite3
import sys
from threading import Timer


class Refusal(Exception):
    """What cannot be done, in one line for people. Nothing that was written before is touched."""


def _interrupt_again(dropped):
    """Python drops an interrupt that arrives in a callback, such as Dask's of the garbage collector: it is sent again."""
    if issubclass(dropped.exc_type, KeyboardInterrupt):
        Timer(0.1, os.kill, (os.getpid(), signal.SIGINT)).start()
    else:
        sys.__unraisablehook__(dropped)


def in_one_line(main, *arguments):
    """main(), of which mistakes are one line and status 1."""
    sys.unraisablehook = _interrupt_again
    try:
        main(*arguments)
    except (Refusal, OSError) as error:
        sys.exit(f"foresee_dask: {error}")
    except (sqlite3.Error, MemoryError) as error:
        sys.exit(f"foresee_dask: {type(error).__name__}: {error}")
    except KeyboardInterrupt:
        logging.disable(logging.CRITICAL)
        sys.exit("foresee_dask: cut off; the same command goes on")
