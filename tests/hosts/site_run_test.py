"""The docs site in headless Chromium: "Run" on every SQL block that has the button prints what the page shows, opened from the disk, and
no request leaves the machine.

FORESEE_PICTURES=FOLDER keeps the pictures.
"""
import json
import os
import re
import shutil
import sys
from pathlib import Path

from hosts import PACKAGES, ROOT, Host, main, need_commands, run, skip

sys.path.insert(0, str(ROOT / "ext/hosts/docs"))
sys.dont_write_bytecode = True
import stage  # noqa: E402
from documents import examples, fenced_and_hidden  # noqa: E402

VISIT = """
const puppeteer = require('puppeteer-core'), fs = require('fs');
(async () => {
  const [chromium, pages, folder] = process.argv.slice(2);
  const browser = await puppeteer.launch({executablePath: chromium, args: ['--no-sandbox', '--disable-gpu'], headless: 'new', protocolTimeout: 600000});
  const page = await browser.newPage(), seen = {requests: new Set(), faults: [], pages: {}};
  await page.setViewport({width: 1280, height: 900});
  page.on('request', (request) => seen.requests.add(request.url()));
  page.on('pageerror', (error) => seen.faults.push(error.message));
  for (const path of JSON.parse(fs.readFileSync(pages))) {
    await page.goto('file://' + path);
    seen.pages[path] = await page.evaluate(async () => {
      const outputs = [];
      for (const button of document.querySelectorAll('button.run')) {
        button.click();
        const box = button.parentElement.nextElementSibling;
        while (button.disabled) await new Promise((done) => setTimeout(done, 5));
        outputs.push({code: button.parentElement.querySelector('code').textContent, failed: box.classList.contains('failed'), text: box.textContent});
      }
      return {outputs, blocks: document.querySelectorAll('.md-content div.language-sql').length};
    });
    if (path.endsWith('/geofences.html')) {
      for (const scheme of ['light', 'dark']) {
        await page.emulateMediaFeatures([{name: 'prefers-color-scheme', value: scheme}]);
        await page.evaluate(() => localStorage.clear());       // the theme remembers its first scheme
        await page.reload();
        await page.click('button.run');
        await page.waitForFunction(() => document.querySelector('.run-output').textContent.includes('ms'));
        await page.screenshot({path: `${folder}/site_${scheme}.png`});
      }
    }
  }
  console.log(JSON.stringify({...seen, requests: [...seen.requests]}));
  await browser.close();
})().catch((error) => { console.error(error); process.exit(1); });
"""


def lines(text):
    return [line.rstrip() for line in text.strip().splitlines()]


def wanted(source):
    """(code, kind, what the page shows) of each block that runs."""
    site = stage.Site(Path("/nowhere"))
    text = source.read_text()
    expected = {(block.line, block.text): block for block in examples(text)}
    shown = [block for block in fenced_and_hidden(text) if block.kind in ("sql", "sql error")]
    runs = [block["runs"] for block in site.blocks_of(text) if block["kind"] != "setup"]
    return [(block.text, block.kind, expected[block.line, block.text].expected) for block, does in zip(shown, runs) if does]


class Run(Host):
    maxDiff = None

    def test_every_button_prints_what_the_page_shows(self):
        site = PACKAGES / "docs"
        if not (site / "run/foresee_module.js").exists():
            skip("Run on the docs site", f"{PACKAGES}/docs has no module: run ext/hosts/pack.sh page docs")
        need_commands("Run on the docs site", "node", "npm", "chromium")
        try:
            # Later ones want a newer Node than Debian has.
            run("timeout", "120", "npm", "install", "--silent", "--no-audit", "--no-fund", "puppeteer-core@23", folder=self.folder)
        except AssertionError:
            skip("Run on the docs site", "npm could not fetch puppeteer-core")
        sources = {str(site / name.replace(".md", ".html")): source for source, name in stage.Site(self.folder).names.items()}
        pages, script = self.write("pages.json", json.dumps(sorted(sources))), self.write("visit.cjs", VISIT)
        seen = json.loads(run("node", script, run("which", "chromium").strip(), pages, self.folder, folder=self.folder).splitlines()[-1])
        if os.environ.get("FORESEE_PICTURES"):
            for picture in self.folder.glob("*.png"):
                shutil.copy(picture, Path(os.environ["FORESEE_PICTURES"]))
        # The theme's search can read no file of a site that is opened from the disk.
        self.assertEqual([fault for fault in seen["faults"] if "Failed to fetch" not in fault], [])
        self.assertEqual([url for url in seen["requests"] if not url.startswith((f"file://{site}/", "data:", "blob:"))], [])
        ran = with_output = 0
        for path, page in seen["pages"].items():
            blocks = wanted(sources[path])
            self.assertEqual(len(page["outputs"]), len(blocks), f"{path}: buttons")
            for (code, kind, expected), output in zip(blocks, page["outputs"]):
                with self.subTest(path, code=code[:60]):
                    self.assertEqual(lines(output["code"]), lines(code))
                    self.assertEqual(output["failed"], kind == "sql error", output["text"])
                    ran += 1
                    if kind == "sql error":
                        self.assertTrue(all(re.sub(r"^.*?: ", "", line, count=1) in output["text"] for line in lines(expected)), output["text"])
                    elif expected:
                        with_output += 1
                        self.assertEqual(lines(output["text"])[:-1], lines(expected))
        print(f"{ran} blocks of {len(seen['pages'])} pages ran, {with_output} printed what the page shows")
        self.assertGreater(with_output, 60)


if __name__ == "__main__":
    main()
