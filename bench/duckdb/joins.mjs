// The two joins of moving objects as one writes them in DuckDB's SQL, and the tables that they read.
//
//   import {joinOf, swept} from './joins.mjs'
//
// Objects are boxes (hx, hy) or discs (r) in uniform motion, from time 0 to h. The contact is a textbook's in plain
// double, as an expression over two rows p and q.

// Rows of objects with the box that each sweeps from 0 to h.
export function swept(h, discs) {
  const hx = discs ? 'r' : 'hx', hy = discs ? 'r' : 'hy'
  return `SELECT *, least(x, x + vx * ${h}) - ${hx} AS x0, greatest(x, x + vx * ${h}) + ${hx} AS x1,
                    least(y, y + vy * ${h}) - ${hy} AS y0, greatest(y, y + vy * ${h}) + ${hy} AS y1 FROM objects`
}

// Start and end of the overlap on one axis; an axis without relative speed overlaps always or never.
function overlap(axis) {
  const d = `(q.${axis} - p.${axis})`, v = `(q.v${axis} - p.v${axis})`, s = `(p.h${axis} + q.h${axis})`
  const bound = (side) => `CASE WHEN ${v} = 0 THEN CASE WHEN abs(${d}) <= ${s} THEN ${side}1e300 ELSE 1e300 END
                                ELSE (-${d} ${side} sign(${v}) * ${s}) / ${v} END`
  return [bound('-'), bound('+')]
}

// The first time of contact of p and q, or NULL.
export function contact(h, discs) {
  if (discs) {
    const a = '((q.vx - p.vx) ** 2 + (q.vy - p.vy) ** 2)'
    const b = '((q.x - p.x) * (q.vx - p.vx) + (q.y - p.y) * (q.vy - p.vy))'
    const c = '((q.x - p.x) ** 2 + (q.y - p.y) ** 2 - (p.r + q.r) ** 2)'
    const first = `(-${b} - sqrt(${b} * ${b} - ${a} * ${c})) / ${a}`
    return `CASE WHEN ${c} <= 0 THEN 0 WHEN ${b} >= 0 OR ${b} * ${b} < ${a} * ${c} THEN NULL
                 WHEN ${first} <= ${h} THEN ${first} END`
  }
  const [xStart, xEnd] = overlap('x'), [yStart, yEnd] = overlap('y')
  return `CASE WHEN greatest(0, ${xStart}, ${yStart}) <= least(${h}, ${xEnd}, ${yEnd})
               THEN greatest(0, ${xStart}, ${yStart}) END`
}

const boxesMeet = 'p.x0 <= q.x1 AND q.x0 <= p.x1 AND p.y0 <= q.y1 AND q.y0 <= p.y1'

// The ranges of the swept boxes, compared as they stand.
const range = (h, discs) => `
  WITH boxes AS (${swept(h, discs)})
  SELECT p.id AS a, q.id AS b, ${contact(h, discs)} AS t FROM boxes p JOIN boxes q ON p.id < q.id AND ${boxesMeet}`

// A grid by hand: each box in every cell that it meets, cells of the mean extent, joined by equal cells. A pair that
// shares several cells is kept in the first of them.
const cells = (h, discs) => `
  WITH boxes AS (${swept(h, discs)}),
  size AS (SELECT avg(x1 - x0 + y1 - y0) / 2 AS cell FROM boxes),
  placed AS (SELECT *, floor(x0 / cell)::INT AS cx0, floor(x1 / cell)::INT AS cx1,
                    floor(y0 / cell)::INT AS cy0, floor(y1 / cell)::INT AS cy1 FROM boxes, size),
  columns AS (SELECT *, unnest(range(cx0, cx1 + 1)) AS cx FROM placed),
  entries AS (SELECT *, unnest(range(cy0, cy1 + 1)) AS cy FROM columns)
  SELECT p.id AS a, q.id AS b, ${contact(h, discs)} AS t FROM entries p JOIN entries q
    ON p.cx = q.cx AND p.cy = q.cy AND p.id < q.id AND ${boxesMeet}
    WHERE p.cx = greatest(p.cx0, q.cx0) AND p.cy = greatest(p.cy0, q.cy0)`

export const methods = {'DuckDB cells': cells, 'DuckDB range join': range}

export function joinOf(method, h, discs) {
  return `CREATE OR REPLACE TEMP TABLE pairs AS SELECT * FROM (${methods[method](h, discs)}) WHERE t IS NOT NULL`
}
