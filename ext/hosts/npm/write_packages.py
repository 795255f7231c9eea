#!/usr/bin/python3
"""Writes the folders of the npm packages: `foresee`, which is JavaScript, and one package per target, which is one file.

    python3 ext/hosts/npm/write_packages.py STAGE VERSION TARGET MODULE     # STAGE/foresee and STAGE/foresee-TARGET

ext/hosts/pack.sh packs them. A file THIRD_PARTY beside MODULE goes into the package of the target.

`foresee` lists no optionalDependencies: npm would fetch whatever a stranger has published under such a name. As soon as the
names belong to this project, `packages` in its package.json are these dependencies.
"""
import json
import shutil
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from machine import targets  # noqa: E402

LICENSE = HERE.parents[2] / "LICENSE"
CHOSEN = ("index.cjs", "index.mjs", "index.d.ts", "README.md")


def name_of(target):
    return f"foresee-{target}"


def write(folder, about, *files):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for file in (*files, LICENSE):
        shutil.copyfile(file, folder / Path(file).name)
    (folder / "package.json").write_text(json.dumps(about, indent=2) + "\n")


def write_javascript(stage, version):
    about = json.loads((HERE / "package.json").read_text())
    packages = {target: name_of(target) for target in targets()}
    write(stage / "foresee", {**about, "version": version, "packages": packages}, *(HERE / name for name in CHOSEN))


def write_target(stage, version, target, module):
    row, name = targets()[target], name_of(target)
    shared = json.loads((HERE / "package.json").read_text())
    about = {"name": name, "version": version, "description": f"The module of foresee for {target}; the package foresee loads it",
             **{key: shared[key] for key in ("license", "keywords", "engines")},
             "files": [row["module"], "THIRD_PARTY"], "preferUnplugged": True, "os": [row["npm_os"]], "cpu": [row["npm_cpu"]]}
    if row["npm_libc"] != "-":
        about["libc"] = [row["npm_libc"]]
    third_party = module.parent / "THIRD_PARTY"
    folder = stage / name
    write(folder, about, *([third_party] if third_party.exists() else []))
    shutil.copyfile(module, folder / row["module"])
    (folder / "README.md").write_text(
        f"# {name}\n\nThe SQLite extension foresee, built for {target}. Install it beside the package `foresee` of the same version,\n"
        "which finds and loads it.\n")


if __name__ == "__main__":
    stage, version, target, module = sys.argv[1:]
    write_javascript(Path(stage), version)
    write_target(Path(stage), version, target, Path(module))
