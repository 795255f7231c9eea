// The page: SQL goes into the module, rows come out, and what they say is drawn.
//
// Everything on the canvas is what foresee answers: places are the rows of predictive_position at the slider's
// moment, a pair is drawn while its t and t_end say so. Nothing is computed twice here.
'use strict';

const $ = (id) => document.getElementById(id);
const canvas = $('canvas'), pen = canvas.getContext('2d');
const shown_rows = 1000;

let query;                       // sql -> {columns, rows, ms}, or an Error
let scene = null;                // what is drawn: {table, now, horizon, looks, pairs}
let view = {x: 0, y: 0, scale: 1};
let playing = null, chosen = -1;

// The module.

async function unpacked(element) {
  const packed = Uint8Array.from(atob(element.textContent.trim()), (c) => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Response(stream).arrayBuffer();
}

async function load() {
  const module = await foreseeModule({wasmBinary: await unpacked($('module'))});
  if (module._foresee_open() !== 0) throw new Error('SQLite did not open a database');
  const ask = (sql) => {
    const size = module.lengthBytesUTF8(sql) + 1, at = module._malloc(size);
    module.stringToUTF8(sql, at, size);
    const answer = JSON.parse(module.UTF8ToString(module._foresee_query(at)));
    module._free(at);
    if (answer.error !== undefined) throw Object.assign(new Error(answer.error), {offset: answer.offset});
    return answer;
  };
  query = ask;
  window.foresee = {query: ask, reopen: () => module._foresee_open()};
}

// Rows.

function text_of(value) {
  if (value === null) return '';
  if (typeof value !== 'number' || Number.isInteger(value)) return String(value);
  return String(Number(value.toPrecision(9)));
}

function show_rows(answer) {
  const head = document.createElement('tr');
  head.append(...answer.columns.map((name) => Object.assign(document.createElement('th'), {textContent: name})));
  $('pairs').tHead.replaceChildren(head);
  $('pairs').tBodies[0].replaceChildren(...answer.rows.slice(0, shown_rows).map((row, number) => {
    const line = document.createElement('tr');
    line.tabIndex = 0;
    line.append(...row.map((value) => Object.assign(document.createElement('td'), {
      textContent: text_of(value), className: typeof value === 'string' ? 'text' : '', title: value === null ? 'NULL' : String(value)})));
    line.onclick = () => choose(number);
    line.onkeydown = (event) => { if (event.key === 'Enter') choose(number); };
    return line;
  }));
}

function say(text, is_error) {
  $('message').textContent = text;
  $('message').className = is_error ? 'error' : '';
}

// The scene: which table, which moments, what objects look like.

const quoted = (name) => '"' + name.replaceAll('"', '""') + '"';
const literal = (text) => "'" + text.replaceAll("'", "''") + "'";

function moving_tables() {
  const sql = "SELECT name FROM sqlite_schema WHERE sql LIKE '%USING%moving_objects%' ORDER BY rowid";
  return query(sql).rows.map((row) => row[0]);
}

function rings_of(wkt) {
  if (!/^\s*(MULTI)?POLYGON/i.test(wkt) || /\bZ\b/i.test(wkt)) return null;
  return [...wkt.matchAll(/\(([^()]+)\)/g)].map((ring) => ring[1].split(',').map((corner) => corner.trim().split(/\s+/).map(Number)));
}

/// What each object looks like, by its id.
function looks_of(table) {
  const all = query(`SELECT * FROM ${quoted(table)}`), looks = new Map();
  const at = Object.fromEntries(all.columns.map((name, i) => [name.toLowerCase(), i]));
  const rings = new Map();
  for (const row of all.rows) {
    const value = (name) => (at[name] === undefined ? null : row[at[name]]);
    const shape = value('shape');
    if (shape !== null && !rings.has(shape)) rings.set(shape, rings_of(shape));
    looks.set(String(row[at.id]), {r: value('r') ?? 0, hx: value('hx'), hy: value('hy'), name: value('name'),
      rings: shape === null ? null : rings.get(shape), heading: value('heading') ?? 0});
  }
  return {looks, latest: at.t === undefined ? 0 : Math.max(...all.rows.map((row) => row[at.t]))};
}

function read_scene(sql, answer) {
  const call = sql.match(/predictive_join\s*\(\s*([\d.]+(?:e\d+)?)\s*(?:,\s*'([^']+)')?(?:\s*,\s*([\d.]+)(?:\s*,\s*'([^']+)')?)?/i);
  const tables = moving_tables();
  const first = call && tables.includes(call[2]) ? call[2] : tables[0];
  if (!first) return null;
  const second = call && tables.includes(call[4]) ? call[4] : null;
  const column = (name) => answer.columns.indexOf(name);
  const [a, b, t, t_end] = ['a', 'b', 't', 't_end'].map(column);
  const drawn = (second ? [first, second] : [first]).map((table) => ({table, ...looks_of(table)}));
  const now = Math.max(...drawn.map((one) => one.latest));
  const pairs = a < 0 || b < 0 || t < 0 ? [] : answer.rows.map((row) => ({a: String(row[a]), b: String(row[b]), t: row[t],
    t_end: t_end < 0 ? row[t] : row[t_end]}));
  return {tables: drawn, now: Number.isFinite(now) ? now : 0, horizon: call ? Number(call[1]) || 1 : 60, within: call ? Number(call[3] ?? 0) : 0, pairs};
}

function places_of(table, moment) {
  const answer = query(`SELECT id, x, ${scene.flat ? '0' : 'y'} AS y FROM predictive_position(${moment}, ${literal(table)})`);
  return answer.rows.map(([id, x, y]) => ({id: String(id), x, y}));
}

// Drawing: x to the right, y up.

const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue('--' + name).trim();
const moment_shown = () => scene.now + Number($('time').value);
const on_screen = (x, y) => [canvas.width / 2 + (x - view.x) * view.scale, canvas.height / 2 - (y - view.y) * view.scale];

function fit(points, room) {
  if (points.length === 0) return;
  const xs = points.map((p) => p.x), ys = points.map((p) => p.y);
  const middle = (values) => (Math.min(...values) + Math.max(...values)) / 2;
  const span = (values) => Math.max(...values) - Math.min(...values) + room;
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

function draw_object(place, look, fill) {
  const [x, y] = on_screen(place.x, place.y);
  pen.fillStyle = fill;
  pen.beginPath();
  if (look.rings) {
    const turn = look.heading * Math.PI / 180, c = Math.cos(turn), s = Math.sin(turn);
    for (const ring of look.rings) {
      ring.forEach(([u, v], i) => pen[i ? 'lineTo' : 'moveTo'](...on_screen(place.x + u * c + v * s, place.y - u * s + v * c)));
      pen.closePath();
    }
    pen.fill('evenodd');
    pen.lineWidth = 2 * devicePixelRatio;
    pen.strokeStyle = fill;
    pen.stroke();
  } else if (look.hx !== null) {
    const w = Math.max(look.hx * view.scale, 2), h = Math.max((look.hy ?? 0) * view.scale, 2);
    pen.rect(x - w, y - h, 2 * w, 2 * h);
    pen.fill();
  } else {
    pen.arc(x, y, Math.max(look.r * view.scale, 2.4 * devicePixelRatio), 0, 2 * Math.PI);
    pen.fill();
  }
}

function draw() {
  canvas.width = canvas.clientWidth * devicePixelRatio, canvas.height = canvas.clientHeight * devicePixelRatio;
  if (!scene) return;
  const moment = moment_shown(), step = draw_grid();
  const [soon, touch] = [new Set(), new Set()];
  for (const pair of scene.pairs) {
    const marks = pair.t <= moment && moment <= pair.t_end ? touch : pair.t > moment ? soon : null;
    if (!marks) continue;
    marks.add('0' + pair.a), marks.add((scene.tables.length - 1) + pair.b);
  }
  const found = new Map(), names = [];
  scene.tables.forEach(({table, looks}, number) => {
    const places = places_of(table, moment), later = new Map(places_of(table, moment + scene.horizon / 12).map((p) => [p.id, p]));
    pen.strokeStyle = colour('trail'), pen.lineWidth = 1.5 * devicePixelRatio;
    pen.beginPath();
    for (const place of places) {
      const next = later.get(place.id);
      if (next) pen.moveTo(...on_screen(place.x, place.y)), pen.lineTo(...on_screen(next.x, next.y));
    }
    pen.stroke();
    for (const place of places) {
      const key = number + place.id, look = looks.get(place.id) ?? {r: 0, hx: null, rings: null};
      draw_object(place, look, colour(touch.has(key) ? 'touch' : soon.has(key) ? 'soon' : 'object'));
      found.set(key, place);
      if (look.name && places.length <= 60) names.push([look.name, place]);
    }
  });
  pen.fillStyle = colour('ink'), pen.font = `${12 * devicePixelRatio}px system-ui, sans-serif`;
  for (const [name, place] of names) {
    const [x, y] = on_screen(place.x, place.y);
    pen.fillText(name, x + 9 * devicePixelRatio, y - 9 * devicePixelRatio);
  }
  const pair = scene.pairs[chosen], a = pair && found.get('0' + pair.a), b = pair && found.get((scene.tables.length - 1) + pair.b);
  if (a && b) {
    pen.strokeStyle = colour('touch'), pen.setLineDash([6, 5]);
    pen.beginPath();
    pen.moveTo(...on_screen(a.x, a.y)), pen.lineTo(...on_screen(b.x, b.y));
    pen.stroke();
    pen.setLineDash([]);
  }
  $('clock').textContent = `t = ${text_of(Number(moment.toPrecision(8)))}`;
  $('legend').innerHTML = `grid ${text_of(step)}<i style="background:var(--touch)"></i>in contact now<i style="background:var(--soon)"></i>will be<i style="background:var(--object)"></i>keeps clear`;
}

// What the reader does.

function run() {
  const sql = $('sql').value;
  stop();
  try {
    const answer = query(sql);
    chosen = -1;
    show_rows(answer);
    const count = answer.rows.length;
    say(`${count} ${count === 1 ? 'row' : 'rows'} in ${answer.ms.toFixed(1)} ms` + (count > shown_rows ? `, the first ${shown_rows} shown` : ''));
    scene = read_scene(sql, answer);
    if (scene) {
      $('time').max = scene.horizon, $('time').value = 0;
      const first = scene.tables[0].table;
      scene.flat = !query(`SELECT * FROM ${quoted(first)} LIMIT 0`).columns.includes('y');
      canvas.width = canvas.clientWidth * devicePixelRatio, canvas.height = canvas.clientHeight * devicePixelRatio;
      fit([0, scene.horizon].flatMap((later) => scene.tables.flatMap(({table}) => places_of(table, scene.now + (scene.tables[0].looks.size < 100 ? later : 0)))), 1);
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
  const place = (table, id) => places_of(scene.tables[table].table, moment_shown()).find((p) => p.id === id);
  const both = [place(0, pair.a), place(last, pair.b)].filter(Boolean);
  const size = Math.max(...[[0, pair.a], [last, pair.b]].map(([table, id]) => scene.tables[table].looks.get(id)?.r ?? 0), scene.within, 1);
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
  const examples = JSON.parse($('examples').textContent);
  examples.forEach((example, i) => $('example').add(new Option(example.title, i)));
  $('example').onchange = () => open_example(examples[Number($('example').value)]);
  return examples;
}

function open_example(example) {
  window.foresee.reopen();
  if (example.setup) query(example.setup);
  $('sql').value = example.sql;
  run();
}

load().then(() => {
  open_example(listen()[0]);
  document.documentElement.dataset.state = 'ready';
}).catch((error) => {
  say(error.message, true);
  document.documentElement.dataset.state = 'failed';
});
