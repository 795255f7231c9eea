"""What foresee.so gives to the process that loads it, and what it asks for."""
import re
import subprocess
import unittest

from house import EXTENSION, main


def lines_of(*command):
    return subprocess.run(command, check=True, text=True, capture_output=True).stdout.splitlines()


class SharedObject(unittest.TestCase):
    def test_exports_its_entry_point_only(self):
        names = [line.split()[-1] for line in lines_of("nm", "-D", "--defined-only", str(EXTENSION))]
        self.assertEqual(names, ["sqlite3_foresee_init"])

    def test_calls_sqlite_through_the_table_it_is_handed(self):
        undefined = [line.split()[-1] for line in lines_of("nm", "-D", "--undefined-only", str(EXTENSION))]
        self.assertTrue(undefined)
        self.assertEqual([name for name in undefined if name.startswith("sqlite3")], [])

    def test_needs_no_library_beyond_those_of_the_compiler(self):
        needed = {re.split(r"\.so|-vdso", line.split()[0].rsplit("/", 1)[-1])[0] for line in lines_of("ldd", str(EXTENSION))}
        self.assertIn("libc", needed)
        self.assertLessEqual(needed, {"libstdc++", "libm", "libgcc_s", "libc", "linux", "ld-linux-x86-64", "ld-linux-aarch64"})


if __name__ == "__main__":
    main()
