"""find_package(foresee) from a prefix that was moved: the programs of docs/hosts/c.md, and the core's headers alone."""
import os
from concurrent.futures import ThreadPoolExecutor

from hosts import blocks, main, run, version
from installed import Installed, wanted_headers


class FindPackage(Installed):
    what = "find_package(foresee)"
    commands = ("cmake", "c++", "cc", "pkg-config")

    def configure(self, text, **options):
        self.write("CMakeLists.txt", text)
        return run("cmake", "-S", self.folder, "-B", self.folder / "build", f"-DCMAKE_PREFIX_PATH={self.prefix}", **options)

    def test_the_programs_of_the_page(self):
        self.write_programs()
        self.configure(blocks("c.md", "cmake")[0])
        run("cmake", "--build", self.folder / "build")
        self.check_programs(self.folder / "build")
        self.assertIn("In the sqlite3 shell: .load " + str(self.folder / "before"), self.said)

    def test_a_component_asks_for_no_more_than_it_needs(self):
        project = "cmake_minimum_required(VERSION 3.21)\nproject(p LANGUAGES C CXX)\n"
        minor = version().rsplit(".", 1)[0]
        no_threads = "set(CMAKE_DISABLE_FIND_PACKAGE_Threads ON)\n"
        self.configure(project + no_threads + f"find_package(foresee {minor} CONFIG REQUIRED COMPONENTS module)")
        said = self.configure(project + no_threads + "find_package(foresee CONFIG REQUIRED COMPONENTS core)", fails=True)
        self.assertIn("Threads", said)
        said = self.configure(project + "find_package(foresee CONFIG REQUIRED COMPONENTS tiles)", fails=True)
        self.assertIn("has the components module, static and core", said)
        said = self.configure(project + "find_package(foresee 7 CONFIG REQUIRED)", fails=True)
        self.assertIn('compatible with requested version "7"', " ".join(said.split()))

    def test_no_file_names_the_prefix_or_the_sources(self):
        for file in self.prefix.rglob("*"):
            if file.suffix in (".cmake", ".pc", ".h", ".3"):
                self.assertNotIn(str(self.folder), file.read_text(), file)
                self.assertNotIn("/ext", file.read_text().replace("sqlite3ext", ""), file)

    def test_headers_of_the_core_compile_alone_without_boost(self):
        """Those that programs include; with FORESEE_LONG=1 all that are installed, which takes a minute."""
        include = self.prefix / "include/foresee"
        headers = sorted(header.relative_to(include).as_posix() for header in include.rglob("*.h"))
        for header in headers:
            self.assertNotIn("boost/", (include / header).read_text(), header)
        listed = wanted_headers()
        self.assertLess(set(listed), set(headers))

        def compile_alone(header):
            alone = self.write(header.replace("/", "_") + ".cpp", f'#include "{header}"\n')
            self.assertEqual(run("c++", "-std=c++20", "-fsyntax-only", "-Wall", f"-I{include}", alone), "", header)

        with ThreadPoolExecutor(os.cpu_count()) as several:
            list(several.map(compile_alone, headers if os.environ.get("FORESEE_LONG") else listed))


if __name__ == "__main__":
    main()
