"""Puts the module into the wheel, and says for which machines it is good. The rest is pyproject.toml.

    FORESEE_MODULE=…/foresee.so FORESEE_VERSION=0.2.0 python3 -m build --wheel --no-isolation
    FORESEE_TARGET=win32-x64 FORESEE_MODULE=…/foresee.dll …     # the tag of a target, which the module must suit

ext/hosts/pack.sh does so with the module of the release build, or with one that it is given.
"""
import os
import shutil
import sys
from pathlib import Path

from setuptools import setup
from setuptools.command.build_py import build_py
from setuptools.dist import Distribution
from wheel.bdist_wheel import bdist_wheel

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from machine import wheel_tag  # noqa: E402

MODULE = Path(os.environ["FORESEE_MODULE"]).resolve()
TAG = wheel_tag(MODULE, os.environ.get("FORESEE_TARGET") or None)


class BuildWithModule(build_py):
    def run(self):
        super().run()
        target = Path(self.build_lib) / "foresee"
        target.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(MODULE, target / f"foresee{MODULE.suffix}")


class AnyPython(bdist_wheel):
    """The module is SQLite's, not Python's: one wheel serves all versions of Python."""

    def get_tag(self):
        return "py3", "none", TAG


class WithMachineCode(Distribution):
    def has_ext_modules(self):
        return True


setup(version=os.environ["FORESEE_VERSION"], distclass=WithMachineCode,
      cmdclass={"build_py": BuildWithModule, "bdist_wheel": AnyPython})
