"""Writes the archive of a target, the same bytes for the same contents: a tar.gz, for Windows a zip.

    SOURCE_DATE_EPOCH=… python3 ext/hosts/release/archive.py FOLDER VERSION TARGET MODULE "qemu, 39615 rows"

It holds one folder, foresee-VERSION-TARGET, with the module, README, LICENSE and THIRD_PARTY, which is beside the module.
"""
import gzip
import io
import os
import sys
import tarfile
import time
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
EPOCH = int(os.environ["SOURCE_DATE_EPOCH"])
README = """foresee {version} for {target}: predictive spatial joins in SQLite.

Load it by its path without ending, into SQLite 3.31 or newer:

  sqlite3 fleet.db -cmd ".load ./foresee"

{tested} Keep the name: SQLite derives the entry point from it. On another machine or C library SQLite says only that
the file could not be opened. The pages of the source describe the functions: docs/reference/index.md.
"""
UNTESTED = """This module was built and never run: no machine of ours runs it. Tell us whether it works.

A download carries the attribute com.apple.quarantine, which has to be removed: xattr -d com.apple.quarantine foresee.dylib
Apple's own sqlite3 and Python load no extensions; those of Homebrew or python.org do.
"""


def contents(version, target, module, tested):
    """{name: bytes} of the folder."""
    built_only = tested == "built only"
    sentence = "It was built and never run." if built_only else f"It answered on its target as the native build did: {tested}."
    files = {
        "LICENSE": (ROOT / "LICENSE").read_bytes(),
        "README": README.format(version=version, target=target, tested=sentence).encode(),
        "THIRD_PARTY": (module.parent / "THIRD_PARTY").read_bytes(),
        module.name: module.read_bytes(),
    }
    if built_only:
        files["UNTESTED"] = UNTESTED.encode()
    return dict(sorted(files.items()))


def mode_of(name):
    return 0o755 if name.startswith("foresee.") else 0o644


def write_tar(path, folder, files):
    packed = io.BytesIO()
    with tarfile.open(fileobj=packed, mode="w", format=tarfile.USTAR_FORMAT) as archive:
        for name, data in files.items():
            about = tarfile.TarInfo(f"{folder}/{name}")
            about.size, about.mtime, about.mode = len(data), EPOCH, mode_of(name)
            archive.addfile(about, io.BytesIO(data))
    with open(path, "wb") as file, gzip.GzipFile(filename="", fileobj=file, mode="wb", compresslevel=9, mtime=EPOCH) as stream:
        stream.write(packed.getvalue())


def write_zip(path, folder, files):
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for name, data in files.items():
            about = zipfile.ZipInfo(f"{folder}/{name}", time.gmtime(EPOCH)[:6])
            about.compress_type, about.external_attr, about.create_system = zipfile.ZIP_DEFLATED, mode_of(name) << 16, 3
            archive.writestr(about, data, compresslevel=9)


def main(packages, version, target, module, tested):
    folder = f"foresee-{version}-{target}"
    files = contents(version, target, Path(module), tested)
    if target.startswith("win32"):
        write_zip(Path(packages) / f"{folder}.zip", folder, files)
    else:
        write_tar(Path(packages) / f"{folder}.tar.gz", folder, files)


if __name__ == "__main__":
    main(*sys.argv[1:])
