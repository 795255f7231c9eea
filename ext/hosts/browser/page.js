// The page: SQL goes into the module, rows come out, and what they say is drawn.
//
// Everything on the canvas is what foresee answers: places are the rows of predictive_position at the slider's
// time, a pair is drawn while its t and t_end say so. Nothing is computed twice here.
'use strict';

const $ = (id) => document.getElementById(id);
const canvas = $('canvas'), pen = canvas.getContext('2d');

let query;                       // sql -> {columns, rows, ms}, or an Error
let examples = [];
let scene = null;                // what is drawn: {table, now, horizon, styles, pairs}
let view = {x: 0, y: 0, scale: 1};
let playing = null, chosen = -1;
let coast = null;                // {origin, read, placed}

function say(text, is_error) {
  $('message').textContent = text;
  $('message').className = is_error ? 'error' : '';
}

// The scene: which table, which times, the styles of objects.

const quoted = (name) => '"' + name.replaceAll('"', '""') + '"';
const literal = (text) => "'" + text.replaceAll("'", "''") + "'";

/// Name to origin, [latitude, longitude] in degrees; null of a table in metres.
function moving_tables() {
  const rows = query("SELECT f.name, f.origin FROM foresee_tables f JOIN sqlite_schema s ON s.name = f.name WHERE f.schema = 'main' ORDER BY s.rowid").rows;
  return new Map(rows.map(([name, origin]) => [name, origin ? origin.split(' ').map(Number) : null]));
}

/// Metres east and north of an origin: the mid-latitude formula on WGS84, good to a metre within 100 km. It places what is only drawn.
function projection([lat0, lon0]) {
  const radians = Math.PI / 180, a = 6378137, e2 = 0.00669437999014;
  return (lon, lat) => {
    const dl = (((lon - lon0) % 360 + 540) % 360 - 180) * radians, middle = (lat + lat0) / 2 * radians;
    const w = 1 - e2 * Math.sin(middle) ** 2, n = a / Math.sqrt(w), m = a * (1 - e2) / w ** 1.5;
    const east = n * dl * Math.cos(middle), north = m * (lat - lat0) * radians * Math.cos(dl / 2);
    const turn = -dl * Math.sin(middle) / 2, [c, s] = [Math.cos(turn), Math.sin(turn)];
    return [east * c + north * s, north * c - east * s];
  };
}

/// The coast about an origin, once it is needed.
function coast_about(origin) {
  if (!origin) return null;
  coast ??= {read: JSON.parse(new TextDecoder().decode(coast_bytes))};
  if (String(coast.origin) !== String(origin)) {
    const [lat, lon] = origin;
    coast = {...coast, origin, placed: coastOf(coast.read, projection(origin), [lon - 30, Math.max(-89, lat - 18), lon + 30, Math.min(89, lat + 18)])};
  }
  return coast.placed;
}

function rings_of(wkt) {
  if (!/^\s*(MULTI)?POLYGON/i.test(wkt) || /\bZ\b/i.test(wkt)) return null;
  return [...wkt.matchAll(/\(([^()]+)\)/g)].map((ring) => ring[1].split(',').map((corner) => corner.trim().split(/\s+/).map(Number)));
}

/// The style of each object, by its id.
function styles_of(table, origin) {
  const all = query(`SELECT * FROM ${quoted(table)}`), styles = new Map();
  const at = Object.fromEntries(all.columns.map((name, i) => [name.toLowerCase(), i]));
  const rings = new Map();
  for (const row of all.rows) {
    const value = (name) => (at[name] === undefined ? null : row[at[name]]);
    const shape = value('shape') ?? value('zone');
    if (shape !== null && !rings.has(shape)) rings.set(shape, at.zone === undefined ? rings_of(shape)
      : rings_of(shape)?.map((ring) => ring.map((corner) => projection(origin)(...corner))));
    styles.set(String(row[at.id]), {r: value('r') ?? 0, hx: value('hx'), hy: value('hy'), name: value('name'),
      rings: shape === null ? null : rings.get(shape), heading: value('heading') ?? 0, zone: at.zone !== undefined});
  }
  return {styles, latest: at.t === undefined ? 0 : Math.max(...all.rows.map((row) => row[at.t]))};
}

function read_scene(sql, answer) {
  const call = sql.match(/predictive_join\s*\(\s*([\d.]+(?:e\d+)?)\s*(?:,\s*'([^']+)')?(?:\s*,\s*([\d.]+)(?:\s*,\s*'([^']+)')?)?/i);
  const tables = moving_tables();
  const first = call && tables.has(call[2]) ? call[2] : [...tables.keys()][0];
  if (!first) return null;
  const second = call && tables.has(call[4]) ? call[4] : null;
  const column = (name) => answer.columns.indexOf(name);
  const [a, b, t, t_end] = ['a', 'b', 't', 't_end'].map(column);
  const drawn = (second ? [first, second] : [first]).map((table) => ({table, ...styles_of(table, tables.get(table))}));
  const now = Math.max(...drawn.map((one) => one.latest));
  const pairs = a < 0 || b < 0 || t < 0 ? [] : answer.rows.map((row) => ({a: String(row[a]), b: String(row[b]), t: row[t],
    t_end: t_end < 0 ? row[t] : row[t_end]}));
  return {tables: drawn, origin: tables.get(first), now: Number.isFinite(now) ? now : 0, horizon: call ? Number(call[1]) || 1 : 60, within: call ? Number(call[3] ?? 0) : 0, pairs};
}

function places_of(table, time) {
  const answer = query(`SELECT id, x, ${scene.flat ? '0' : 'y'} AS y FROM predictive_position(${time}, ${literal(table)})`);
  return answer.rows.map(([id, x, y]) => ({id: String(id), x, y}));
}

// Drawing: x to the right, y up.

const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue('--' + name).trim();
const time_shown = () => scene.now + Number($('time').value);
const on_screen = (x, y) => [canvas.width / 2 + (x - view.x) * view.scale, canvas.height / 2 - (y - view.y) * view.scale];

/// Shows points; of many all but stray ones, the middle 98 of 100.
function fit(points, room) {
  if (points.length === 0) return;
  const sorted = (values) => { values.sort((a, b) => a - b); const cut = Math.floor(values.length / 100); return values.slice(cut, values.length - cut); };
  const xs = sorted(points.map((p) => p.x)), ys = sorted(points.map((p) => p.y));
  const middle = (values) => (values[0] + values[values.length - 1]) / 2;
  const span = (values) => values[values.length - 1] - values[0] + room;
  view = {x: middle(xs), y: middle(ys), scale: Math.min(canvas.width / span(xs), canvas.height / span(ys)) * 0.88};
}

function draw_grid() {
  const step = 10 ** Math.ceil(Math.log10(60 * devicePixelRatio / view.scale));
  const [left, right] = [-1, 1].map((side) => view.x + side * canvas.width / 2 / view.scale);
  const [low, high] = [-1, 1].map((side) => view.y + side * canvas.height / 2 / view.scale);
  pen.strokeStyle = colour('grid');
  pen.lineWidth = devicePixelRatio;
  pen.beginPath();
  for (let x = Math.ceil(left / step) * step; x <= right; x += step) pen.moveTo(on_screen(x, 0)[0], 0), pen.lineTo(on_screen(x, 0)[0], canvas.height);
  for (let y = Math.ceil(low / step) * step; y <= high; y += step) pen.moveTo(0, on_screen(0, y)[1]), pen.lineTo(canvas.width, on_screen(0, y)[1]);
  pen.stroke();
  return step;
}

function draw_object(place, style, fill) {
  if (!style.zone && Math.abs(on_screen(place.x, place.y)[0] - canvas.width / 2) > 2 * canvas.width) return;
  const [x, y] = on_screen(place.x, place.y);
  pen.fillStyle = fill;
  pen.beginPath();
  if (style.rings) {
    const turn = style.heading * Math.PI / 180, c = Math.cos(turn), s = Math.sin(turn);
    for (const ring of style.rings) {
      ring.forEach(([u, v], i) => pen[i ? 'lineTo' : 'moveTo'](...on_screen(place.x + u * c + v * s, place.y - u * s + v * c)));
      pen.closePath();
    }
    pen.globalAlpha = style.zone ? 0.15 : 1;
    pen.fill('evenodd');
    pen.globalAlpha = 1;
    pen.lineWidth = 2 * devicePixelRatio;
    pen.strokeStyle = fill;
    pen.stroke();
  } else if (style.hx !== null) {
    const w = Math.max(style.hx * view.scale, 2), h = Math.max((style.hy ?? 0) * view.scale, 2);
    pen.rect(x - w, y - h, 2 * w, 2 * h);
    pen.fill();
  } else {
    pen.arc(x, y, Math.max(style.r * view.scale, 2.4 * devicePixelRatio), 0, 2 * Math.PI);
    pen.fill();
  }
}

function draw() {
  canvas.width = canvas.clientWidth * devicePixelRatio, canvas.height = canvas.clientHeight * devicePixelRatio;
  if (!scene) return;
  const around = coast_about(scene.origin);
  if (around) {
    const [w, h] = [canvas.width, canvas.height].map((size) => size / 2 / view.scale);
    drawCoast(pen, around, {seen: [view.x - w, view.y - h, view.x + w, view.y + h], onScreen: on_screen, width: canvas.width, height: canvas.height,
      pixel: devicePixelRatio, land: colour('land'), water: colour('water'), shore: colour('shore')});
  }
  const time = time_shown(), step = draw_grid();
  const [soon, touch] = [new Set(), new Set()];
  for (const pair of scene.pairs) {
    const marks = pair.t <= time && time <= pair.t_end ? touch : pair.t > time ? soon : null;
    if (!marks) continue;
    marks.add('0' + pair.a), marks.add((scene.tables.length - 1) + pair.b);
  }
  const found = new Map(), names = [];
  scene.tables.forEach(({table, styles}, number) => {
    const places = places_of(table, time), later = new Map(places_of(table, time + scene.horizon / 12).map((p) => [p.id, p]));
    pen.strokeStyle = colour('trail'), pen.lineWidth = 1.5 * devicePixelRatio;
    pen.beginPath();
    for (const place of places) {
      const next = later.get(place.id);
      if (next) pen.moveTo(...on_screen(place.x, place.y)), pen.lineTo(...on_screen(next.x, next.y));
    }
    pen.stroke();
    for (const place of places) {
      const key = number + place.id, style = styles.get(place.id) ?? {r: 0, hx: null, rings: null};
      draw_object(place, style, colour(touch.has(key) ? 'touch' : soon.has(key) ? 'soon' : 'object'));
      found.set(key, place);
      if (style.name && (places.length <= 60 || soon.has(key) || touch.has(key))) names.push([style, place]);
    }
  });
  draw_names(names);
  const pair = scene.pairs[chosen], a = pair && found.get('0' + pair.a), b = pair && found.get((scene.tables.length - 1) + pair.b);
  if (a && b) {
    pen.strokeStyle = colour('touch'), pen.setLineDash([6, 5]);
    pen.beginPath();
    pen.moveTo(...on_screen(a.x, a.y)), pen.lineTo(...on_screen(b.x, b.y));
    pen.stroke();
    pen.setLineDash([]);
  }
  const later = Number($('time').value), dated = scene.now > 1e8;
  const date = () => new Date(time * 1000).toISOString().replace('T', ' ').slice(0, 19) + ' UTC';
  $('clock').textContent = (scene.horizon >= 120 ? `+${(later / 60).toFixed(1)} min` : `+${later.toFixed(1)} s`) + (dated ? `  ${date()}` : '');
  $('legend').innerHTML = `grid ${step >= 1000 ? `${step / 1000} km` : `${plain(step)} m`}<i style="background:var(--touch)"></i>${scene.within ? `within ${plain(scene.within)} m` : 'in contact'} now<i style="background:var(--soon)"></i>will be<i style="background:var(--object)"></i>keeps clear`;
}

/// Names beside their objects, as far as there is room: each in a place that no other has taken. That of a zone is in its middle.
function draw_names(names) {
  pen.font = `${12 * devicePixelRatio}px system-ui, sans-serif`;
  pen.lineWidth = 3 * devicePixelRatio, pen.lineJoin = 'round';
  const chosenOnes = new Set(scene.pairs[chosen] ? [scene.pairs[chosen].a, scene.pairs[chosen].b] : []);
  const rank = ([style, place]) => (chosenOnes.has(place.id) ? 0 : style.zone ? 1 : 2);
  names.sort((a, b) => rank(a) - rank(b));
  const taken = [], free = (box) => !taken.some((one) => overlap(one, box));
  for (const [{name, zone, rings}, place] of names) {
    const width = pen.measureText(name).width, height = 14 * devicePixelRatio;
    let [x, y] = on_screen(place.x, place.y);
    if (zone && rings) {
      const [west, south, east, north] = withBox([...rings[0]]).box;
      [x, y] = on_screen((west + east) / 2, (south + north) / 2);
      x -= width / 2 + 9 * devicePixelRatio, y += 12 * devicePixelRatio;
    }
    x += 9 * devicePixelRatio, y -= 9 * devicePixelRatio;
    const box = [x, y - height, x + width, y];
    if (x > canvas.width || y < 0 || x + width < 0 || y - height > canvas.height || !free(box)) continue;
    taken.push(box);
    pen.strokeStyle = colour('water'), pen.strokeText(name, x, y);
    pen.fillStyle = colour('ink'), pen.fillText(name, x, y);
  }
}

// What the reader does.

function run() {
  const sql = $('sql').value;
  stop();
  try {
    const answer = query(sql);
    chosen = -1;
    const count = answer.rows.length;
    say(`${count} ${count === 1 ? 'row' : 'rows'} in ${answer.ms.toFixed(1)} ms` + (count > SHOWN_ROWS ? `, the first ${SHOWN_ROWS} shown` : ''));
    scene = read_scene(sql, answer);
    showRows($('pairs'), answer, scene, choose);
    if (scene) {
      $('time').max = scene.horizon, $('time').value = 0;
      const first = scene.tables[0].table;
      const columns = query(`SELECT * FROM ${quoted(first)} LIMIT 0`).columns;
      scene.flat = columns.includes('x') && !columns.includes('y');
      canvas.width = canvas.clientWidth * devicePixelRatio, canvas.height = canvas.clientHeight * devicePixelRatio;
      fit([0, scene.horizon].flatMap((later) => scene.tables.flatMap(({table}) => places_of(table, scene.now + (scene.tables[0].styles.size < 100 ? later : 0)))), 1);
    }
    draw();
  } catch (error) {
    say(error.message, true);
    if (error.offset >= 0) $('sql').setSelectionRange(error.offset, error.offset);
  }
}

function choose(number) {
  chosen = number;
  [...$('pairs').tBodies[0].rows].forEach((line, i) => line.classList.toggle('chosen', i === number));
  const pair = scene && scene.pairs[number];
  if (!pair) return;
  stop();
  $('time').value = Math.max(0, pair.t - scene.now);
  const last = scene.tables.length - 1;
  const place = (table, id) => places_of(scene.tables[table].table, time_shown()).find((p) => p.id === id);
  const both = [place(0, pair.a), place(last, pair.b)].filter(Boolean);
  const size = Math.max(...[[0, pair.a], [last, pair.b]].map(([table, id]) => scene.tables[table].styles.get(id)?.r ?? 0), scene.within, 1);
  fit(both, 8 * size);
  draw();
}

function stop() {
  if (playing) cancelAnimationFrame(playing);
  playing = null;
  $('play').textContent = 'Play';
}

function play() {
  if (playing) return stop();
  if (!scene) return;
  $('play').textContent = 'Pause';
  if (Number($('time').value) >= scene.horizon) $('time').value = 0;
  let before = performance.now();
  const step = (at) => {
    const next = Number($('time').value) + (at - before) / 12000 * scene.horizon;
    before = at;
    $('time').value = next;
    draw();
    if (next >= scene.horizon) return stop();
    playing = requestAnimationFrame(step);
  };
  playing = requestAnimationFrame(step);
}

function listen() {
  $('run').onclick = run;
  $('play').onclick = play;
  $('time').oninput = () => { stop(); draw(); };
  $('sql').onkeydown = (event) => { if (event.key === 'Enter' && (event.ctrlKey || event.metaKey)) run(); };
  new ResizeObserver(() => draw()).observe(canvas);
  matchMedia('(prefers-color-scheme: dark)').onchange = draw;
  canvas.onwheel = (event) => {
    event.preventDefault();
    const factor = Math.exp(-event.deltaY / 600);
    const dx = (event.offsetX - canvas.clientWidth / 2) * devicePixelRatio / view.scale, dy = (canvas.clientHeight / 2 - event.offsetY) * devicePixelRatio / view.scale;
    view = {x: view.x + dx - dx / factor, y: view.y + dy - dy / factor, scale: view.scale * factor};
    draw();
  };
  canvas.onpointermove = (event) => {
    if (event.buttons !== 1) return;
    view.x -= event.movementX * devicePixelRatio / view.scale, view.y += event.movementY * devicePixelRatio / view.scale;
    draw();
  };
  examples.forEach((example, i) => $('example').add(new Option(example.title, i)));
  $('example').onchange = () => open_example(examples[Number($('example').value)]);
  $('share').onclick = share;
  addEventListener('hashchange', open_link);
}

function open_example(example, sql = example.sql) {
  window.foresee.reopen();
  if (example.setup) query(example.setup);
  $('sql').value = sql;
  run();
}

/// The query goes into the address; the data of an example is in the page, and named.
async function share() {
  const fragment = await fragmentOf({sql: $('sql').value, example: $('example').selectedOptions[0]?.textContent});
  history.replaceState(null, '', fragment);
  try { await navigator.clipboard.writeText(location.href); say('The link is copied; it holds the query.'); }
  catch { say('The link in the address bar holds the query.'); }
}

/// Opens what the address holds, else the first example.
async function open_link() {
  try {
    const shared = await sharedBy(location.hash);
    const number = Math.max(0, examples.findIndex((example) => example.title === shared?.example));
    $('example').value = number;
    open_example(examples[number], shared ? shared.sql : undefined);
  } catch (error) {
    open_example(examples[0]);
    say(error.message, true);
  }
}

let coast_bytes;

async function load() {
  examples = JSON.parse($('examples').textContent);
  coast_bytes = await unpacked($('coast').textContent);
  window.foresee = await openForesee($('module').textContent);
  query = window.foresee.query;
  listen();
  await open_link();
}

load().then(() => {
  document.documentElement.dataset.state = 'ready';
}).catch((error) => {
  say(error.message, true);
  document.documentElement.dataset.state = 'failed';
});
