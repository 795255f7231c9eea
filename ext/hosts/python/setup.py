"""Puts the module into the wheel, and says for which machines it is good. The rest is pyproject.toml.

    FORESEE_MODULE=…/foresee.so FORESEE_VERSION=0.2.0 python3 -m build --wheel --no-isolation

ext/hosts/pack.sh does so with the release build's module.
"""
import os
import platform
import re
import shutil
from pathlib import Path

from setuptools import setup
from setuptools.command.build_py import build_py
from setuptools.dist import Distribution
from wheel.bdist_wheel import bdist_wheel

MODULE = Path(os.environ["FORESEE_MODULE"]).resolve()
# The glibc of the distributions that came with such a libstdc++, as the manylinux policies have it.
GLIBC_OF_GLIBCXX = {29: 34, 30: 35}


def newest(symbol):
    """The largest n of the versions `symbol`n that the module asks for."""
    return max((int(n) for n in re.findall(symbol.encode() + rb"(\d+)\0", MODULE.read_bytes())), default=0)


def platform_tag():
    glibcxx = newest(r"GLIBCXX_3\.4\.")
    here = int(platform.libc_ver()[1].split(".")[1])
    of_library = GLIBC_OF_GLIBCXX.get(glibcxx, 34 if glibcxx < 29 else here)
    return f"manylinux_2_{max(newest('GLIBC_2[.]'), of_library)}_{platform.machine()}"


class BuildWithModule(build_py):
    def run(self):
        super().run()
        target = Path(self.build_lib) / "foresee"
        target.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(MODULE, target / "foresee.so")


class AnyPython(bdist_wheel):
    """The module is SQLite's, not Python's: one wheel serves all versions of Python."""

    def get_tag(self):
        return "py3", "none", platform_tag()


class WithMachineCode(Distribution):
    def has_ext_modules(self):
        return True


setup(version=os.environ["FORESEE_VERSION"], distclass=WithMachineCode,
      cmdclass={"build_py": BuildWithModule, "bdist_wheel": AnyPython})
