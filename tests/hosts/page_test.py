"""The page in headless Chromium: ready soon, no request leaves it, and its rows are those of the native build, bit for bit."""
import json
import os
import re
import sqlite3
import struct

from hosts import BUILD, Host, main, need_commands, packed, run, skip

TOUR = """
const puppeteer = require('puppeteer-core');
(async () => {
  const browser = await puppeteer.launch({executablePath: process.argv[2], args: ['--no-sandbox', '--disable-gpu'], headless: 'new'});
  const page = await browser.newPage();
  await page.setViewport({width: 1280, height: 760});
  const requests = [], faults = [];
  page.on('request', (request) => requests.push(request.url()));
  page.on('pageerror', (error) => faults.push(error.message));
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
    await page.click('#pairs tbody tr:first-child');
    const time = await page.$eval('#time', (slider) => Number(slider.value));
    const drawn = await page.$eval('#canvas', (canvas) => new Set(canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data).size);
    told.scenes.push({title: titles[i], setup, sql, message, shown, time, drawn, answer});
  }
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
        return json.loads(run("node", script, run("which", "chromium").strip(), page, folder=self.folder).strip().splitlines()[-1])

    def test_shows_what_the_native_build_answers(self):
        page = packed("the page", "foresee.html")
        without_data = re.sub(r'<script type="application/json" id="examples">.*?</script>', "", page.read_text(), flags=re.DOTALL)
        self.assertLess(len(without_data), 3e6)
        told = self.told(page)
        print(f"ready after {told['ready']} ms")
        self.assertEqual(told["faults"], [])
        self.assertEqual(told["requests"], [f"file://{page}"])
        self.assertGreaterEqual(len(told["scenes"]), 3)
        for scene in told["scenes"]:
            with self.subTest(scene["title"]):
                rows = json.loads(scene["answer"], parse_constant=float)["rows"]
                native = self.native_rows(scene["setup"], scene["sql"])
                self.assertGreater(len(native), 0)
                self.assertEqual([[bits(float(value)) for value in row] for row in rows],
                                 [[bits(float(value)) for value in row] for row in native])
                self.assertEqual(scene["shown"], min(len(native), 1000))
                self.assertIn(f"{len(native)} rows in", scene["message"])
                self.assertGreater(scene["time"], 0)
                self.assertGreater(scene["drawn"], 4)
        self.assertIn("no such table: 'nowhere'", told["error"])
        if os.environ.get("FORESEE_LONG"):
            self.assertLess(told["ready"], 3000)


if __name__ == "__main__":
    main()
