"""sqlpkg.json: names the archives of a release that sqlpkg can unpack, with their sums; the same bytes each time."""
import hashlib
import io
import json
import tarfile
import zipfile

from hosts import ROOT, Host, main, run, version
from stand_ins import stand_in, table

URL = "https://example.org/fleet/foresee/releases/download/v1"
SCRIPT = ROOT / "ext/hosts/release/sqlpkg.py"


class Sqlpkg(Host):
    def archive(self, target):
        """A release's archive: one folder that holds the module."""
        name, module = f"foresee-{version()}-{target}", table()[target]["module"]
        if target.startswith("win32"):
            with zipfile.ZipFile(self.folder / f"{name}.zip", "w") as files:
                files.writestr(f"{name}/{module}", stand_in(target))
                files.writestr(f"{name}/LICENSE", "free")
            return
        with tarfile.open(self.folder / f"{name}.tar.gz", "w:gz") as files:
            for part, content in ((module, stand_in(target)), ("LICENSE", b"free"), ("README", b"read")):
                member = tarfile.TarInfo(f"{name}/{part}")
                member.size = len(content)
                files.addfile(member, io.BytesIO(content))

    def write_json(self, fails=False, **environment):
        said = run("/usr/bin/python3", SCRIPT, self.folder, version(), fails=fails, SOURCE_DATE_EPOCH="1700000000", **environment)
        return said if fails else json.loads((self.folder / "sqlpkg.json").read_text())

    def test_every_archive_is_flat_and_has_its_sum(self):
        for target in table():
            self.archive(target)
        about = self.write_json(FORESEE_RELEASE_URL=URL + "/")
        self.assertEqual((about["owner"], about["name"], about["version"]), ("foresee", "foresee", version()))
        self.assertEqual((about["assets"]["path"], about["repository"]), (URL, "https://example.org/fleet/foresee"))
        self.assertEqual(sorted(about["assets"]["files"]), ["darwin-amd64", "darwin-arm64", "linux-amd64", "linux-arm64", "windows-amd64"])
        for platform, name in about["assets"]["files"].items():
            content = (self.folder / name).read_bytes()
            self.assertEqual(about["assets"]["checksums"][name], "sha256-" + hashlib.sha256(content).hexdigest())
            module = {"linux": "foresee.so", "darwin": "foresee.dylib", "windows": "foresee.dll"}[platform.split("-")[0]]
            with zipfile.ZipFile(self.folder / name) as files:
                self.assertEqual(sorted(files.namelist()), ["LICENSE", module])
        before = {file.name: file.read_bytes() for file in self.folder.glob("*sqlpkg*")}
        self.write_json(FORESEE_RELEASE_URL=URL + "/")
        self.assertEqual(before, {file.name: file.read_bytes() for file in self.folder.glob("*sqlpkg*")})

    def test_targets_that_were_not_packed_are_left_out(self):
        self.archive("linux-x64-musl")
        self.assertIn("holds no archive", self.write_json(fails=True, FORESEE_RELEASE_URL=URL))
        self.archive("win32-x64")
        about = self.write_json(FORESEE_RELEASE_URL="https://example.org/files", FORESEE_OWNER="fleet")
        self.assertEqual((list(about["assets"]["files"]), about["owner"]), (["windows-amd64"], "fleet"))
        self.assertNotIn("repository", about)

    def test_without_an_address_it_says_what_to_set(self):
        self.assertIn("set FORESEE_RELEASE_URL", run("env", "-u", "FORESEE_RELEASE_URL", "/usr/bin/python3", SCRIPT, self.folder, "1", fails=True))


if __name__ == "__main__":
    main()
