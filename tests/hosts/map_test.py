"""python3 -m foresee map in headless Chromium: the ships and their encounters appear and follow the file, light and dark, and no request
leaves the machine.

FORESEE_PICTURES=FOLDER keeps the pictures.
"""
import http.client
import json
import math
import os
import re
import shutil
import tempfile
from pathlib import Path

from hosts import main, need_commands, run, skip
from live import NEW_YORK, Command, Live, waited

VISIT = """
const puppeteer = require('puppeteer-core');
(async () => {
  const [chromium, address, feed, folder] = process.argv.slice(2);
  const browser = await puppeteer.launch({executablePath: chromium, args: ['--no-sandbox', '--disable-gpu'], headless: 'new'});
  const seen = {requests: [], faults: [], shots: {}};
  for (const scheme of ['light', 'dark']) {
    const page = await browser.newPage();
    await page.setViewport({width: 1280, height: 800});
    await page.emulateMediaFeatures([{name: 'prefers-color-scheme', value: scheme}]);
    page.on('request', (request) => seen.requests.push(request.url()));
    page.on('pageerror', (error) => seen.faults.push(error.message));
    page.on('console', (message) => seen.faults.push(message.text()));
    await page.goto(address);
    await page.waitForSelector('html[data-state=ready]', {timeout: 30000});
    const facts = await page.$eval('#facts', (box) => box.textContent);
    const rows = await page.$$eval('li', (all) => all.map((one) => [one.className, one.textContent]));
    const colours = await page.evaluate(() => {
      const canvas = document.getElementById('map'), count = {};
      const data = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
      for (let i = 0; i < data.length; i += 4) { const key = [data[i], data[i + 1], data[i + 2]].join(); count[key] = (count[key] || 0) + 1; }
      return Object.entries(count).sort((a, b) => b[1] - a[1]).slice(0, 40);
    });
    const wanted = await page.evaluate(() => Object.fromEntries(['water', 'land', 'soon', 'near', 'way', 'rest'].map((name) => {
      const hex = getComputedStyle(document.documentElement).getPropertyValue('--' + name).trim();
      return [name, [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16)).join()];
    })));
    await page.screenshot({path: `${folder}/${scheme}.png`});
    await page.click('li button');
    await page.screenshot({path: `${folder}/${scheme}_chosen.png`});
    const chosen = await page.$$eval('li.chosen', (all) => all.length);
    await page.focus('#map');
    for (let i = 0; i < 12; ++i) await page.keyboard.press('-');
    await page.screenshot({path: `${folder}/${scheme}_far.png`});
    seen.shots[scheme] = {facts, rows, colours, wanted, chosen};
    if (scheme === 'dark') {
      require('child_process').execSync(feed, {stdio: 'ignore'});
      await page.waitForFunction(() => document.getElementById('lists').textContent.includes('NEWCOMER'), {timeout: 20000});
      seen.after = await page.$eval('#facts', (box) => box.textContent);
      seen.markup = await page.$$eval('#lists b b, #lists img', (all) => all.length);
    }
    await page.close();
  }
  console.log(JSON.stringify(seen));
  await browser.close();
})().catch((error) => { console.error(error); process.exit(1); });
"""
VISIT_ZONES = """
const puppeteer = require('puppeteer-core');
(async () => {
  const [chromium, address, folder] = process.argv.slice(2);
  const browser = await puppeteer.launch({executablePath: chromium, args: ['--no-sandbox', '--disable-gpu'], headless: 'new'});
  const seen = {requests: [], faults: [], shots: {}};
  for (const scheme of ['light', 'dark']) {
    const page = await browser.newPage();
    await page.setViewport({width: 1280, height: 800});
    await page.emulateMediaFeatures([{name: 'prefers-color-scheme', value: scheme}]);
    page.on('request', (request) => seen.requests.push(request.url()));
    page.on('pageerror', (error) => seen.faults.push(error.message));
    page.on('console', (message) => message.text().includes('willReadFrequently') || seen.faults.push(message.text()));
    await page.goto(address);
    await page.waitForSelector('html[data-state=ready]', {timeout: 30000});
    const colours = () => page.evaluate(() => {
      const canvas = document.getElementById('map'), data = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
      const hex = (name) => getComputedStyle(document.documentElement).getPropertyValue('--' + name).trim().slice(1);
      const count = {};
      for (const name of ['zone', 'near', 'soon']) {
        const wanted = [0, 2, 4].map((i) => parseInt(hex(name).slice(i, i + 2), 16));
        count[name] = 0;
        for (let i = 0; i < data.length; i += 4) count[name] += wanted.every((value, k) => data[i + k] === value);
      }
      return count;
    });
    const first = await colours(), zones = await page.$eval('#zones', (box) => !box.hidden);
    await page.screenshot({path: `${folder}/zones_${scheme}.png`});
    const rows = await page.$$eval('li', (all) => all.map((one) => [one.className, ...[...one.querySelectorAll('b, span')].map((part) => part.textContent)]));
    const headings = await page.$$eval('h2', (all) => all.map((one) => one.textContent));
    await page.click('li button');
    await page.screenshot({path: `${folder}/zones_${scheme}_chosen.png`});
    seen.shots[scheme] = {first, zones, rows, headings, chosen: await colours()};
    await page.close();
  }
  console.log(JSON.stringify(seen));
  await browser.close();
})().catch((error) => { console.error(error); process.exit(1); });
"""
# The upper bay, with a hole, has ships under way and at rest; the wedge off Long Island and the third one have none.
ZONES = ("INSERT INTO reserves VALUES (1, 'POLYGON((-74.06 40.63, -74.02 40.63, -74.02 40.68, -74.06 40.68, -74.06 40.63), "
         "(-74.045 40.64, -74.035 40.64, -74.035 40.65, -74.045 40.65, -74.045 40.64))', 'Upper Bay <i>'), "
         "(2, 'POLYGON((-73.2 40.2, -72.2 40.4, -73.2 40.6, -73.2 40.2))', 'far away'), "
         "(3, 'POLYGON((-73.72 40.65, -73.65 40.65, -73.65 40.7, -73.72 40.7, -73.72 40.65))', 'nothing here')")
NEWCOMERS = ("mmsi,t,lat,lon,sog,cog,name\n"
             "999000001,1641169520,40.45,-73.90,12,90,NEWCOMER <b>1</b>\n999000002,1641169520,40.45,-73.84,12,270,NEWCOMER 2\n")


class Map(Live):
    scripts = None

    @classmethod
    def with_browser(cls):
        """A folder in which node finds puppeteer-core."""
        need_commands("the map", "node", "npm", "chromium")
        if cls.scripts is None:
            cls.scripts = Path(tempfile.mkdtemp(prefix="foresee-hosts-"))
            cls.addClassCleanup(shutil.rmtree, cls.scripts)
            try:
                # Later ones want a newer Node than Debian has.
                run("timeout", "120", "npm", "install", "--silent", "--no-audit", "--no-fund", "puppeteer-core@23", folder=cls.scripts)
            except AssertionError:
                skip("the map in a browser", "npm could not fetch puppeteer-core")
        return cls.scripts

    def visit(self, script, *arguments):
        """What a script saw, in Chromium."""
        path = self.with_browser() / "visit.cjs"
        path.write_text(script)
        seen = json.loads(run("node", path, run("which", "chromium").strip(), *arguments, folder=self.scripts).splitlines()[-1])
        if os.environ.get("FORESEE_PICTURES"):
            for picture in self.folder.glob("*.png"):
                shutil.copy(picture, Path(os.environ["FORESEE_PICTURES"]))
        return seen

    def setUp(self):
        super().setUp()
        self.command("feed", self.file, "--table", "ships", "--watch", "alerts", text=NEW_YORK.read_text())

    def serve(self, *options):
        server = Command(self, "map", self.file, "--port", "0", *options)
        address = server.process.stdout.readline().split()[0]
        return server, address

    def get(self, address, path, host=None):
        port = int(re.search(r":(\d+)/", address)[1])
        connection = http.client.HTTPConnection("127.0.0.1", port, timeout=30)
        self.addCleanup(connection.close)
        connection.request("GET", path, headers={"Host": host} if host else {})
        answer = connection.getresponse()
        return answer.status, answer.headers, answer.read()

    def test_the_page_in_a_browser(self):
        server, address = self.serve()
        self.assertTrue(address.startswith("http://127.0.0.1:"), address)
        newcomers = self.write("new.csv", NEWCOMERS)
        feed = f"PYTHONPATH={self.site} /usr/bin/python3 -m foresee feed {self.file} --table ships < {newcomers}"
        seen = self.visit(VISIT, address, feed, self.folder)
        self.assertEqual(seen["faults"], [])
        self.assertEqual([url for url in seen["requests"] if not url.startswith((address, "data:,"))], [])
        light, dark = seen["shots"]["light"], seen["shots"]["dark"]
        self.assertNotEqual(light["wanted"], dark["wanted"])
        db = self.database()
        for shot in (light, dark):
            self.assertTrue(shot["facts"].startswith("236 ships, "), shot["facts"])
            self.assertIn("2022-01-03 00:25:16 UTC", shot["facts"])
            drawn = dict(shot["colours"])
            for name in ("water", "land", "soon", "way", "rest"):
                self.assertIn(shot["wanted"][name], drawn, name)
            self.assertGreater(drawn[shot["wanted"]["water"]], 50_000)
            self.assertGreater(drawn[shot["wanted"]["land"]], 50_000)
            self.assertEqual(shot["chosen"], 1)
            self.assertEqual([kind for kind, _ in shot["rows"]], sorted(kind for kind, _ in shot["rows"]))      # to come, then near
            self.assertGreater(sum(kind == "" for kind, _ in shot["rows"]), 3)
        self.assertTrue(seen["after"].startswith("238 ships, "), seen["after"])
        self.assertEqual(seen["markup"], 0)                          # names are text
        self.assertEqual(db.execute("SELECT count(*) FROM alerts WHERE a = 999000001").fetchone(), (1,))
        self.assertEqual(server.end(), 0)

    def test_the_state_is_that_of_the_file(self):
        _, address = self.serve()
        status, headers, body = self.get(address, "/state")
        state = json.loads(body)
        self.assertEqual((status, state["now"]), (200, 1641169516))
        self.assertIn("default-src 'none'", headers["Content-Security-Policy"])
        stored = self.positions()
        at_rest = {ship[0]: ship for ship in state["ships"] if ship[5] is None}
        # Of the 237 ships one has been silent for more than 900 seconds.
        self.assertEqual((len(stored), len(state["ships"])), (237, 236))
        for number, (_, _, lat, lon, *_) in at_rest.items():
            self.assertAlmostEqual(lat, stored[number][1], delta=1e-6)
            self.assertAlmostEqual(lon, stored[number][2], delta=1e-6)
        watch, = state["watches"]
        self.assertEqual(len(watch["pairs"]), self.database().execute("SELECT count(*) FROM alerts").fetchone()[0])
        self.assertEqual(self.get(address, f"/state?version={state['version']}")[0], 204)

    def with_zones(self):
        db = self.database()
        origin, = db.execute("SELECT origin FROM foresee_tables WHERE name = 'ships'").fetchone()
        db.execute(f"CREATE VIRTUAL TABLE reserves USING moving_objects(id, zone, +name TEXT, origin = '{origin}')")
        db.execute(ZONES)
        db.execute("CREATE VIRTUAL TABLE fence USING predictive_watch(ships, horizon = 1800, other = reserves)")
        return db

    def test_zones_in_a_browser(self):
        db = self.with_zones()
        db.execute("DROP TABLE alerts")
        _, address = self.serve()
        seen = self.visit(VISIT_ZONES, address, self.folder)
        self.assertEqual(seen["faults"], [])
        self.assertEqual([url for url in seen["requests"] if not url.startswith((address, "data:,"))], [])
        pairs = db.execute("SELECT w.t > w.now, count(*) FROM (SELECT f.t, n.now FROM fence f, predictive_watches n) w GROUP BY 1 ORDER BY 1").fetchall()
        self.assertEqual([is_later for is_later, _ in pairs], [0, 1])
        self.assertEqual(db.execute("SELECT count(DISTINCT s.speed > 0) FROM fence f JOIN ships s ON s.id = f.a WHERE f.t <= 1641169516").fetchone(), (2,))
        for shot in seen["shots"].values():
            self.assertTrue(shot["zones"])
            self.assertEqual(shot["headings"], ["To come fence: inside in 30 min; entry to reserves", "Inside fence"])
            self.assertEqual([sum(row[0] == "near" for row in shot["rows"]), sum(row[0] != "near" for row in shot["rows"])],
                             [count for _, count in pairs])
            self.assertEqual({row[3] for row in shot["rows"]}, {"Upper Bay <i>"})
            minutes = [float(row[2].split()[0]) for row in shot["rows"] if row[0] != "near"]
            self.assertEqual(minutes, sorted(minutes))
            self.assertGreater(shot["first"]["near"], 200)              # the outline of the zone that holds ships, and they
            self.assertGreater(shot["first"]["zone"], 20)               # that of the other one
            self.assertGreater(shot["chosen"]["near"], shot["first"]["near"])      # nearer, and with a thicker outline

    def test_the_areas_are_those_of_the_tables(self):
        db = self.with_zones()
        origin, = db.execute("SELECT origin FROM foresee_tables WHERE name = 'ships'").fetchone()
        db.execute(f"CREATE VIRTUAL TABLE hulls USING moving_objects(id, lat, lon, shape, heading, origin = '{origin}')")
        lat, lon = map(float, origin.split())
        db.execute("INSERT INTO hulls VALUES (1, ?, ?, 'POLYGON((-10 -50, 10 -50, 10 50, -10 50, -10 -50))', 90)", (lat, lon))
        db.execute("CREATE VIRTUAL TABLE close USING predictive_watch(ships, horizon = 60, other = hulls)")
        _, address = self.serve("--table", "ships")
        state = json.loads(self.get(address, "/state")[2])
        self.assertEqual(sorted(state["areas"]), ["hulls", "reserves", "ships"])
        bay, wedge, _ = state["areas"]["reserves"]
        self.assertEqual(bay[:2] + [len(bay[2]), bay[2][1]], [1, "Upper Bay <i>", 2, [-74.045, 40.64, -74.035, 40.64, -74.035, 40.65, -74.045, 40.65,
                                                                                   -74.045, 40.64]])
        # A long edge is a geodesic: the middle of the one from 40.2 to 40.4 degrees is north of the chord, by less than 0.001 degrees here.
        ring = list(zip(wedge[2][0][::2], wedge[2][0][1::2]))
        self.assertGreater(len(ring), 40)
        middle = min(ring, key=lambda corner: abs(corner[0] + 72.7))
        chord = 40.2 + 0.2 * (middle[0] + 73.2)
        self.assertTrue(chord + 1e-4 < middle[1] < chord + 2e-3, middle)
        # A hull of 100 m by 20 m that is turned eastward.
        ring = state["areas"]["hulls"][0][2][0]
        self.assertAlmostEqual(max(ring[::2]) - min(ring[::2]), 100 / 111320 / math.cos(math.radians(lat)), delta=3e-6)
        self.assertAlmostEqual(max(ring[1::2]) - min(ring[1::2]), 20 / 111050, delta=3e-6)
        # They are sent again when they are others.
        known = f"/state?version=x&areas={state['areas_version']}"
        self.assertNotIn("areas", json.loads(self.get(address, known)[2]))
        db.execute("DELETE FROM reserves WHERE id = 2")
        self.assertEqual(len(json.loads(self.get(address, known)[2])["areas"]["reserves"]), 2)

    def test_it_answers_this_machine_alone(self):
        _, address = self.serve()
        self.assertEqual(self.get(address, "/", host="evil.example:80")[0], 403)
        self.assertEqual(self.get(address, "/../reports.py")[0], 404)
        self.assertEqual(self.get(address, "/")[0], 200)
        with open("/proc/net/tcp") as table:
            port = int(re.search(r":(\d+)/", address)[1])
            listening = [line.split()[1] for line in table if line.split()[3] == "0A" and line.split()[1].endswith(f":{port:04X}")]
        self.assertEqual(listening, [f"0100007F:{port:04X}"])

    def test_the_coast_is_small_and_names_its_source(self):
        coast = self.site / "foresee/page/coast.json"
        self.assertLessEqual(coast.stat().st_size, 300_000)
        self.assertIn("Natural Earth (public domain)", json.loads(coast.read_text())["source"])

    def test_errors_are_one_line(self):
        self.database().execute("CREATE VIRTUAL TABLE plain USING moving_objects(id, x, y)")
        self.database().execute("INSERT INTO plain VALUES (1, 0, 0)")
        for options, message in (((), "there are 2 tables of moving objects (plain, ships); write --table NAME"),
                                 (("--table", "plain"), "plain is in metres and its origin is not known"),
                                 (("--table", "gone"), "there is no table gone")):
            errors = self.command("map", self.file, *options, fails=True)[1]
            self.assertEqual(errors.count("\n"), 1, errors)
            self.assertIn(f"foresee map: {message}", errors)


if __name__ == "__main__":
    main()
