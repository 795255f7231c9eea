"""Rust: the programs of docs/hosts/rust.md over an installed prefix that was moved, linked and loaded, with Debian's crates alone.

Which cargo runs is printed: Debian's, as another one that comes first on PATH may refuse the crates of the distribution.
"""
import os
import shutil
import tempfile
from pathlib import Path

from hosts import ROOT, blocks, main, run, skip, version
from installed import MODULES_OF_THE_SYSTEM, Installed

CARGO, RUSTC, RUSTDOC = (Path("/usr/bin") / name for name in ("cargo", "rustc", "rustdoc"))
CRATES = Path("/usr/share/cargo/registry")
TOUCH = blocks("rust.md", "text")[0]


class Rust(Installed):
    what = "the crate of Rust"
    commands = ("cmake", "c++", "cc", "pkg-config")

    @classmethod
    def setUpClass(cls):
        if not CARGO.exists() or not list(CRATES.glob("rusqlite-*")):
            skip(cls.what, "there is no cargo of Debian with librust-rusqlite-dev")
        first = shutil.which("cargo")
        other = f"; first on PATH is {first}" if first and Path(first).resolve() != CARGO.resolve() else ""
        print(f"with {run(CARGO, '--version').strip()} of {CARGO}{other}", flush=True)
        cls.built = Path(tempfile.mkdtemp(prefix="foresee-hosts-"))    # crates of others are compiled once
        cls.addClassCleanup(shutil.rmtree, cls.built)

    def setUp(self):
        super().setUp()
        self.crate = self.prefix / "share/foresee/rust"
        self.write("fleet/.cargo/config.toml", blocks("rust.md", "toml config")[0])
        self.write("fleet/src/main.rs", blocks("rust.md", "rust")[0])
        self.project = self.folder / "fleet"

    def cargo(self, *arguments, folder=None, fails=False, **environment):
        return run(CARGO, *arguments, "--offline", "--quiet", folder=folder or self.project, fails=fails, **{
            "RUSTC": str(RUSTC), "RUSTDOC": str(RUSTDOC), "CARGO_HOME": str(self.folder / "cargo"), "CARGO_TARGET_DIR": str(self.built),
            "PKG_CONFIG_PATH": str(self.library / "pkgconfig"), **environment})

    def manifest(self, feature):
        self.write("fleet/Cargo.toml", blocks("rust.md", f"toml {feature}")[0].replace("/usr/share/foresee/rust", str(self.crate)))

    def test_linked_the_program_needs_no_module(self):
        self.manifest("linked")
        self.assertEqual(self.cargo("run"), TOUCH)
        self.assertNotIn("foresee.so", run("ldd", self.built / "debug/fleet"))

    def test_loaded_the_module_is_opened(self):
        self.manifest("loaded")
        if not MODULES_OF_THE_SYSTEM:
            said = self.cargo("run", fails=True, LD_LIBRARY_PATH="")
            self.assertIn("foresee.so: cannot open shared object file", said)
        self.assertEqual(self.cargo("run", LD_LIBRARY_PATH=str(self.library)), TOUCH)

    def test_loaded_from_a_path_and_without_the_crate(self):
        self.manifest("loaded")
        body = blocks("rust.md", "rust without")[0].replace('"foresee"', f'"{self.library}/foresee"').replace("fleet.db", "other.db")
        manifest = self.project / "Cargo.toml"
        manifest.write_text(manifest.read_text().replace('"0.28"', '{ version = "0.28", features = ["load_extension"] }'))
        self.write("fleet/src/main.rs", f"""use rusqlite::{{Connection, Result}};
fn version(db: &Connection) -> Result<String> {{ db.query_row("SELECT foresee_version()", [], |row| row.get(0)) }}
fn main() -> Result<()> {{
    {body}
    println!("{{}}", version(&db)?);
    let db = foresee::load_from(Connection::open_in_memory()?, "{self.library}/foresee")?;
    println!("{{}}", version(&db)?);
    println!("{{}}", db.query_row("SELECT load_extension('nothing')", [], |_| Ok(())).is_err());
    println!("{{:?}}", foresee::load_from(&db, "/nothing").is_err());
    Ok(())
}}""")
        first, second, *refused = self.cargo("run").splitlines()
        self.assertEqual((first.split("+")[0], second, refused), (version(), first, ["true", "true"]))

    def test_references_and_second_calls_are_accepted(self):
        self.manifest("linked")
        self.write("fleet/src/main.rs", """use rusqlite::{Connection, Result};
fn main() -> Result<()> {
    let mut db = Connection::open_in_memory()?;
    foresee::load(&db)?;
    foresee::load(&mut db)?.execute_batch("CREATE VIRTUAL TABLE ships USING moving_objects(id, x, y)")?;
    foresee::load(db)?.execute_batch("INSERT INTO ships VALUES (1, 0, 0)")
}""")
        self.assertEqual(self.cargo("run"), "")

    def test_a_missing_archive_is_named(self):
        self.manifest("linked")
        said = self.cargo("build", fails=True, PKG_CONFIG_PATH="", PKG_CONFIG_LIBDIR="/nothing", CARGO_TARGET_DIR=str(self.folder / "target"))
        self.assertIn("no libforesee.a: install libforesee-dev and pkg-config, or set FORESEE_LIB_DIR", said)

    def test_the_example_of_the_crate_and_its_version(self):
        self.assertIn(f'\nversion = "{version()}"\n', (self.crate / "Cargo.toml").read_text())
        crate = shutil.copytree(self.crate, self.folder / "crate")
        shutil.copytree(self.project / ".cargo", crate / ".cargo")
        self.assertIn("1 passed", self.cargo("test", "--doc", folder=crate))
        self.assertEqual(sorted(os.listdir(self.crate)), sorted(os.listdir(ROOT / "ext/hosts/rust")))


if __name__ == "__main__":
    main()
