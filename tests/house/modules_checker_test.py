"""The guard of the modules, tried on made-up trees: it catches planted violations and lets good trees pass."""
import tempfile
import unittest
from pathlib import Path

from modules import misplaced_tests, strange_folders, violations


def tree(files):
    """violations() of a tree made of {path: text}."""
    with tempfile.TemporaryDirectory() as folder:
        for name, text in files.items():
            path = Path(folder) / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        return violations(folder)[0]


class ModuleGuard(unittest.TestCase):
    def catches(self, path, include, words):
        found = tree({path: f"#pragma once\n{include}\n"})
        self.assertEqual(len(found), 1, found)
        self.assertIn(f"{path}:2", found[0])
        self.assertIn(words, found[0])

    def passes(self, path, include):
        self.assertEqual(tree({path: include + "\n"}), [])

    def test_a_module_may_include_modules_to_its_right(self):
        self.passes("contact/ball.h", '#include "motion/vec.h"')
        self.passes("query/join/join.h", '#include "index/candidates.h"\n#include "contact/contact.h"')
        self.passes("sqlite/table/moving_objects_table.cpp", '#include "storage/table/store.h"\n#include "query/join/join.h"')
        self.passes("motion/motion.h", '#include <array>\n#include "motion/vec.h"')
        self.passes("index/gpcd_grid/stripes.cpp", '#include "index/gpcd_grid/stripes.h"')

    def test_a_module_may_not_include_modules_to_its_left(self):
        self.catches("motion/vec.h", '#include "contact/contact.h"', "motion may include base, numbers")
        self.catches("base/error.h", '#include "motion/vec.h"', "base may include no other module")
        self.catches("contact/ball.h", '#include "index/candidates.h"', "contact may include base, motion")
        self.catches("index/all_pairs.cpp", '#include "query/scene.h"', "index may include")
        self.catches("query/join/join.h", '#include "sqlite/foresee.h"', "query may include")
        self.catches("query/join/join.h", '  #  include "storage/table/store.h"', "query may include")

    def test_storage_sees_the_page_interface_shape_and_motion_only(self):
        self.passes("storage/pages.cpp", '#include "index/pages.h"\n#include "shape/row_layout.h"')
        self.catches("storage/pages.cpp", '#include "index/candidates.h"', "storage may include base, database, format, geography, motion")
        self.catches("storage/pages.cpp", '#include "contact/contact.h"', "storage may include base, database, format")

    def test_the_bytes_of_a_file_and_sqlite_know_nothing_of_each_other(self):
        self.passes("format/leaf_node.h", '#include "index/tpr_tree/node.h"\n#include "shape/row_layout.h"')
        self.catches("format/leaf_node.h", '#include "database/statement.h"', "format may include base, geography, motion, shape")
        self.catches("format/leaf_node.h", "#include <sqlite3.h>", "see SQLite")
        self.catches("database/statement.h", '#include "format/features.h"', "database may include base")

    def test_modules_inside_a_module_have_an_order(self):
        self.passes("storage/table/store.h", '#include "storage/nodes/node_cache.h"\n#include "database/statement.h"')
        self.passes("query/scene.h", '#include "query/join/join.h"')
        self.passes("query/join/join.h", '#include "query/scene.h"')
        self.catches("storage/nodes/node_history.h", '#include "storage/table/store.h"', "storage/nodes may include rows")
        self.catches("query/window/window.h", '#include "query/join/join.h"', "query/window may include nearest, position")
        self.catches("query/window/window.h", '#include "query/annex/join.h"', "query/annex has no place")

    def test_headers_include_each_other_in_no_circle(self):
        files = {"motion/a.h": '#include "motion/b.h"\n', "motion/b.h": '#include "motion/c.h"\n', "motion/c.h": ""}
        self.assertEqual(tree(files), [])
        files["motion/c.h"] = '#include "motion/a.h"\n'
        self.assertEqual(tree(files), ["a circle of includes: motion/a.h -> motion/b.h -> motion/c.h -> motion/a.h"])

    def test_only_what_stands_on_sqlite_sees_it(self):
        self.passes("database/sqlite_api.h", "#include <sqlite3ext.h>")
        self.catches("query/join/join.h", "#include <sqlite3.h>", "see SQLite")
        self.catches("index/pages.h", '#include "sqlite3ext.h"', "see SQLite")

    def test_relative_paths_are_no_way_around(self):
        self.catches("motion/vec.h", '#include "../contact/contact.h"', "relative path")
        self.catches("motion/vec.h", '#include "motion/../query/join.h"', "relative path")

    def test_a_file_outside_the_modules_is_a_violation(self):
        self.assertEqual(tree({"loose.h": ""}), ["loose.h: not in a module"])
        self.assertEqual(tree({"annex/loose.h": ""}), ["annex/loose.h: not in a module"])

    def test_a_comment_is_no_include(self):
        self.passes("motion/vec.h", '// #include "query/join/join.h"')

    def test_a_folder_of_tests_has_its_module(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("ext/query/join", "tests/query/join", "tests/query/flight", "tests/annex", "tests/fuzz/found",
                         "tests/storage/files"):
                (Path(folder) / name).mkdir(parents=True)
                (Path(folder) / name / "file").touch()
            self.assertEqual(strange_folders(f"{folder}/ext", f"{folder}/tests"),
                             ["tests/annex: there is no ext/annex", "tests/query/flight: there is no ext/query/flight"])

    def test_a_test_stands_in_the_module_of_what_it_tests(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("ext/query/scene.h", "ext/query/join/probe.h", "tests/query/scene_test.cpp", "tests/query/probe_test.cpp",
                         "tests/query/laws_test.cpp"):
                (Path(folder) / name).parent.mkdir(parents=True, exist_ok=True)
                (Path(folder) / name).touch()
            self.assertEqual(misplaced_tests(f"{folder}/ext", f"{folder}/tests"),
                             ["tests/query/probe_test.cpp: what it tests is in ext/query/join"])


if __name__ == "__main__":
    unittest.main()
