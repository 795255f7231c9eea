"""Stand-ins for the modules of other targets: the headers from which their machine is read, and no code.

    pack("wheel", "win32-x64", folder)      # ext/hosts/pack.sh around a stand-in; the package is in folder
"""
import struct
import sys

from hosts import ROOT, run

sys.path.insert(0, str(ROOT / "ext/hosts"))
sys.dont_write_bytecode = True
from machine import machine_of, targets as table  # noqa: E402,F401

HERE = machine_of("/usr/bin/python3").target     # of this machine
LINUX = {"x64": 62, "arm64": 183}
WINDOWS = {"x64": 0x8664, "arm64": 0xAA64}
DARWIN = {"x64": 0x01000007, "arm64": 0x0100000C}


def stand_in(target, oldest=None):
    """The bytes; `oldest`: of its glibc or macOS, as a text in the form of the table's wheel tag: 2_17."""
    system, cpu, *libc = target.split("-")
    if system == "linux":
        needs = f"libc.so.6\0GLIBC_{(oldest or '2_17').replace('_', '.')}\0" if libc == ["gnu"] else "libc.so\0"
        return b"\x7fELF\2\1\1".ljust(18, b"\0") + struct.pack("<H", LINUX[cpu]) + b"\0" * 44 + needs.encode()
    if system == "win32":
        return b"MZ".ljust(60, b"\0") + struct.pack("<I4sH", 64, b"PE\0\0", WINDOWS[cpu])
    major, minor = map(int, (oldest or "13_0").split("_"))
    return struct.pack("<8I", 0xFEEDFACF, DARWIN[cpu], 0, 6, 1, 24, 0, 0) + struct.pack("<6I", 0x32, 24, 1, major << 16 | minor << 8, 0, 0)


def pack(host, target, folder, module_of=None, oldest=None, fails=False):
    """What `pack.sh HOST TARGET MODULE` prints, MODULE being a stand-in of `module_of` or of the target."""
    module = folder / "modules" / target / table()[target]["module"]
    module.parent.mkdir(parents=True, exist_ok=True)
    module.write_bytes(stand_in(module_of or target, oldest))
    return run("bash", ROOT / "ext/hosts/pack.sh", host, target, module, fails=fails, FORESEE_PACKAGES=str(folder))
