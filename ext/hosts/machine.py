#!/usr/bin/python3
"""The machines that a binary of foresee runs on, read from its headers and compared with the table of targets.

    python3 ext/hosts/machine.py foresee.so                   # its target: linux-x64-gnu
    python3 ext/hosts/machine.py foresee.so linux-x64-gnu     # that target's wheel tag; status 1 and a line if it does not suit it

    machine_of(path)              # Machine(target="linux-x64-gnu", oldest=(2, 17)): the oldest glibc, the oldest macOS
    wheel_tag(path)               # manylinux_2_17_x86_64, as the file needs it
    wheel_tag(path, target)       # the table's tag; ValueError if the file does not suit it

Read: the magic number and the CPU of ELF, PE and Mach-O, the versioned symbols of glibc and libstdc++, and the minimum macOS.
"""
import re
import struct
import sys
from collections import namedtuple
from pathlib import Path

TARGETS = Path(__file__).resolve().parent / "release/targets"

# The glibc of the distributions that came with such a libstdc++, as the manylinux policies have it.
GLIBC_OF_GLIBCXX = {29: 34, 30: 35}
ELF_CPU = {62: "x64", 183: "arm64"}
PE_CPU = {0x8664: "x64", 0xAA64: "arm64"}
MACH_CPU = {0x01000007: "x64", 0x0100000C: "arm64"}
LC_VERSION_MIN_MACOSX, LC_BUILD_VERSION = 0x24, 0x32

Machine = namedtuple("Machine", "target oldest")


def targets():
    """The table, {target: {column: value}}."""
    header, *rows = [line.split() for line in TARGETS.read_text().splitlines() if line.strip() and not line.startswith("#")]
    return {row[0]: dict(zip(header, row)) for row in rows}


def newest_symbol(binary, prefix):
    """The largest n of the versions `prefix`n that the file needs."""
    return max((int(n) for n in re.findall(prefix + rb"(\d+)\0", binary)), default=0)


def elf_machine(binary):
    cpu = ELF_CPU.get(struct.unpack_from("<H", binary, 18)[0], "cpu")
    if b"\0libc.so.6\0" not in binary:
        return Machine(f"linux-{cpu}-musl", (1, 2))
    glibcxx = newest_symbol(binary, rb"GLIBCXX_3[.]4[.]")
    of_library = 0 if glibcxx == 0 else GLIBC_OF_GLIBCXX.get(glibcxx, 34 if glibcxx < 29 else 36)
    return Machine(f"linux-{cpu}-gnu", (2, max(newest_symbol(binary, rb"GLIBC_2[.]"), of_library)))


def mach_machine(binary):
    cpu, commands = struct.unpack_from("<I", binary, 4)[0], struct.unpack_from("<I", binary, 16)[0]
    place, oldest = 32, (0, 0)
    for _ in range(commands):
        command, size = struct.unpack_from("<II", binary, place)
        if command in (LC_BUILD_VERSION, LC_VERSION_MIN_MACOSX):
            minimum = struct.unpack_from("<I", binary, place + (12 if command == LC_BUILD_VERSION else 8))[0]
            oldest = (minimum >> 16, minimum >> 8 & 255)
        place += size
    return Machine(f"darwin-{MACH_CPU.get(cpu, 'cpu')}", oldest)


def machine_of(path):
    binary = Path(path).read_bytes()
    if binary[:4] == b"\x7fELF":
        return elf_machine(binary)
    if binary[:4] == b"\xcf\xfa\xed\xfe":
        return mach_machine(binary)
    header = struct.unpack_from("<I", binary, 60)[0] if binary[:2] == b"MZ" else 0
    if header and binary[header:header + 4] == b"PE\0\0":
        return Machine(f"win32-{PE_CPU.get(struct.unpack_from('<H', binary, header + 4)[0], 'cpu')}", (0, 0))
    raise ValueError(f"{path}: neither ELF, PE nor Mach-O; give a module of foresee")


def tag_of(machine):
    system, cpu, *libc = machine.target.split("-")
    cpu_of_linux = {"x64": "x86_64", "arm64": "aarch64"}.get(cpu, cpu)
    oldest = "_".join(map(str, machine.oldest))
    if system == "linux":
        return f"{'manylinux' if libc == ['gnu'] else 'musllinux'}_{oldest}_{cpu_of_linux}"
    if system == "darwin":
        return f"macosx_{oldest}_{'x86_64' if cpu == 'x64' else cpu}"
    return {"x64": "win_amd64", "arm64": "win_arm64"}.get(cpu, "win_unknown")


def oldest_of_tag(tag):
    numbers = re.match(r"[a-z]+_(\d+)_(\d+)_", tag)
    return tuple(map(int, numbers.groups())) if numbers else (0, 0)


def wheel_tag(path, target=None):
    machine = machine_of(path)
    if target is None:
        return tag_of(machine)
    table = targets()
    if target not in table:
        raise ValueError(f"{target}: not a target; write one of {', '.join(table)}")
    tag = table[target]["wheel"]
    if machine.target != target:
        raise ValueError(f"{path}: built for {machine.target}, not for {target}")
    if machine.oldest > oldest_of_tag(tag):
        raise ValueError(f"{path}: needs {'.'.join(map(str, machine.oldest))}, newer than {tag}; build it with the preset of {target}")
    return tag


if __name__ == "__main__":
    try:
        print(wheel_tag(*sys.argv[1:]) if len(sys.argv) > 2 else machine_of(sys.argv[1]).target)
    except ValueError as error:
        sys.exit(str(error))
