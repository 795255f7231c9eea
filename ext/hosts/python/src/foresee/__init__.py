"""When will moving objects meet? foresee in a connection of sqlite3.

    import foresee
    db = foresee.connect("fleet.db")
    db.execute("SELECT a, b, t FROM predictive_join(300)")

`load` does the same for a connection that is open already: one of sqlite3, or of a package with the same methods (pysqlite3).
"""
import os
import sqlite3
import sys
from importlib.metadata import version as _version
from typing import Any, TypeVar

__all__ = ["connect", "load", "loadable_path", "__version__"]
__version__ = _version("foresee")

Connection = TypeVar("Connection")

_NO_EXTENSIONS = """\
{python} was built without SQLite's loadable extensions: its connections have no enable_load_extension. Three ways out:
  another interpreter: that of Debian or Ubuntu (/usr/bin/python3), of Homebrew, of conda;
  another module: pip install pysqlite3-binary, then foresee.load(pysqlite3.dbapi2.connect(path));
  the same one, built anew: PYTHON_CONFIGURE_OPTS=--enable-loadable-sqlite-extensions pyenv install --force {release}"""


def loadable_path() -> str:
    """Where the module is, as load_extension() and the shell's .load take it: without its ending."""
    return os.path.join(os.path.dirname(os.path.abspath(__file__)), "foresee")


def load(connection: Connection) -> Connection:
    """Brings foresee into an open connection, and gives it back. Loading of extensions is off afterwards."""
    database: Any = connection
    if not hasattr(database, "enable_load_extension"):
        raise RuntimeError(_NO_EXTENSIONS.format(python=sys.executable, release=sys.version.split()[0]))
    database.enable_load_extension(True)
    try:
        database.load_extension(loadable_path())
    finally:
        database.enable_load_extension(False)
    return connection


def connect(database: Any, **options: Any) -> sqlite3.Connection:
    """sqlite3.connect() with the same options, and foresee in the connection."""
    connection = sqlite3.connect(database, **options)
    try:
        return load(connection)
    except BaseException:
        connection.close()
        raise
