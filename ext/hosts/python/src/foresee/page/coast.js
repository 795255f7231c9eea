// The coast of coast.json on a plane: read once for a projection, drawn for any view. Used by the map and by the browser page.
//
//   const coast = coastOf(await answer.json(), (lon, lat) => [lon, north(lat)]);
//   drawCoast(pen, coast, {seen: [x0, y0, x1, y1], onScreen: (x, y) => [left, top], width, height, pixel: 1, land, water, shore});
'use strict';

// A string of coast.json: differences in zigzag, five bits per character from '?' on.
function decodedRing(text, units) {
  const ring = [];
  let place = 0;
  const value = () => {
    let result = 0, shift = 0, bits;
    do { bits = text.charCodeAt(place++) - 63; result += (bits & 31) * 2 ** shift; shift += 5; } while (bits & 32);
    return result % 2 ? -(result + 1) / 2 : result / 2;
  };
  for (let lon = 0, lat = 0; place < text.length;) {
    lon += value(); lat += value();
    ring.push([lon / units, lat / units]);
  }
  return ring;
}

function withBox(ring) {
  ring.box = [Infinity, Infinity, -Infinity, -Infinity];
  for (const [x, y] of ring) ring.box = [Math.min(ring.box[0], x), Math.min(ring.box[1], y), Math.max(ring.box[2], x), Math.max(ring.box[3], y)];
  return ring;
}

const overlap = (a, b) => a[0] < b[2] && a[2] > b[0] && a[1] < b[3] && a[3] > b[1];

// What of a ring is within a box: Sutherland and Hodgman.
function cutRing(ring, box) {
  for (const [axis, limit, sign] of [[0, box[0], 1], [1, box[1], 1], [0, box[2], -1], [1, box[3], -1]]) {
    const kept = [];
    ring.forEach((b, i) => {
      const a = ring[(i || ring.length) - 1], [insideA, insideB] = [a, b].map((point) => sign * (point[axis] - limit) >= 0);
      if (insideA !== insideB) {
        const share = (limit - a[axis]) / (b[axis] - a[axis]), point = [0, 1].map((k) => a[k] + share * (b[k] - a[k]));
        point[axis] = limit;
        kept.push(point);
      }
      if (insideB) kept.push(b);
    });
    ring = kept;
  }
  return ring;
}

// `near`: [west, south, east, north] to which all is cut; its longitudes may pass 180.
function coastOf(read, project, near = null) {
  const copies = (ring) => near ? [-360, 0, 360].map((shift) => withBox(ring.map(([lon, lat]) => [lon + shift, lat])))
    .filter((one) => overlap(one.box, near)).map((one) => cutRing(one, near)).filter((one) => one.length > 2) : [ring];
  // An edge along a box where a ring was cut is no shore.
  const projected = (ring, boxes) => {
    const sides = boxes.flatMap(([west, south, east, top]) => [[0, west], [0, east], [1, south], [1, top]]);
    const isCut = (a, b) => sides.some(([axis, limit]) => Math.abs(a[axis] - limit) < 2e-3 && Math.abs(b[axis] - limit) < 2e-3);
    const made = withBox(ring.map((point) => project(...point)));
    made.isCut = ring.map((from, i) => isCut(from, ring[(i + 1) % ring.length]));
    return made;
  };
  const rings = (texts, units, boxes) => texts.flatMap((text) => copies(decodedRing(text, units))).map((ring) => projected(ring, boxes));
  const border = ([west, south, east, top]) => {
    const corners = [[west, south], [east, south], [east, top], [west, top], [west, south]], steps = 60;
    return corners.slice(1).flatMap((to, i) => Array.from({length: steps}, (_, k) => corners[i].map((from, axis) => from + (to[axis] - from) * k / steps)));
  };
  const cuts = near ? [near] : [];
  return {world: rings(read.world, read.world_units, cuts),
          regions: read.regions.flatMap(({box, rings: texts}) => copies(border(box)).map((edge) => ({
            border: projected(edge, []), rings: rings(texts, read.units, [box, ...cuts])})))};
}

function traceRings(pen, rings, view) {
  const seen = rings.filter(({box}) => overlap(box, view.seen));
  pen.beginPath();
  for (const ring of seen) {
    ring.forEach((point, i) => i ? pen.lineTo(...view.onScreen(...point)) : pen.moveTo(...view.onScreen(...point)));
    pen.closePath();
  }
  return seen;
}

function drawShore(pen, rings, view) {
  pen.beginPath();
  for (const ring of rings) {
    ring.forEach((from, i) => {
      if (ring.isCut[i]) return;
      if (i === 0 || ring.isCut[i - 1]) pen.moveTo(...view.onScreen(...from));
      pen.lineTo(...view.onScreen(...ring[(i + 1) % ring.length]));
    });
  }
  pen.stroke();
}

function drawCoast(pen, coast, view) {
  const around = (region) => region.border.forEach((point, i) => i ? pen.lineTo(...view.onScreen(...point)) : pen.moveTo(...view.onScreen(...point)));
  const land = (rings) => {
    pen.fillStyle = pen.strokeStyle = view.land; pen.lineWidth = view.pixel;
    const seen = traceRings(pen, rings, view);
    pen.fill('evenodd'); pen.stroke();      // half a pixel more, so that no seam shows where a ring was cut
    pen.strokeStyle = view.shore;
    drawShore(pen, seen, view);
  };
  pen.save();
  pen.beginPath();
  pen.rect(0, 0, view.width, view.height);
  coast.regions.forEach((region) => { around(region); pen.closePath(); });
  pen.clip('evenodd');
  land(coast.world);
  pen.restore();
  for (const region of coast.regions.filter((one) => overlap(one.border.box, view.seen))) {
    pen.beginPath(); around(region); pen.closePath();
    pen.fillStyle = view.water; pen.fill();
    land(region.rings);
  }
}
