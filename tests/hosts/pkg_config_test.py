"""pkg-config from a prefix that was moved: the lines of docs/hosts/c.md build its programs."""
from hosts import blocks, main, run, version
from installed import Installed


class PkgConfig(Installed):
    what = "pkg-config"
    commands = ("cmake", "c++", "cc", "pkg-config")

    def test_the_lines_of_the_page(self):
        self.write_programs()
        path = str(self.library / "pkgconfig")
        run("sh", "-e", "-c", blocks("c.md", "sh")[0], folder=self.folder, PKG_CONFIG_PATH=path)
        self.check_programs(self.folder)
        for name in ("foresee", "foresee-core"):
            self.assertEqual(run("pkg-config", "--modversion", name, PKG_CONFIG_PATH=path).strip(), version())
            self.assertEqual(run("pkg-config", "--validate", name, PKG_CONFIG_PATH=path), "")


if __name__ == "__main__":
    main()
