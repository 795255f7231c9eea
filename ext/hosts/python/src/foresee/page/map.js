// The page of `python3 -m foresee map`: draws coast, ships, tracks and encounters on a canvas, and reads /state each second.
'use strict';
const $ = (id) => document.getElementById(id);
const canvas = $('map'), pen = canvas.getContext('2d');
const TRACK = 200;                       // positions kept per ship, from this page's start on
let coast = null, state = null, areas = [], view = null, chosen = null, touchedView = false;
const tracks = new Map();

// Mercator: east and north in units of degrees at the equator.
const north = (lat) => Math.log(Math.tan(Math.PI / 4 + Math.max(-85, Math.min(85, lat)) * Math.PI / 360)) * 180 / Math.PI;
const latOf = (y) => Math.atan(Math.exp(y * Math.PI / 180)) * 360 / Math.PI - 90;
const screen = (lon, y) => [(lon - view.lon) * view.scale + canvas.clientWidth / 2, (view.y - y) * view.scale + canvas.clientHeight / 2];
const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue('--' + name).trim();

// Of longitudes and latitudes one after the other.
function ringOf(values) {
  const ring = [];
  for (let i = 0; i < values.length; i += 2) ring.push([values[i], north(values[i + 1])]);
  return withBox(ring);
}

function fit() {
  const ships = state && state.ships.length ? state.ships : areas.flatMap((area) => area.rings.flat().map(([lon, y]) => [0, '', latOf(y), lon]));
  if (!ships.length) { view = {lon: 0, y: 20, scale: canvas.clientWidth / 300}; return; }
  // All but stray positions: the middle 98 of 100.
  const span = (values) => { values.sort((a, b) => a - b); const cut = Math.floor(values.length / 100); return [values[cut], values[values.length - 1 - cut]]; };
  const [west, east] = span(ships.map((ship) => ship[3])), [south, top] = span(ships.map((ship) => north(ship[2])));
  view = {lon: (west + east) / 2, y: (south + top) / 2,
          scale: 0.88 * Math.min(canvas.clientWidth / Math.max(east - west, 0.02), canvas.clientHeight / Math.max(top - south, 0.02))};
}

function zoomAt(factor, x = canvas.clientWidth / 2, y = canvas.clientHeight / 2) {
  const dx = x - canvas.clientWidth / 2, dy = canvas.clientHeight / 2 - y, scale = Math.min(Math.max(view.scale * factor, 1), 2e6);
  view = {lon: view.lon + dx / view.scale - dx / scale, y: view.y + dy / view.scale - dy / scale, scale};
  touchedView = true;
  draw();
}

function sight() {
  const [width, height] = [canvas.clientWidth, canvas.clientHeight], [w, h] = [width / 2 / view.scale, height / 2 / view.scale];
  return {seen: [view.lon - w, view.y - h, view.lon + w, view.y + h], onScreen: screen, width, height, pixel: 1,
          land: colour('land'), water: colour('water'), shore: colour('shore')};
}

function drawGrid() {
  const steps = [30, 10, 5, 2, 1, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01], step = steps.find((s) => s * view.scale < 220) || 0.01;
  const [w, h] = [canvas.clientWidth, canvas.clientHeight], digits = step < 0.1 ? 2 : step < 1 ? 1 : 0;
  pen.strokeStyle = colour('grid'); pen.fillStyle = colour('quiet'); pen.lineWidth = 1; pen.font = '11px system-ui, sans-serif'; pen.textAlign = 'left';
  const lon0 = view.lon - w / 2 / view.scale, lat0 = latOf(view.y - h / 2 / view.scale), lat1 = latOf(view.y + h / 2 / view.scale);
  for (let lon = Math.ceil(lon0 / step) * step; lon < lon0 + w / view.scale; lon += step) {
    const [x] = screen(lon, 0);
    pen.beginPath(); pen.moveTo(x, 0); pen.lineTo(x, h); pen.stroke();
    pen.fillText(Math.abs(lon).toFixed(digits) + (lon < 0 ? ' W' : ' E'), x + 4, 13);
  }
  for (let lat = Math.ceil(lat0 / step) * step; lat < lat1; lat += step) {
    const y = screen(0, north(lat))[1];
    pen.beginPath(); pen.moveTo(0, y); pen.lineTo(w, y); pen.stroke();
    // The first line of labels is that of the longitudes.
    if (y > 30) pen.fillText(Math.abs(lat).toFixed(digits) + (lat < 0 ? ' S' : ' N'), 4, y - 4);
  }
}

function pairsOf() {
  return state.watches.flatMap((watch) => watch.pairs.map((pair) => ({...pair, watch: watch.name, other: watch.other})));
}

// Of the areas that the pairs name, and of the chosen pair: 'soon' or 'near'; 'near' counts more, since the area is entered.
function drawAreas() {
  const marked = new Map();
  for (const pair of pairsOf().filter((one) => one.other)) {
    const key = `${pair.other.toLowerCase()} ${pair.b}`;
    if (!marked.has(key) || pair.near || isChosen(pair)) marked.set(key, {kind: pair.near ? 'near' : 'soon', chosen: isChosen(pair) || marked.get(key)?.chosen});
  }
  pen.font = '12px system-ui, sans-serif'; pen.textAlign = 'center'; pen.lineJoin = 'round';
  const named = new Set(), seen = sight();
  for (const area of areas) {
    const mark = marked.get(`${area.table.toLowerCase()} ${area.number}`);
    if (!traceRings(pen, area.rings, seen).length) continue;
    pen.fillStyle = colour('zone-fill'); pen.strokeStyle = colour(mark ? mark.kind : 'zone');
    pen.lineWidth = mark && mark.chosen ? 4 : mark ? 2.5 : 2;
    pen.fill('evenodd'); pen.stroke();
    // The name, where the area is wide enough for it.
    const box = area.rings[0].box, [left, top] = screen(box[0], box[3]), [right, bottom] = screen(box[2], box[1]);
    const place = `${Math.round((left + right) / 40)} ${Math.round((top + bottom) / 16)}`;
    if (area.own || named.has(place) || right - left < pen.measureText(area.name).width + 8 || bottom - top < 16) continue;
    named.add(place);
    pen.lineWidth = 3; pen.strokeStyle = colour('halo'); pen.fillStyle = colour('text');
    pen.strokeText(area.name, (left + right) / 2, (top + bottom) / 2 + 4);
    pen.fillText(area.name, (left + right) / 2, (top + bottom) / 2 + 4);
  }
  pen.textAlign = 'left';
}

function drawShips() {
  const kind = new Map(), at = new Map(state.ships.map((ship) => [ship[0], ship]));
  const pairs = pairsOf();
  for (const pair of [...pairs].sort((a, b) => b.near - a.near)) for (const id of pair.other ? [pair.a] : [pair.a, pair.b]) kind.set(id, pair.near ? 'near' : 'soon');
  pen.strokeStyle = colour('track'); pen.lineWidth = 1.5;
  for (const track of tracks.values()) {
    if (track.length < 2) continue;
    pen.beginPath();
    track.forEach((point, i) => i ? pen.lineTo(...screen(...point)) : pen.moveTo(...screen(...point)));
    pen.stroke();
  }
  for (const pair of pairs) {
    const [a, b] = [at.get(pair.a), pair.other ? null : at.get(pair.b)];      // b of another table, such as a zone, has no place here
    if (!a || !b) continue;
    pen.strokeStyle = colour(pair.near ? 'near' : 'soon');
    pen.lineWidth = isChosen(pair) ? 4 : 1.25;
    pen.globalAlpha = isChosen(pair) || !pair.near ? 0.9 : 0.5;
    pen.beginPath(); pen.moveTo(...screen(a[3], north(a[2]))); pen.lineTo(...screen(b[3], north(b[2]))); pen.stroke();
  }
  pen.globalAlpha = 1;
  const colours = Object.fromEntries(['near', 'soon', 'way', 'rest'].map((name) => [name, colour(name)]));
  pen.strokeStyle = colour('halo'); pen.lineWidth = 1;
  const order = {rest: 0, way: 1, near: 2, soon: 3}, kindOf = (ship) => kind.get(ship[0]) || (ship[5] === null ? 'rest' : 'way');
  for (const ship of [...state.ships].sort((a, b) => order[kindOf(a)] - order[kindOf(b)])) {
    const [x, y] = screen(ship[3], north(ship[2]));
    if (x < -20 || y < -20 || x > canvas.clientWidth + 20 || y > canvas.clientHeight + 20) continue;
    pen.fillStyle = colours[kindOf(ship)];
    pen.beginPath();
    if (ship[5] === null) pen.arc(x, y, 3, 0, 7);
    else {
      const turn = ship[5] * Math.PI / 180, [s, c] = [Math.sin(turn), Math.cos(turn)];
      [[0, -8], [4.5, 6], [0, 3], [-4.5, 6]].forEach(([px, py], i) => pen[i ? 'lineTo' : 'moveTo'](x + px * c - py * s, y + px * s + py * c));
      pen.closePath();
    }
    pen.fill(); pen.stroke();
  }
}

function draw() {
  const ratio = window.devicePixelRatio || 1, [w, h] = [canvas.clientWidth, canvas.clientHeight];
  if (canvas.width !== Math.round(w * ratio) || canvas.height !== Math.round(h * ratio)) { canvas.width = Math.round(w * ratio); canvas.height = Math.round(h * ratio); }
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.fillStyle = colour('water');
  pen.fillRect(0, 0, w, h);
  if (!view) return;
  if (coast) drawCoast(pen, coast, sight());
  drawGrid();
  if (state) { drawAreas(); drawShips(); }
}

const isChosen = (pair) => chosen && chosen.a === pair.a && chosen.b === pair.b && chosen.watch === pair.watch;
const element = (name, text, kind) => { const made = document.createElement(name); made.textContent = text; if (kind) made.className = kind; return made; };

function row(pair) {
  const item = element('li', '', pair.near ? 'near' : ''), button = element('button', '');
  if (isChosen(pair)) item.classList.add('chosen');
  const minutes = pair.entry_min ?? pair.tcpa_min;
  button.append(element('b', pair.a_name), element('span', minutes > 0 ? `${minutes.toFixed(1)} min` : 'now'),
                element('b', pair.b_name), element('span', pair.cpa_m === null ? '' : `${pair.cpa_m.toFixed(0)} m`, 'quiet'));
  button.addEventListener('click', () => {
    chosen = pair;
    const ship = state.ships.find((one) => one[0] === pair.a);
    if (ship) { view = {lon: ship[3], y: north(ship[2]), scale: Math.max(view.scale, 6000)}; touchedView = true; }
    show();
  });
  item.append(button);
  return item;
}

function list(title, note, pairs) {
  const heading = element('h2', `${title} `);
  heading.append(element('small', note));
  const rows = document.createElement('ol');
  rows.append(...pairs.slice(0, 200).map(row));
  return [heading, pairs.length ? rows : element('p', 'no pair', 'none')];
}

function show() {
  const when = state.now === null ? 'no ship yet' : state.now > 1e6 ? new Date(state.now * 1000).toISOString().replace('T', ' ').slice(0, 19) + ' UTC' : `${state.now.toFixed(0)} s`;
  $('title').textContent = state.table;
  $('zones').hidden = !areas.some((area) => !area.own);
  $('facts').textContent = `${state.ships.length} ships, ${state.ships.filter((ship) => ship[5] !== null).length} under way \n${when}`;
  const focus = document.activeElement && [...document.querySelectorAll('li button')].indexOf(document.activeElement);
  const place = $('lists').scrollTop;
  $('lists').replaceChildren(...(state.watches.length ? state.watches.flatMap((watch) => {
    const pairs = watch.pairs.map((pair) => ({...pair, watch: watch.name}));
    const there = watch.of_areas && !watch.within ? 'inside' : `within ${watch.within} m`, note = watch.of_areas ? `entry to ${watch.other}` : 'TCPA, CPA';
    return [...list('To come', `${watch.name}: ${there} in ${watch.horizon / 60} min; ${note}`, pairs.filter((pair) => !pair.near)),
            ...list(there[0].toUpperCase() + there.slice(1), watch.of_areas ? watch.name : '', pairs.filter((pair) => pair.near))];
  }) : [element('p', 'This table has no watch: feed --watch NAME creates one.', 'none')]));
  $('lists').scrollTop = place;
  if (focus >= 0) document.querySelectorAll('li button')[focus]?.focus();
  draw();
}

async function poll() {
  try {
    const answer = await fetch('state' + (state ? `?version=${state.version}&areas=${state.areas_version}` : ''));
    if (answer.status === 200) {
      const first = !state || !state.ships.length;
      state = await answer.json();
      if (state.areas) areas = Object.entries(state.areas).flatMap(([table, rows]) => rows.map(([number, name, rings]) => ({table, number, name,
        own: table.toLowerCase() === state.table.toLowerCase(), rings: rings.map(ringOf)})));
      for (const ship of state.ships) {
        const track = tracks.get(ship[0]) || [], last = track[track.length - 1], point = [ship[3], north(ship[2])];
        if (!last || last[0] !== point[0] || last[1] !== point[1]) track.push(point);
        if (track.length > TRACK) track.shift();
        tracks.set(ship[0], track);
      }
      if (first && !touchedView) fit();
      show();
    } else if (answer.status !== 204) throw new Error((await answer.json()).error);
    $('problem').hidden = true;
    document.documentElement.dataset.state = coast ? 'ready' : 'reading';
  } catch (error) {
    $('problem').textContent = error instanceof TypeError ? 'The server does not answer: start foresee map again.' : error.message;
    $('problem').hidden = false;
  }
  setTimeout(poll, 1000);
}

let drag = null;
canvas.addEventListener('pointerdown', (event) => { drag = [event.clientX, event.clientY]; canvas.setPointerCapture(event.pointerId); });
canvas.addEventListener('pointerup', () => { drag = null; });
canvas.addEventListener('pointermove', (event) => {
  if (drag) {
    view = {...view, lon: view.lon - (event.clientX - drag[0]) / view.scale, y: view.y + (event.clientY - drag[1]) / view.scale};
    drag = [event.clientX, event.clientY];
    touchedView = true;
    draw();
    return;
  }
  const near = (state ? state.ships : []).map((ship) => [ship, ...screen(ship[3], north(ship[2]))])
    .map(([ship, x, y]) => [Math.hypot(x - event.offsetX, y - event.offsetY), ship]).sort((a, b) => a[0] - b[0])[0];
  $('tip').hidden = !near || near[0] > 12;
  if ($('tip').hidden) return;
  const ship = near[1];
  $('tip').textContent = `${ship[1]}\n${ship[5] === null ? 'at rest' : `${ship[4]} kn, course ${ship[5]}°`}\n${Math.abs(ship[2]).toFixed(4)} ${ship[2] < 0 ? 'S' : 'N'} ${Math.abs(ship[3]).toFixed(4)} ${ship[3] < 0 ? 'W' : 'E'}`;
  $('tip').style.left = `${Math.min(event.offsetX + 14, canvas.clientWidth - 190)}px`;
  $('tip').style.top = `${Math.min(event.offsetY + 14, canvas.clientHeight - 80)}px`;
});
canvas.addEventListener('wheel', (event) => { event.preventDefault(); zoomAt(2 ** (-event.deltaY / 300), event.offsetX, event.offsetY); }, {passive: false});
const all = () => { touchedView = false; fit(); draw(); };
$('in').addEventListener('click', () => zoomAt(1.6));
$('out').addEventListener('click', () => zoomAt(1 / 1.6));
$('all').addEventListener('click', all);
canvas.addEventListener('keydown', (event) => {
  const step = 60 / view.scale, moves = {ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, step], ArrowDown: [0, -step]};
  if (event.key in moves) { view.lon += moves[event.key][0]; view.y += moves[event.key][1]; touchedView = true; draw(); event.preventDefault(); }
  if (event.key === '+' || event.key === '=') zoomAt(1.6);
  if (event.key === '-') zoomAt(1 / 1.6);
  if (event.key === '0') all();
});
window.addEventListener('resize', draw);
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', draw);

fetch('coast.json').then((answer) => answer.json()).then((read) => {
  coast = coastOf(read, (lon, lat) => [lon, north(lat)]);
  draw();
});
fit();
poll();
