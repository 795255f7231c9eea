"""Go: the programs of docs/hosts/go.md over an installed prefix that was moved, linked and loaded, with Debian's packages alone."""
import shutil
import tempfile
from pathlib import Path

from hosts import blocks, main, run, skip, version
from installed import MODULES_OF_THE_SYSTEM, Installed

GO = Path("/usr/bin/go")
DRIVER = Path("/usr/share/gocode/src/github.com/mattn/go-sqlite3")


class Go(Installed):
    what = "the package of Go"
    commands = ("cmake", "c++", "cc", "pkg-config")

    @classmethod
    def setUpClass(cls):
        if not GO.exists() or not (DRIVER / "go.mod").exists():
            skip(cls.what, "there is no golang-go of Debian with golang-github-mattn-go-sqlite3-dev")
        print(f"with {run(GO, 'version').strip()} of {GO}", flush=True)
        cls.built = Path(tempfile.mkdtemp(prefix="foresee-hosts-"))
        cls.addClassCleanup(shutil.rmtree, cls.built)

    def setUp(self):
        super().setUp()
        self.project = self.folder / "fleet"
        self.package = self.prefix / "share/foresee/go"

    def lines(self, script, fails=False, **environment):
        """Shell lines in the project, without network: go is Debian's, and `go get` gives way to the page's lines for Debian."""
        script = script.replace("/usr/share/foresee/go", str(self.package))
        script = script.replace("go get github.com/mattn/go-sqlite3\n", blocks("go.md", "sh debian")[0])
        return run("sh", "-e", "-c", f"go() {{ {GO} \"$@\"; }}\n{script}", folder=self.project, fails=fails, **{
            "GOPROXY": "off", "GOFLAGS": "", "GO111MODULE": "", "GOPATH": str(self.folder / "gopath"), "GOCACHE": str(self.built),
            "PKG_CONFIG_PATH": str(self.library / "pkgconfig"), **environment})

    def program(self, kind):
        self.write("fleet/main.go", blocks("go.md", f"go {kind}")[0])

    def start(self):
        """The page's lines but the last, which runs the program."""
        *lines, last = blocks("go.md", "sh linked")[0].splitlines(keepends=True)
        self.assertTrue(last.startswith("go run "))
        self.lines("".join(lines))
        return last

    def test_linked_the_program_needs_no_module(self):
        self.program("linked")
        last = self.start()
        self.assertEqual(self.lines(last), blocks("go.md", "text")[0])
        self.lines("go vet -tags libsqlite3 . foresee\ngo build -tags libsqlite3 -o fleet .")
        self.assertNotIn("foresee.so", run("ldd", self.project / "fleet"))

    def test_every_connection_of_the_pool_has_it(self):
        self.program("linked")
        main_go = self.project / "main.go"
        main_go.write_text(main_go.read_text().replace("rows, err := db.Query(", "held, _ := db.Query(\"SELECT 1\")\n\tdefer held.Close()\n"
                                                       "\theld.Next()\n\trows, err := db.Query("))
        self.assertEqual(self.lines(self.start()), blocks("go.md", "text")[0])

    def test_loaded_the_module_is_opened(self):
        self.program("loaded")
        last = self.start()
        if not MODULES_OF_THE_SYSTEM:
            self.assertIn("foresee.so: cannot open shared object file", self.lines(last, fails=True, LD_LIBRARY_PATH=""))
        self.assertRegex(self.lines(last, LD_LIBRARY_PATH=str(self.library)), rf"^foresee {version()}")

    def test_a_missing_archive_is_named(self):
        self.program("linked")
        said = self.lines(self.start(), fails=True, PKG_CONFIG_PATH="", PKG_CONFIG_LIBDIR="/nothing")
        self.assertIn("Package foresee was not found in the pkg-config search path", said)

    def test_it_is_formatted(self):
        self.assertEqual(run("/usr/bin/gofmt", "-l", self.package), "")
        for kind in ("linked", "loaded"):
            self.program(kind)
            self.assertEqual(run("/usr/bin/gofmt", "-l", self.project), "")


if __name__ == "__main__":
    main()
