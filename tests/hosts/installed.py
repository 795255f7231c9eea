"""`cmake --install` into a prefix that is then moved: what programs that use it begin with."""
import re
import shutil
from pathlib import Path

from hosts import BUILD, MEETING, ROOT, Host, blocks, need_commands, run, skip

MODULES_OF_THE_SYSTEM = sorted(Path("/usr/lib").glob("*/foresee.so"))    # those of an installed Debian package


def wanted_headers():
    """The headers that programs include."""
    return re.search(r"set\(wanted\n([^)]*)\)", (ROOT / "ext/hosts/cmake/install_headers.cmake").read_text()).group(1).split()


class Installed(Host):
    what = "the installed files"
    commands = ("cmake", "c++", "cc")

    def setUp(self):
        super().setUp()
        need_commands(self.what, *self.commands)
        if not (BUILD / "ext/libforesee.a").exists():
            skip(self.what, f"{BUILD} is not built")
        self.said = run("cmake", "--install", BUILD, "--prefix", self.folder / "before")
        self.prefix = self.folder / "moved" / "here"
        self.prefix.parent.mkdir()
        shutil.move(self.folder / "before", self.prefix)
        self.library = next(self.prefix.rglob("foresee.so")).parent

    def write_programs(self):
        """The page's programs, under the names by which its CMake and shell lines know them."""
        for example in ("embed_sqlite.c", "embed_core.cpp"):
            self.write(example, (ROOT / "docs/examples" / example).read_text())
        self.write("load_module.c", blocks("c.md", "c")[0])

    def check_programs(self, folder):
        self.assertEqual(run(folder / "embed_sqlite"), MEETING)
        self.assertEqual(run(folder / "embed_core"), MEETING)
        self.assertRegex(run(folder / "load_module"), r"^foresee \d+\.\d+\.\d+")
