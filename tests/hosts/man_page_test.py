"""The installed man page names its version, and groff finds no fault in it. Its functions: tests/house/reference_test.py."""
from hosts import main, need_commands, run, version
from installed import Installed


class ManPage(Installed):
    what = "the man page"
    commands = ("cmake",)

    def setUp(self):
        super().setUp()
        self.page = (self.prefix / "share/man/man3/foresee.3").read_text()

    def test_it_names_the_version(self):
        self.assertIn(f"foresee {version()}", self.page)

    def test_it_is_a_man_page_without_fault(self):
        need_commands("groff's look at the man page", "groff")
        self.assertEqual(run("groff", "-man", "-Tutf8", "-ww", "-z", self.prefix / "share/man/man3/foresee.3"), "")


if __name__ == "__main__":
    main()
