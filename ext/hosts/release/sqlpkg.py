#!/usr/bin/python3
"""Writes sqlpkg.json, by which the package manager sqlpkg finds the binaries of a release, and the archives that it names.

    FORESEE_RELEASE_URL=https://…/releases/download/v0.2.0 python3 ext/hosts/release/sqlpkg.py FOLDER VERSION

FOLDER holds the archives foresee-VERSION-TARGET.tar.gz or .zip. sqlpkg unpacks no folders, so that for each of them an archive
foresee-VERSION-sqlpkg-TARGET.zip is written, flat: the module and the licences. sqlpkg does not know musl. FORESEE_OWNER is
the first half of the package's name there; with SOURCE_DATE_EPOCH the same release gives the same bytes.
"""
import hashlib
import json
import os
import sys
import tarfile
import time
import zipfile
from pathlib import Path

HOSTS = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(HOSTS))
sys.dont_write_bytecode = True
from machine import targets  # noqa: E402

SYSTEMS = {"linux": "linux", "darwin": "darwin", "win32": "windows"}
CPUS = {"x64": "amd64", "arm64": "arm64"}
TAKEN = ("LICENSE", "THIRD_PARTY", "UNTESTED")


def platform_of(target):
    """sqlpkg's name, None for musl."""
    system, cpu, *libc = target.split("-")
    return f"{SYSTEMS[system]}-{CPUS[cpu]}" if libc in ([], ["gnu"]) else None


def files_in(archive):
    """{name without folder: bytes}."""
    if archive.suffix == ".zip":
        with zipfile.ZipFile(archive) as files:
            return {Path(name).name: files.read(name) for name in files.namelist() if not name.endswith("/")}
    with tarfile.open(archive) as files:
        return {Path(member.name).name: files.extractfile(member).read() for member in files if member.isfile()}


def write_flat(path, files):
    when = time.gmtime(max(int(os.environ.get("SOURCE_DATE_EPOCH", "0")), 315532800))[:6]    # zip starts in 1980
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for name in sorted(files):
            about = zipfile.ZipInfo(name, when)
            about.external_attr = 0o644 << 16
            archive.writestr(about, files[name], zipfile.ZIP_DEFLATED)


def write(folder, version, url):
    about = json.loads((HOSTS / "npm/package.json").read_text())
    assets = {"path": url.rstrip("/"), "files": {}, "checksums": {}}
    for target, row in targets().items():
        platform = platform_of(target)
        archives = [folder / f"foresee-{version}-{target}.{ending}" for ending in ("tar.gz", "zip")]
        archive = next((path for path in archives if path.exists()), None)
        if platform is None or archive is None:
            continue
        files = files_in(archive)
        flat = folder / f"foresee-{version}-sqlpkg-{target}.zip"
        write_flat(flat, {name: files[name] for name in (row["module"], *TAKEN) if name in files})
        assets["files"][platform] = flat.name
        assets["checksums"][flat.name] = "sha256-" + hashlib.sha256(flat.read_bytes()).hexdigest()
    if not assets["files"]:
        raise ValueError(f"{folder}: holds no archive foresee-{version}-TARGET that sqlpkg knows; pack the release first")
    repository, found, _ = url.partition("/releases/download/")
    package = {"owner": os.environ.get("FORESEE_OWNER", "foresee"), "name": "foresee", "version": version,
               **({"homepage": repository, "repository": repository} if found else {}),
               "license": about["license"], "description": about["description"], "keywords": about["keywords"], "assets": assets}
    (folder / "sqlpkg.json").write_text(json.dumps(package, indent=2) + "\n")


if __name__ == "__main__":
    address = os.environ.get("FORESEE_RELEASE_URL")
    if not address:
        sys.exit("sqlpkg.py: set FORESEE_RELEASE_URL to the address of the release's files")
    try:
        write(Path(sys.argv[1]), sys.argv[2], address)
    except ValueError as error:
        sys.exit(str(error))
