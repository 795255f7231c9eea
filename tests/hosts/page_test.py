"""The page in headless Chromium, light and dark: ready soon, no request leaves it, its rows are those of the native build, bit for bit
(of tables in degrees within 1e-8, as C libraries differ), names and minutes fit, a coast is drawn, a link opens the query again.

FORESEE_PICTURES=FOLDER keeps the pictures.
"""
import json
import os
import re
import shutil
import sqlite3
import struct
from pathlib import Path

from hosts import BUILD, Host, main, need_commands, packed, run, skip

TOUR = """
const puppeteer = require('puppeteer-core');
(async () => {
  const browser = await puppeteer.launch({executablePath: process.argv[2], args: ['--no-sandbox', '--disable-gpu'], headless: 'new'});
  const folder = process.argv[4], requests = [], faults = [];
  const opened = async (scheme) => {
    const page = await browser.newPage();
    await page.setViewport({width: 1280, height: 760});
    await page.emulateMediaFeatures([{name: 'prefers-color-scheme', value: scheme}]);
    page.on('request', (request) => requests.push(request.url()));
    page.on('pageerror', (error) => faults.push(error.message));
    return page;
  };
  const page = await opened('light');
  const begin = Date.now();
  await page.goto('file://' + process.argv[3]);
  await page.waitForSelector('html[data-state=ready]', {timeout: 60000});
  const ready = Date.now() - begin;
  const told = {ready, requests, scenes: []};
  const titles = await page.$$eval('#example option', (all) => all.map((one) => one.textContent));
  for (let i = 0; i < titles.length; ++i) {
    await page.select('#example', String(i));
    const sql = await page.$eval('#sql', (box) => box.value);
    await page.click('#run');
    const message = await page.$eval('#message', (box) => box.textContent);
    const answer = await page.evaluate((sql) => JSON.stringify(foresee.query(sql)), sql);
    const shown = await page.$$eval('#pairs tbody tr', (rows) => rows.length);
    const setup = await page.evaluate((i) => JSON.parse(document.getElementById('examples').textContent)[i].setup ?? '', i);
    const [land, shore] = await page.evaluate(() => ['land', 'shore'].map((name) => {
      const hex = getComputedStyle(document.documentElement).getPropertyValue('--' + name).trim(), canvas = document.getElementById('canvas');
      const wanted = [1, 3, 5].map((k) => parseInt(hex.slice(k, k + 2), 16)), data = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
      let count = 0;
      for (let k = 0; k < data.length; k += 4) count += wanted.every((value, c) => data[k + c] === value);
      return count;
    }));
    await page.screenshot({path: `${folder}/page_${i}.png`});
    await page.click('#pairs tbody tr:first-child');
    const time = await page.$eval('#time', (slider) => Number(slider.value));
    const drawn = await page.$eval('#canvas', (canvas) => new Set(canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data).size);
    const cells = await page.$$eval('#pairs tbody tr:first-child td', (all) => all.map((one) => one.textContent));
    const heads = await page.$$eval('#pairs thead th', (all) => all.map((one) => one.textContent));
    const wide = await page.$eval('#rows', (box) => box.scrollWidth - box.clientWidth);
    const clock = await page.$eval('#clock', (box) => box.textContent);
    told.scenes.push({title: titles[i], setup, sql, message, shown, time, drawn, answer, cells, heads, wide, land, shore, clock});
  }
  // A query as a link: the same rows in another tab, which is dark.
  await page.select('#example', '1');
  await page.$eval('#sql', (box) => { box.value = "SELECT name, 'Zoë ✓' AS sign FROM ships ORDER BY name LIMIT 3"; });
  await page.click('#share');
  await page.waitForFunction(() => location.hash.length > 4);
  told.link = await page.evaluate(() => location.href);
  const other = await opened('dark');
  await other.goto(told.link);
  await other.waitForSelector('html[data-state=ready]', {timeout: 60000});
  told.shared = await other.$$eval('#pairs tbody td', (all) => all.map((one) => one.textContent));
  told.example = await other.$eval('#example', (list) => list.selectedOptions[0].textContent);
  await other.select('#example', '0');
  await other.screenshot({path: `${folder}/page_dark.png`});
  await other.goto('file://' + process.argv[3] + '#q=H4sIAAA');
  await other.waitForFunction(() => document.getElementById('message').className === 'error');
  told.damaged = await other.$eval('#message', (box) => box.textContent);
  await other.close();                          // a page behind another one takes no clicks
  await page.bringToFront();
  await page.$eval('#sql', (box) => { box.value = "SELECT * FROM predictive_join(300, 'nowhere')"; });
  await page.click('#run');
  told.error = await page.$eval('#message', (box) => box.textContent);
  told.faults = faults;
  console.log(JSON.stringify(told));
  await browser.close();
})().catch((error) => { console.error(error); process.exit(1); });
"""


def bits(value):
    """Doubles by their bits, as 0.0 and -0.0 are equal."""
    return struct.pack("<d", value) if isinstance(value, float) else value


class Page(Host):
    def native_rows(self, setup, sql):
        connection = sqlite3.connect(":memory:", isolation_level=None)
        connection.enable_load_extension(True)
        connection.load_extension(str(BUILD / "foresee.so"))
        connection.executescript(setup)
        question = sql.rindex("\nSELECT")
        connection.executescript(sql[:question])
        return connection.execute(sql[question:]).fetchall()

    def told(self, page):
        need_commands("the page", "node", "npm", "chromium")
        if not (BUILD / "foresee.so").exists():
            skip("the page beside the native build", f"{BUILD} holds no foresee.so")
        try:
            # Later ones want a newer Node than Debian has.
            run("timeout", "120", "npm", "install", "--silent", "--no-audit", "--no-fund", "puppeteer-core@23", folder=self.folder)
        except AssertionError:
            skip("the page in a browser", "npm could not fetch puppeteer-core")
        script = self.write("tour.cjs", TOUR)
        told = json.loads(run("node", script, run("which", "chromium").strip(), page, self.folder, folder=self.folder).strip().splitlines()[-1])
        if os.environ.get("FORESEE_PICTURES"):
            for picture in self.folder.glob("*.png"):
                shutil.copy(picture, Path(os.environ["FORESEE_PICTURES"]))
        return told

    def test_shows_what_the_native_build_answers(self):
        page = packed("the page", "foresee.html")
        without_data = re.sub(r'<script type="application/json" id="examples">.*?</script>', "", page.read_text(), flags=re.DOTALL)
        self.assertLess(len(without_data), 3e6)
        told = self.told(page)
        print(f"ready after {told['ready']} ms")
        self.assertEqual(told["faults"], [])
        self.assertEqual({url.partition("#")[0] for url in told["requests"]}, {f"file://{page}"})
        self.assertGreaterEqual(len(told["scenes"]), 5)
        for scene in told["scenes"]:
            with self.subTest(scene["title"]):
                rows = json.loads(scene["answer"], parse_constant=float)["rows"]
                native = self.native_rows(scene["setup"], scene["sql"])
                self.assertGreater(len(native), 0)
                if "lat, lon" in scene["setup"]:
                    self.assertEqual([row[:2] for row in rows], [list(row[:2]) for row in native])
                    for row, wanted in zip(rows, native):
                        for got, want in zip(row[2:], wanted[2:]):
                            self.assertAlmostEqual(got, want, delta=1e-6 if want > 1e9 else 1e-8 * max(1.0, abs(want)))
                    self.assertGreater(scene["land"], 50_000)
                    self.assertGreater(scene["shore"], 20)
                    self.assertRegex(scene["clock"], r"^\+\d+\.\d min  2022-01-03 00:\d\d:\d\d UTC$")
                else:
                    self.assertEqual([[bits(float(value)) for value in row] for row in rows],
                                     [[bits(float(value)) for value in row] for row in native])
                    self.assertEqual(scene["shore"], 0)
                self.assertLessEqual(scene["wide"], 0)
                self.assertEqual(scene["shown"], min(len(native), 1000))
                self.assertIn(f"{len(native)} rows in", scene["message"])
                self.assertGreater(scene["time"], 0)
                self.assertGreater(scene["drawn"], 4)
        first, zone = told["scenes"][:2]
        self.assertEqual(first["heads"], ["a", "b", "t_cpamin", "d_cpam", "tmin", "t_endmin"])
        self.assertEqual(first["cells"][:4], ["AMBER DOLPHIN", "JOLLY TERN", "1.4", "214"])
        self.assertEqual(zone["cells"][:2], ["AMBER DOLPHIN", "Hudson"])
        self.assertEqual(told["shared"], ["AMBER COMPASS", "Zoë ✓", "AMBER CURLEW", "Zoë ✓", "AMBER DOLPHIN", "Zoë ✓"])
        self.assertEqual(told["example"], "A zone")
        self.assertLess(len(told["link"]), 400)
        self.assertEqual(told["damaged"], "The link is damaged: it holds no query.")
        self.assertIn("no such table: 'nowhere'", told["error"])
        if os.environ.get("FORESEE_LONG"):
            self.assertLess(told["ready"], 3000)


if __name__ == "__main__":
    main()
