-- What every target answers bit for bit as the native build does (tests/release/targets.py). Numbers come by integer
-- arithmetic, since SQLite's own reading of decimals is not what is tested; every question says its order.

CREATE TABLE u(i INTEGER PRIMARY KEY, a REAL, b REAL, c REAL, d REAL, e REAL, f REAL, g REAL, h REAL);
WITH RECURSIVE s(i, n) AS (SELECT 0, 20261124 UNION ALL SELECT i + 1, (n * 1103515245 + 12345) % 2147483648 FROM s WHERE i < 23999)
INSERT INTO u SELECT i / 8, max(n) FILTER (WHERE i % 8 = 0), max(n) FILTER (WHERE i % 8 = 1), max(n) FILTER (WHERE i % 8 = 2),
    max(n) FILTER (WHERE i % 8 = 3), max(n) FILTER (WHERE i % 8 = 4), max(n) FILTER (WHERE i % 8 = 5),
    max(n) FILTER (WHERE i % 8 = 6), max(n) FILTER (WHERE i % 8 = 7)
  FROM (SELECT i, (n >> 8) / 8388608.0 AS n FROM s) GROUP BY i / 8;
SELECT count(*), min(a), max(h) FROM u;

-- README's first question.
CREATE VIRTUAL TABLE ships USING moving_objects(id, x, y, vx, vy, r, +name TEXT);
INSERT INTO ships VALUES (1, 0, 0, 6, 0, 30, 'Anna'), (2, 1200, 0, -6, 0, 30, 'Bruno'), (3, 600, -1600, 0, 8, 30, 'Clara'),
  (4, 600, 300, 0, 0, 30, 'Dora');
SELECT s.name, o.name, j.t, j.t_end FROM predictive_join(300) j JOIN ships s ON s.id = j.a JOIN ships o ON o.id = j.b ORDER BY j.t;

-- Discs with reports of different ages, growth and ends.
CREATE VIRTUAL TABLE discs USING moving_objects(id, t, x, y, vx, vy, r, growth, until, +name TEXT);
INSERT INTO discs SELECT i, floor(8 * h), 6000 * a, 6000 * b, 24 * c - 12, 24 * d - 12, 40 * e, iif(i % 3 = 0, f / 4, 0),
    iif(i % 7 = 0, 100 + 400 * g, NULL), 'n' || i FROM u WHERE i < 900;
SELECT * FROM predictive_join(300, 'discs', NULL, NULL, 8) ORDER BY t, a, b;
SELECT * FROM predictive_join(120, 'discs', 50, NULL, 8, 'tree') ORDER BY a, b;
SELECT a, b, t, d_cpa FROM predictive_join(120, 'discs', 50, NULL, 8, 'grid') ORDER BY t, a, b LIMIT 300;
SELECT a, b, t_end FROM predictive_join(120, 'discs', 50, NULL, 8, 'scan') WHERE dt > 10 ORDER BY a, b;
SELECT a, b, dt_cpa FROM predictive_join(60, 'discs', 0, NULL, 8, 'gpcd') ORDER BY a, b;
SELECT n_after FROM predictive_explain(300, 'discs', 0, NULL, 8) WHERE stage = 'refinement';
SELECT * FROM predictive_window(200, 'discs', 1000, 1500, 2000, 2400, NULL, NULL, 8, 3, -2) ORDER BY id;
SELECT * FROM predictive_window WHERE h = 200 AND tbl = 'discs' AND now = 8
  AND zone = 'POLYGON((500 500, 2500 700, 2200 3000, 1200 1400, 500 500), (1400 900, 2000 1000, 1900 1500, 1400 900))' ORDER BY id;
SELECT * FROM predictive_nearest(200, 'discs', 40, 3000, 3000, NULL, 8, 1, 2) ORDER BY rank;
SELECT * FROM predictive_position(77, 'discs') ORDER BY id;
SELECT * FROM predictive_track(10, 100, 7, 'discs') WHERE id IN (5, 50, 500) ORDER BY t, id;
SELECT * FROM predictive_sweep(60, 'discs', 30, 8) ORDER BY id;
SELECT a, b, t FROM predictive_join WHERE h = 300 AND tbl = 'discs' AND now = 8 AND own_x0 = 2000 AND own_x1 = 4000 AND own_y0 = 1000
  ORDER BY a, b;

-- Accelerated motion, forces, and both sides of a join.
CREATE VIRTUAL TABLE curves USING moving_objects(id, t, x, y, vx, vy, ax, ay, r);
INSERT INTO curves SELECT i, floor(4 * h), 3000 * a, 3000 * b, 20 * c - 10, 20 * d - 10, (e - 0.5) / 4, (f - 0.5) / 4, 20 * g
  FROM u WHERE i BETWEEN 900 AND 1199;
CREATE VIRTUAL TABLE pushed USING moving_objects(id, x, y, vx, vy, fx, fy, m, until);
INSERT INTO pushed SELECT i, 3000 * a, 3000 * b, 20 * c - 10, 20 * d - 10, e - 0.5, f - 0.5, 1 + 8 * g, 200 + 100 * h
  FROM u WHERE i BETWEEN 1200 AND 1399;
SELECT * FROM predictive_join(120, 'curves') ORDER BY t, a, b;
SELECT * FROM predictive_join(120, 'pushed', 25, NULL, 0) ORDER BY t, a, b;
SELECT * FROM predictive_join(120, 'curves', 10, 'pushed', 4) ORDER BY a, b;
SELECT * FROM predictive_nearest(90, 'curves', 30, 1500, 1500) ORDER BY rank;
SELECT * FROM predictive_window(90, 'pushed', 1000, 1800, 1000, 1800) ORDER BY id;
SELECT * FROM predictive_position(50, 'pushed') ORDER BY id;

-- Boxes; spheres, cylinders and points in space; one axis.
CREATE VIRTUAL TABLE boxes USING moving_objects(id, x, y, vx, vy, hx, hy, growth);
INSERT INTO boxes SELECT i, 5000 * a, 5000 * b, 30 * c - 15, 30 * d - 15, 60 * e, 60 * f, iif(i % 4 = 0, g / 8, 0)
  FROM u WHERE i BETWEEN 1400 AND 1799;
SELECT * FROM predictive_join(100, 'boxes') ORDER BY t, a, b;
SELECT * FROM predictive_join(100, 'boxes', 15, 'discs', 8) ORDER BY a, b;
CREATE VIRTUAL TABLE balls USING moving_objects(id, x, y, z, vx, vy, vz, r);
INSERT INTO balls SELECT i, 800 * a, 800 * b, 800 * c, 20 * d - 10, 20 * e - 10, 20 * f - 10, 25 * g FROM u WHERE i BETWEEN 1800 AND 2099;
SELECT * FROM predictive_join(60, 'balls') ORDER BY t, a, b;
SELECT * FROM predictive_nearest(60, 'balls', 20, 400, 400, 400) ORDER BY rank;
CREATE VIRTUAL TABLE aircraft USING moving_objects(id, x, y, z, vx, vy, vz, r, hz, growth, growth_z);
INSERT INTO aircraft SELECT i, 9000 * a, 9000 * b, 2000 * c, 400 * d - 200, 400 * e - 200, 10 * f - 5, 150 * g, 30 * h, g / 2, h / 8
  FROM u WHERE i BETWEEN 2100 AND 2299;
SELECT * FROM predictive_join(60, 'aircraft', 100, NULL, 0, 'auto', 20) ORDER BY t, a, b;
CREATE VIRTUAL TABLE beads USING moving_objects(id, x, vx, ax, hx);
INSERT INTO beads SELECT i, 900 * a, 20 * b - 10, c - 0.5, d FROM u WHERE i BETWEEN 2300 AND 2339;
SELECT * FROM predictive_join(20, 'beads') ORDER BY t, a, b;

-- Outlines that are turned, prisms, meshes.
CREATE VIRTUAL TABLE hulls USING moving_objects(id, x, y, vx, vy, shape, heading, r, growth);
INSERT INTO hulls SELECT i, 2500 * a, 2500 * b, 20 * c - 10, 20 * d - 10,
    CASE i % 3 WHEN 0 THEN 'POLYGON((-8 -90, 8 -90, 8 60, 0 90, -8 60, -8 -90))'
      WHEN 1 THEN 'POLYGON((-40 -40, 40 -40, 40 40, 20 40, 20 -20, -20 -20, -20 40, -40 40, -40 -40))' ELSE NULL END,
    iif(i % 2 = 0, 360 * e - 180, 90), iif(i % 3 = 2, 30 * f, 2 * f), iif(i % 5 = 0, g / 16, 0) FROM u WHERE i BETWEEN 2340 AND 2459;
SELECT * FROM predictive_join(120, 'hulls') ORDER BY t, a, b;
SELECT * FROM predictive_join(120, 'hulls', 10, 'discs', 8) ORDER BY a, b;
SELECT id, shape, heading FROM hulls WHERE id < 2350 ORDER BY id;
SELECT * FROM predictive_window WHERE h = 60 AND tbl = 'hulls' AND wvx = 2 AND zone = 'POLYGON((400 0, 1600 200, 900 1800, 400 0))' ORDER BY id;
CREATE VIRTUAL TABLE towers USING moving_objects(id, x, y, z, vx, vy, vz, shape, heading, hz);
INSERT INTO towers SELECT i, 1200 * a, 1200 * b, 200 * c, 20 * d - 10, 20 * e - 10, 4 * f - 2,
    'POLYGON((-30 -20, 30 -20, 0 40, -30 -20))', 360 * g - 180, 20 * h FROM u WHERE i BETWEEN 2460 AND 2519;
SELECT * FROM predictive_join(60, 'towers') ORDER BY t, a, b;
CREATE VIRTUAL TABLE bodies USING moving_objects(id, x, y, z, vx, vy, vz, shape, heading, r);
INSERT INTO bodies SELECT i, 300 * a, 300 * b, 300 * c, 20 * d - 10, 20 * e - 10, 20 * f - 10,
    CASE i % 3 WHEN 0 THEN 'TIN Z(((-50 -50 0, 50 -50 0, 0 50 20, -50 -50 0)))' WHEN 1 THEN 'POLYHEDRALSURFACE Z(((0 0 -20, 0 30 0, 30 0 0, 0 0 -20)),
      ((0 0 -20, 30 0 0, -30 -30 0, 0 0 -20)), ((0 0 -20, -30 -30 0, 0 30 0, 0 0 -20)), ((30 0 0, 0 30 0, -30 -30 0, 30 0 0)))' ELSE NULL END,
    iif(i % 2 = 0, 360 * g - 180, 0), 8 * h FROM u WHERE i BETWEEN 2520 AND 2569;
SELECT * FROM predictive_join(30, 'bodies') ORDER BY t, a, b;

-- Manoeuvres; a watch that follows changes.
SELECT * FROM predictive_avoid(120, 'discs', 17, 20, NULL, NULL, NULL, 8, NULL, NULL, 'ignore') ORDER BY manoeuvre, k_from, k_to, clear;
SELECT * FROM predictive_avoid(60, 'curves', 1011, 20, 'accelerate', -1, 1, 4, NULL, NULL, 'ignore') ORDER BY manoeuvre, k_from, k_to, clear;
SELECT * FROM predictive_avoid(60, 'hulls', 2340, 5, 'turn', -90, 90, 0, NULL, NULL, 'ignore') ORDER BY manoeuvre, k_from, k_to, clear;
CREATE VIRTUAL TABLE alerts USING predictive_watch(discs, horizon = 200, within = 20);
SELECT * FROM alerts ORDER BY a, b;
CREATE TABLE reader AS SELECT seq FROM predictive_watches;
UPDATE discs SET t = 20, x = x + 20 * vx, y = y + 20 * vy, vx = -vx WHERE id % 9 = 0;
DELETE FROM discs WHERE id % 31 = 0;
INSERT INTO alerts(alerts, now) VALUES ('advance', 40);
SELECT op, a, b, t, now FROM predictive_changes('alerts', (SELECT seq FROM reader)) ORDER BY now, a, b, op;
SELECT * FROM alerts ORDER BY a, b;

-- Many objects, with helper threads.
PRAGMA threads = 2;
CREATE VIRTUAL TABLE crowd USING moving_objects(id, x, y, vx, vy, r);
INSERT INTO crowd SELECT p.i * 10 + q.i, 900 * (p.a + q.b) + 40000 * p.c, 900 * (p.d + q.e) + 40000 * q.f * p.g, 10 * p.h - 5, 10 * q.a - 5,
    8 * q.b + p.b FROM u p, u q WHERE p.i < 3000 AND q.i < 10;
SELECT count(*), min(t), max(t_end) FROM predictive_join(60, 'crowd', 5);
SELECT * FROM predictive_join(60, 'crowd', 5) WHERE dt > 0 ORDER BY t, a, b LIMIT 2000;

-- Commands, errors, and what SQLite itself says of the file.
INSERT INTO discs(discs) VALUES ('rebuild');
INSERT INTO discs(discs) VALUES ('integrity-check');
INSERT INTO hulls(hulls) VALUES ('optimize');
INSERT INTO hulls(hulls) VALUES ('integrity-check');
INSERT INTO alerts(alerts) VALUES ('integrity-check');
INSERT INTO ships(id, x, y, r) VALUES (9, 0, 0, -30);
INSERT INTO ships(id, x, y) VALUES (9, 'east', 0);
INSERT INTO hulls(id, x, y, shape) VALUES (7, 0, 0, 'POLYGON((0 0, 2 2, 2 0, 0 2, 0 0))');
SELECT * FROM predictive_join(-1, 'ships');
SELECT * FROM predictive_join(10, 'shops');
CREATE VIRTUAL TABLE bad USING moving_objects(id, x, vxx);
PRAGMA integrity_check;
