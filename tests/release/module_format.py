"""What a module of any target exports, needs and is: read from ELF, PE or Mach-O, and compared with the target's line.

    python3 tests/release/module_format.py linux-arm64-gnu     # build/targets/linux-arm64-gnu/foresee.so is as it should be

Allowed are the libraries that the table lists, no newer glibc than it names, one exported name, three megabytes packed.
"""
import gzip
import re
import struct
import subprocess
import sys
from dataclasses import dataclass, field
from pathlib import Path

from targets import Failed, Target, run

ENTRY = "sqlite3_foresee_init"
MOST_BYTES_PACKED = 3_000_000
# zig's linker for macOS exports these whatever it is told: its own marks, and the weak operators of libc++abi.
ALWAYS_ON_MACOS = re.compile(r"_Z[nd][wal]|__dso_handle$|_mh_dylib_header$")


@dataclass
class Format:
    machine: str
    exported: list = field(default_factory=list)
    needed: list = field(default_factory=list)
    glibc: tuple = (0,)
    minimum_system: str = ""
    signed: bool = False
    name: str = ""


def elf(path):
    said = run("readelf", "-W", "-h", "-d", "--dyn-syms", path)
    names = [line.split() for line in said.splitlines() if re.match(r" *\d+: [0-9a-f]+ ", line)]
    versions = [tuple(map(int, text.split("."))) for text in re.findall(r"@GLIBC_([0-9.]+)", said)]
    return Format(machine={62: "x64", 183: "arm64"}[struct.unpack_from("<H", path.read_bytes(), 18)[0]],
                  exported=[name[7].split("@")[0] for name in names if len(name) > 7 and name[6] != "UND"],
                  needed=re.findall(r"\(NEEDED\).*\[(.*)\]", said), glibc=max(versions, default=(0,)))


def text_at(data, place):
    return data[place:data.index(b"\0", place)].decode()


def pe(path):
    data = path.read_bytes()
    header = struct.unpack_from("<I", data, 60)[0]
    machine, sections = struct.unpack_from("<HH", data, header + 4)
    optional = header + 24
    table = optional + struct.unpack_from("<H", data, header + 20)[0]

    def at(address):
        for i in range(sections):
            size, start, _, raw = struct.unpack_from("<IIII", data, table + 40 * i + 8)
            if start <= address < start + size:
                return address - start + raw
        raise Failed(f"{path}: no section holds address {address}")

    exports, _, imports = struct.unpack_from("<III", data, optional + 112)
    found = Format(machine={0x8664: "x64"}[machine])
    count, _, names = struct.unpack_from("<III", data, at(exports) + 24)
    found.exported = [text_at(data, at(struct.unpack_from("<I", data, at(names) + 4 * i)[0])) for i in range(count)]
    place = at(imports)
    while (name := struct.unpack_from("<I", data, place + 12)[0]) != 0:
        found.needed.append(text_at(data, at(name)))
        place += 20
    return found


def mach_o(path):
    data = path.read_bytes()
    found = Format(machine={0x01000007: "x64", 0x0100000C: "arm64"}[struct.unpack_from("<I", data, 4)[0]])
    place = 32
    for _ in range(struct.unpack_from("<I", data, 16)[0]):
        command, size = struct.unpack_from("<II", data, place)
        if command == 0x0C:                                         # LC_LOAD_DYLIB
            found.needed.append(text_at(data, place + struct.unpack_from("<I", data, place + 8)[0]))
        elif command == 0x0D:                                       # LC_ID_DYLIB
            found.name = text_at(data, place + struct.unpack_from("<I", data, place + 8)[0])
        elif command == 0x1D:                                       # LC_CODE_SIGNATURE
            found.signed = True
        elif command == 0x32:                                       # LC_BUILD_VERSION
            version = struct.unpack_from("<I", data, place + 12)[0]
            found.minimum_system = f"{version >> 16}.{version >> 8 & 255}"
        elif command in (0x22, 0x80000022, 0x80000033):             # LC_DYLD_INFO(_ONLY), LC_DYLD_EXPORTS_TRIE
            offset, length = struct.unpack_from("<II", data, place + (8 if command == 0x80000033 else 40))
            found.exported = sorted(trie_names(data[offset:offset + length])) if length else []
        place += size
    return found


def trie_names(trie, node=0, prefix=""):
    """The names of a Mach-O export trie, without the underscore that C adds."""
    def number(place):
        value = shift = 0
        while True:
            byte = trie[place]
            value |= (byte & 127) << shift
            place, shift = place + 1, shift + 7
            if byte < 128:
                return value, place

    terminal, place = number(node)
    if terminal:
        yield prefix.removeprefix("_")
    place += terminal
    children = trie[place]
    place += 1
    for _ in range(children):
        edge = text_at(trie, place)
        child, place = number(place + len(edge) + 1)
        yield from trie_names(trie, child, prefix + edge)


def read_format(path):
    return {".so": elf, ".dll": pe, ".dylib": mach_o}[path.suffix](path)


def spills_to_windows_stack(path):
    """Moves of 32 or 64 bytes to the stack as if it were aligned to that, which Windows' is not."""
    code = subprocess.run(["x86_64-w64-mingw32-objdump", "-d", "--no-show-raw-insn", path], stdout=subprocess.PIPE, check=True)
    return re.findall(r"^.*vmov(?:ap[sd]|dqa\w*) .*%[yz]mm.*\(%r[sb]p.*$|^.*vmov(?:ap[sd]|dqa\w*) .*\(%r[sb]p.*%[yz]mm.*$", code.stdout.decode(), re.M)


def faults(target, path):
    """What of a module is not as its line says."""
    line, found = target.line, read_format(Path(path))
    if found.machine != line["npm_cpu"]:
        yield f"it is built for {found.machine}"
    if ENTRY not in found.exported:
        yield f"it does not export {ENTRY}"
    others = [name for name in found.exported if name != ENTRY and not (line["npm_os"] == "darwin" and ALWAYS_ON_MACOS.match(name))]
    if others:
        yield f"it exports {', '.join(others[:5])}"
    if extra := [name for name in found.needed if name not in line["needed"]]:
        yield f"it needs {', '.join(extra)}"
    if line["glibc"] and found.glibc > tuple(map(int, line["glibc"].split("."))):
        yield f"it needs glibc {'.'.join(map(str, found.glibc))}"
    if line["npm_os"] == "darwin":
        oldest = line["wheel"].split("_")[1:3]
        if found.minimum_system != ".".join(oldest):
            yield f"its minimum macOS is {found.minimum_system}"
        if line["npm_cpu"] == "arm64" and not found.signed:         # macOS on Intel loads code without a signature
            yield "it is not signed"
        if found.name != "@rpath/foresee.dylib":
            yield f"it is named {found.name}"
    if line["npm_os"] == "win32" and (spills := spills_to_windows_stack(path)):
        yield f"it moves vectors to the stack as if it were aligned: {spills[0].strip()}"
    if (packed := len(gzip.compress(Path(path).read_bytes(), 9))) > MOST_BYTES_PACKED:
        yield f"it has {packed} bytes packed"


def main(names):
    for name in names:
        target = Target(name)
        if found := list(faults(target, target.module)):
            print(f"{target.module}: {'; '.join(found)}", file=sys.stderr)
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
