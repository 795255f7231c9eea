"""The core in other people's builds: every installed header with all warnings, refused options, C-only projects, and the
repository as a part of another project."""
import shutil

from hosts import ROOT, main, run, skip
from installed import Installed, wanted_headers

PROJECT = "cmake_minimum_required(VERSION 3.21)\n"
WARNINGS = ("-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Werror")


class CoreConsumer(Installed):
    what = "programs that use the core"
    commands = ("cmake", "c++", "cc", "pkg-config")

    def setUp(self):
        super().setUp()
        self.include = self.prefix / "include/foresee"
        self.flags = (f"-I{self.include}",)

    def compile(self, compiler, name, text, *options, fails=False):
        return run(compiler, *WARNINGS, *options, *self.flags, self.write(name, text), fails=fails)

    def test_all_headers_together_without_warnings(self):
        headers = sorted(header.relative_to(self.include).as_posix() for header in self.include.rglob("*.h"))
        text = "".join(f'#include "{header}"\n' for header in headers)
        text += """int main() {
  const foresee::JoinQuestion question{.h = 300};
  const foresee::WindowQuestion window{.h = 300};
  const foresee::NearestQuestion nearest{.h = 300};
  const foresee::AvoidQuestion avoid{.h = 300};
  const foresee::Scene scene{.name = "units"};
  return question.h == window.h && nearest.h == avoid.h && scene.size() == 0 && foresee::MemoryTable("units", {.axes = 2}).all()->size() == 0 ? 0 : 1;
}
"""
        for compiler in ("g++", "clang++"):
            if shutil.which(compiler):
                self.assertEqual(self.compile(compiler, "all.cpp", text), "", compiler)

    def test_each_header_refuses_what_breaks_it(self):
        for header in wanted_headers():
            text = f'#include "{header}"\n'
            name = header.replace("/", "_") + ".cpp"
            said = self.compile("c++", name, text, "-ffast-math", "-Wfatal-errors", fails=True)
            self.assertIn("build without -ffast-math", said, header)
        said = self.compile("c++", name, text, "-D_GLIBCXX_DEBUG", fails=True)
        self.assertIn("_GLIBCXX_DEBUG changes std::vector", said)
        self.assertEqual(self.compile("c++", name, text, "-D_GLIBCXX_DEBUG", "-DFORESEE_GLIBCXX_DEBUG"), "")

    def test_the_game(self):
        self.write("game.cpp", (ROOT / "docs/examples/game.cpp").read_text())
        path = str(self.library / "pkgconfig")
        run("sh", "-e", "-c", "c++ -std=c++20 game.cpp -o game $(pkg-config --cflags --libs foresee-core)", folder=self.folder,
            PKG_CONFIG_PATH=path)
        self.assertIn("1 and 2 collide at t=4\n", run(self.folder / "game"))

    def test_a_project_in_c_alone_links_the_archive(self):
        self.write("embed_sqlite.c", (ROOT / "docs/examples/embed_sqlite.c").read_text())
        self.write("CMakeLists.txt", PROJECT + """project(harbour LANGUAGES C)
find_package(foresee CONFIG REQUIRED COMPONENTS static)
find_package(SQLite3 REQUIRED)
add_executable(embed_sqlite embed_sqlite.c)
target_link_libraries(embed_sqlite PRIVATE foresee::static SQLite::SQLite3)
""")
        run("cmake", "-S", self.folder, "-B", self.folder / "build", f"-DCMAKE_PREFIX_PATH={self.prefix}")
        run("cmake", "--build", self.folder / "build")
        self.assertIn("touch after 95 s", run(self.folder / "build/embed_sqlite"))

    def test_the_repository_as_a_part_of_a_project(self):
        """Configured only: a build takes minutes."""
        if not (ROOT / "CMakeLists.txt").exists():
            skip(self.what, "the sources are not here")
        text = PROJECT + f"""project(game LANGUAGES CXX)
add_subdirectory({ROOT} foresee EXCLUDE_FROM_ALL)
add_executable(game game.cpp)
target_link_libraries(game PRIVATE foresee::core)
foreach(target foresee::core foresee::static foresee::module)
  if(TARGET ${{target}})
    message(STATUS "has ${{target}}")
  endif()
endforeach()
"""
        self.write("CMakeLists.txt", text)
        self.write("game.cpp", (ROOT / "docs/examples/game.cpp").read_text())
        said = run("cmake", "-S", self.folder, "-B", self.folder / "with")
        for target in ("core", "static", "module"):
            self.assertIn(f"has foresee::{target}", said)
        said = run("cmake", "-S", self.folder, "-B", self.folder / "without", "-DCMAKE_DISABLE_FIND_PACKAGE_SQLite3=ON")
        self.assertIn("has foresee::core", said)
        self.assertNotIn("has foresee::static", said)
        for build in ("with", "without"):
            self.assertNotIn("libforesee", (self.folder / build / "foresee/cmake_install.cmake").read_text())


if __name__ == "__main__":
    main()
