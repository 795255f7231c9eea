"""How does a file come to be? Whole or not at all, whoever writes it and however often.

It is written under a hidden name that nobody else has, brought to the disk, and renamed: two writers of one file leave the file of one
of them, a writer that died leaves its hidden file behind, which `sweep_up` removes.
"""
import errno
import os
import sqlite3
import uuid
from contextlib import contextmanager
from pathlib import Path

from . import Refusal


def to_disk(path):
    file = os.open(path, os.O_RDONLY)
    try:
        os.fsync(file)
    finally:
        os.close(file)


def _no_room(error):
    if isinstance(error, OSError):
        return error.errno in (errno.ENOSPC, errno.EDQUOT)
    return isinstance(error, sqlite3.Error) and "disk is full" in str(error)


@contextmanager
def appearing(path):
    """The hidden name under which to write; afterwards the file is at `path`, or in case of an error nowhere."""
    path = Path(path)
    hidden = path.with_name(f".{path.stem}.{uuid.uuid4().hex}{path.suffix}")
    try:
        yield hidden
        to_disk(hidden)
        os.replace(hidden, path)
        to_disk(path.parent)
    except (OSError, sqlite3.Error) as error:
        if _no_room(error):
            raise Refusal(f"no room on disk for {path}: {error}") from None
        raise
    finally:
        for leftover in path.parent.glob(hidden.name + "*"):
            leftover.unlink()


def write_text(path, text):
    with appearing(path) as hidden:
        hidden.write_text(text)


def sweep_up(folder):
    """Removes what writers that died have left; nobody may be writing."""
    for leftover in Path(folder).glob(".*." + "[0-9a-f]" * 32 + ".*"):
        leftover.unlink()
