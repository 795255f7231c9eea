#!/usr/bin/python3
"""Which pages make the site? Lays them out for mkdocs: the README as the index, docs/, the pages beside them, and what they link to.

    python3 ext/hosts/docs/stage.py FOLDER      # writes FOLDER/mkdocs.yml and FOLDER/pages/

A link to a source file leads to a copy of it in the site, as text; one to a folder of sources becomes plain words. A link that leads
nowhere ends the program with a message. Pages that NAV does not name come last in it: a new page needs no line here. Pages that have
moved leave a page at their old address that leads on (moved.py).

Where the module of the browser page is built (build/page), the SQL blocks of a page get a button that runs them (run.js). A block gets none
if it, or one before it on its page, is for the shell: dot commands, files, functions of the shell's own.
"""
import base64
import gzip
import json
import os
import re
import shutil
import sys
from pathlib import Path

from make_reference import GROUPS
from moved import redirects

ROOT = Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "tests/house"))
from documents import fenced_and_hidden  # noqa: E402
BESIDE = {"README.md": "index.md", "CHANGELOG.md": "changelog.md", "CONTRIBUTING.md": "contributing.md", "bench/README.md": "bench.md",
          "SECURITY.md": "security.md"}
NAV = [("Start", ["index", "tutorials/first_queries", "tutorials/*", "faq"]),
       ("Install", ["hosts/*"]),
       ("How to", ["how-to/*"]),
       ("Reference", ["reference/index", *(f"reference/{name}" for names in GROUPS.values() for name in names)]),
       ("Explanation", ["explanation/how_it_works", "explanation/semantics", "explanation/*"]),
       ("Trust", ["stability", "upgrading", "security", "changelog"]),
       ("Developers", ["contributing", "developers/*", "bench"])]
LINK = re.compile(r"(!?)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^)\s]+)\)")
FENCE = re.compile(r"^(```.*?^```)$", re.M | re.S)
OF_THE_SHELL = re.compile(r"^\.[a-z]|\b(?:readfile|writefile|load_extension|generate_series|ATTACH\s+'[^':])", re.M | re.I)
MODULE = ROOT / "build/page"
COMMENT = re.compile(r"^<!--.*?-->\n", re.M | re.S)


class Site:
    def __init__(self, folder):
        self.folder, self.pages, self.wrong = folder, folder / "pages", []
        self.runs = (MODULE / "foresee.wasm").exists()
        self.names = {ROOT / name: target for name, target in BESIDE.items()}
        for page in sorted((ROOT / "docs").rglob("*.md")):
            self.names[page] = page.relative_to(ROOT / "docs").as_posix()

    def place_of(self, file):
        """Where a file that is linked to stands in the site; it is copied there."""
        if file in self.names:
            return self.names[file]
        docs = ROOT / "docs"
        inside = docs in file.parents
        if inside and file.suffix in (".svg", ".png"):
            place = file.relative_to(docs).as_posix()
        else:
            place = "sources/" + file.relative_to(ROOT).as_posix() + ".txt"
        (self.pages / place).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(file, self.pages / place)
        return place

    def linked(self, page, picture, words, target):
        if target.startswith(("http://", "https://", "#")):
            return f"{picture}[{words}]({target})"
        name, hash_sign, heading = target.partition("#")
        file = Path(os.path.normpath(page.parent / name))
        if not file.exists() or (ROOT != file and ROOT not in file.parents):
            self.wrong.append(f"{page.relative_to(ROOT)}: the link to {target} leads nowhere")
            return words
        if file.is_dir():
            return f"`{words}`"
        here = (self.pages / self.names[page]).parent
        place = os.path.relpath(self.pages / self.place_of(file), here).replace(os.sep, "/")
        return f"{picture}[{words}]({place}{hash_sign}{heading})"

    def blocks_of(self, text):
        """The SQL blocks of a page in order, also hidden ones: [{kind, text, runs}]."""
        blocks, runs = [], True
        for block in fenced_and_hidden(text):
            if block.kind in ("sql", "sql error", "setup"):
                runs = runs and not OF_THE_SHELL.search(block.text)
                blocks.append({"kind": block.kind, "text": block.text, "runs": runs})
        return blocks

    def text_of(self, page):
        text = page.read_text()
        blocks = self.blocks_of(text) if self.runs else []
        return self.laid_out(page, text) + ("" if not any(block["runs"] for block in blocks) else
            '\n\n<script type="application/json" id="sql-blocks">' + json.dumps(blocks).replace("<", "\\u003c") + "</script>\n")

    def laid_out(self, page, text):
        parts = FENCE.split(text)
        for number, part in enumerate(parts):
            if part.startswith("```"):
                parts[number] = re.sub(r"\A```(\w*).*", r"```\1", part)  # what follows the language is for our tests
            else:
                text = COMMENT.sub("", part).replace("<details>", '<details markdown="1">')
                parts[number] = LINK.sub(lambda link: self.linked(page, *link.groups()), text)
        return "".join(parts)

    def nav(self):
        left = sorted(set(self.names.values()))

        def taken(pattern):
            found = [name for name in left if Path(name[:-3]).match(pattern) and name[:-3].count("/") == pattern.count("/")]
            for name in found:
                left.remove(name)
            return found

        nav = [{title: [name for pattern in patterns for name in taken(pattern)]} for title, patterns in NAV]
        return [entry for entry in [*nav, {"More": left}] if any(entry.values())]

    def write(self):
        shutil.rmtree(self.folder, ignore_errors=True)
        for page, name in self.names.items():
            place = self.pages / name
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_text(self.text_of(page))
        for name, text in redirects().items():
            (self.pages / name).write_text(text)
        if self.wrong:
            sys.exit("\n".join(self.wrong))
        shutil.copyfile(Path(__file__).parent / "extra.css", self.pages / "extra.css")
        settings = (Path(__file__).parent / "mkdocs.yml").read_text()
        if self.runs:
            settings += "extra_javascript: [run/run.js]\n"
            self.write_module()
        (self.folder / "mkdocs.yml").write_text(settings + "nav: " + json.dumps(self.nav()) + "\n")

    def write_module(self):
        """run.js, and the module as a script: a page that is opened from a disk may read no other file."""
        (self.pages / "run").mkdir()
        shutil.copyfile(Path(__file__).parent / "run.js", self.pages / "run/run.js")
        wasm = base64.b64encode(gzip.compress((MODULE / "foresee.wasm").read_bytes(), 9, mtime=0)).decode()
        parts = [(MODULE / "foresee.js").read_text(), (ROOT / "ext/hosts/browser/module.js").read_text(), f"const foreseePacked = '{wasm}';"]
        (self.pages / "run/foresee_module.js").write_text("\n".join(parts) + "\n")


if __name__ == "__main__":
    Site(Path(sys.argv[1]).resolve()).write()
