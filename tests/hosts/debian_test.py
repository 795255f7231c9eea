"""The Debian packages: unpacked and, by root, really installed; `.load foresee` works from another folder."""
import gzip
import os

from hosts import MEETING, ROOT, Host, blocks, main, need_commands, packed, run, skip, version

MODULE = "libsqlite3-mod-foresee"


class Debian(Host):
    def setUp(self):
        super().setUp()
        need_commands("the Debian packages", "dpkg", "dpkg-deb", "sqlite3")
        self.module = packed("the Debian packages", f"{MODULE}_*.deb")
        self.dev = packed("the Debian packages", "libforesee-dev_*.deb")
        self.session = blocks("debian.md", "sql")[0]
        self.answer = blocks("debian.md", "text")[0]

    def unpack(self, *packages):
        for package in packages:
            run("dpkg", "-x", package, self.folder / "root")
        return next((self.folder / "root/usr/lib").rglob("foresee.so")).parent

    def shell(self, **environment):
        """The page's session, typed in a folder that has nothing to do with it."""
        session = self.write("elsewhere/session.sql", self.session)
        return run("sh", "-c", f'sqlite3 -batch -box -init {os.devnull} :memory: < "$0"', session, folder=session.parent, **environment)

    def test_unpacked_it_loads_by_its_name(self):
        library = self.unpack(self.module)
        self.assertEqual(self.shell(LD_LIBRARY_PATH=str(library)), self.answer)

    def test_installed_it_loads_by_its_name(self):
        if os.geteuid() != 0:
            skip("installing the Debian package", "only root may")
        if run("sh", "-c", f"dpkg-query -W {MODULE} 2>/dev/null || true"):
            skip("installing the Debian package", "it is installed already")
        self.addCleanup(run, "dpkg", "--purge", MODULE)
        run("dpkg", "-i", self.module)
        self.assertEqual(self.shell(), self.answer)
        self.assertIn("foresee", run("sh", "-c", f"dpkg -L {MODULE} | grep man3"))

    def test_programs_are_built_with_the_dev_package(self):
        need_commands("programs with libforesee-dev", "cc", "pkg-config")
        library = self.unpack(self.module, self.dev)
        source = self.write("embed_sqlite.c", (ROOT / "docs/examples/embed_sqlite.c").read_text())
        run("sh", "-c", 'cc "$0" -o program $(pkg-config --cflags --libs foresee)', source, folder=self.folder,
            PKG_CONFIG_PATH=str(library / "pkgconfig"))
        self.assertEqual(run(self.folder / "program"), MEETING)

    def test_they_say_what_they_are(self):
        for package, wanted in ((self.module, "libstdc++6"), (self.dev, f"{MODULE} (= {version()}-1), libsqlite3-dev")):
            self.assertTrue(run("dpkg-deb", "-f", package, "Version").startswith(version()))
            self.assertIn(wanted, run("dpkg-deb", "-f", package, "Depends"))
            self.assertGreater(len(run("dpkg-deb", "-f", package, "Description").splitlines()), 3)
        self.unpack(self.module)
        documents = self.folder / "root/usr/share/doc" / MODULE
        self.assertEqual(gzip.decompress((documents / "changelog.gz").read_bytes()), (ROOT / "CHANGELOG.md").read_bytes())
        self.assertIn("Permission is hereby granted", (documents / "copyright").read_text())

    def test_the_module_is_stripped(self):
        need_commands("that the module is stripped", "nm")
        self.assertIn("no symbols", run("nm", self.unpack(self.module) / "foresee.so"))


if __name__ == "__main__":
    main()
