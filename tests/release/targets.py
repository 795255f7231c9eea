"""The targets of a release as tests see them: their line of ext/hosts/release/targets, and how a program runs there.

    target = Target("linux-arm64-gnu")
    rows = target.run_script(module, database, script)        # the lines of tests/release/run_script.c, run by qemu

What a target needs is in build/roots (ext/hosts/release/fetch_roots.sh). A program that ends by a signal or with
another status than 0 is an error, whatever it has printed before.
"""
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
ROOTS = ROOT / "build/roots"
SQLITE = ROOT / "build/sqlite_newest"
SCRIPTS = ROOT / "tests/release"
BUILT = Path(os.environ.get("FORESEE_TARGETS", ROOT / "build/targets"))
WINE = shutil.which("wine64") or "/usr/lib/wine/wine64"
SQLITE_FLAGS = ["-O1", "-w", "-ffp-contract=off", "-DSQLITE_THREADSAFE=1", "-DSQLITE_ENABLE_MATH_FUNCTIONS", "-DNDEBUG"]


class Failed(Exception):
    """A program did not do on a target what it does elsewhere."""


def table():
    """Each target's line: {name: {column: value}}; what is "-" is None, lists are split."""
    lines = [line.split() for line in (ROOT / "ext/hosts/release/targets").read_text().splitlines()]
    found = {}
    for values in lines[1:]:
        line = {column: None if value == "-" else value for column, value in zip(lines[0], values, strict=True)}
        line["needed"] = line["needed"].split(",")
        found[line["target"]] = line
    return found


def run(*command, **options):
    """What a command prints; an error quotes its end."""
    done = subprocess.run([str(part) for part in command], stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=1200, **options)
    if done.returncode != 0:
        said = (done.stdout[-500:] + done.stderr[-2000:]).decode(errors="replace")
        raise Failed(f"{' '.join(map(str, command))}\nended with status {done.returncode}:\n{said}")
    return done.stdout.decode()


class Target:
    def __init__(self, name):
        self.name = name
        self.line = table()[name]
        self.folder = BUILT / name
        self.module = self.folder / self.line["module"]

    def runner(self):
        """The words before a program's name."""
        kind = self.line["runner"]
        if kind == "qemu":
            root = "arm64" if self.line["npm_libc"] == "glibc" else "musl-arm64"
            return ["qemu-aarch64-static", "-L", ROOTS / root]
        if kind == "musl":
            return [ROOTS / "musl-x64/lib/ld-musl-x86_64.so.1"]
        return [WINE] if kind == "wine" else []

    def environment(self):
        if self.line["runner"] != "wine":
            return dict(os.environ)
        return {**os.environ, "WINEPREFIX": str(ROOTS / "wine"), "WINEDEBUG": "-all", "WINEDLLOVERRIDES": "mscoree,mshtml=", "DISPLAY": ""}

    def why_not(self):
        """Why this machine cannot run the target's programs; None if it can."""
        if self.line["runner"] == "none":
            return f"nothing here runs {self.name}"
        program = str(self.runner()[0]) if self.runner() else "gcc"
        if shutil.which(program) is None:
            return f"there is no {program}"
        return None if (SQLITE / "sqlite3.c").exists() else f"{SQLITE} holds no SQLite"

    def compiler(self):
        """The command that compiles and links a C program for the target."""
        if self.line["toolchain"] == "zig":
            # musl's programs would be linked statically, and load nothing.
            return [ROOTS / "zig/bin/cc", "-target", self.line["triple"], "-g0", *(["-dynamic"] if self.line["npm_libc"] == "musl" else [])]
        if self.line["toolchain"] == "mingw":
            return [f"{self.line['triple']}-gcc-posix", "-static"]
        root = ROOTS / "debian11"
        libraries = root / "usr/lib/x86_64-linux-gnu"
        return ["gcc", f"--sysroot={root}", f"-B{libraries}", f"-L{libraries}", f"-L{root}/lib/x86_64-linux-gnu", "-isystem", "/usr/include",
                "-isystem", "/usr/include/x86_64-linux-gnu"]

    def program(self):
        """tests/release/run_script.c for the target, compiled once."""
        windows = self.line["npm_os"] == "win32"
        program = self.folder / ("run_script.exe" if windows else "run_script")
        sources = [SCRIPTS / "run_script.c", SQLITE / "sqlite3.c"]
        if program.exists() and all(program.stat().st_mtime > source.stat().st_mtime for source in sources):
            return program
        self.folder.mkdir(parents=True, exist_ok=True)
        # The object of SQLite is kept: it is the same whatever run_script.c becomes.
        sqlite = self.folder / "sqlite3.o"
        if not sqlite.exists() or sqlite.stat().st_mtime < sources[1].stat().st_mtime:
            run(*self.compiler(), *SQLITE_FLAGS, "-c", sources[1], "-o", sqlite)
        libraries = [] if windows else ["-ldl", "-lpthread", "-lm"]
        run(*self.compiler(), *SQLITE_FLAGS, "-I", SQLITE, sources[0], sqlite, "-o", program, *libraries)
        return program

    def run_script(self, database, script, module=None):
        """The lines that the script's rows are, runner on the target; paths are taken without ending."""
        module = Path(module or self.module)
        words = [*self.runner(), self.program(), module.with_suffix(""), database, script]
        return run(*words, env=self.environment(), cwd=Path(database).parent).replace("\r", "").splitlines()


class Native(Target):
    """The build of this machine, build/release, with which all others are compared."""

    def __init__(self, module=ROOT / "build/release/foresee.so"):
        super().__init__("linux-x64-gnu")
        self.folder = BUILT / "native"
        self.module = Path(module)

    def compiler(self):
        return ["gcc"]


def differences(expected, found, most=5):
    """What to say of two lists of lines: None if they are equal."""
    if expected == found:
        return None
    said = [f"{len(expected)} lines expected, {len(found)} found"]
    for i, (one, other) in enumerate(zip(expected, found)):
        if one != other and len(said) <= most:
            said.append(f"line {i + 1}: expected {one}\n          found {other}")
    return "\n".join(said)


def smoke(target, native, folder):
    """Asks rows.sql natively and on the target, and reads each other's file. Returns the number of rows compared."""
    compared = 0

    def compare(what, expected, found):
        nonlocal compared
        said = differences(expected, found)
        if said:
            raise Failed(f"{target.name}: {what} differs from the native build: {said}")
        compared += len(found)

    files = {runner: folder / f"{runner.folder.name}.db" for runner in (native, target)}
    compare("rows.sql", *(runner.run_script(files[runner], SCRIPTS / "rows.sql") for runner in (native, target)))
    # Each changes the file of the other, then both read both.
    answers = []
    for written, changes in ((native, target), (target, native)):
        changes.run_script(files[written], SCRIPTS / "change.sql")
        answers += [reads.run_script(files[written], SCRIPTS / "check.sql") for reads in (native, target)]
    if any("ok" != answer[-1] or any(line.startswith("error") for line in answer) for answer in answers):
        raise Failed(f"{target.name}: a file is not whole: {[line for answer in answers for line in answer if 'error' in line][:3]}")
    for answer in answers[1:]:
        compare("check.sql of a file that was changed", answers[0], answer)
    return compared


def main(names):
    """python3 tests/release/targets.py TARGET...: smoke-tests build/targets/TARGET and prints how many rows were compared."""
    for name in names:
        target = Target(name)
        why = target.why_not()
        if why:
            print(f"SKIPPED: {name}, because {why}", flush=True)
            return 77
        with tempfile.TemporaryDirectory(prefix="foresee-release-") as folder:
            try:
                print(f"{name}: {target.line['runner']}, {smoke(target, Native(), Path(folder))} rows compared", flush=True)
            except Failed as failure:
                print(failure, file=sys.stderr)
                return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
