-- How version_0_2.db was made, with the library of version 0.2:
--
--   sqlite3 :memory: ".load ./foresee" ".read version_0_2.sql"
PRAGMA page_size = 4096;

-- Discs with t and growth, loaded at once, then changed, and a watch of them that follows.
CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy, r, growth, +name TEXT);
WITH n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 200)
INSERT INTO ships SELECT i, 100 + i % 7 * 0.25, i * 37.5 % 1000, i * 53.25 % 900, i % 7 - 3, i % 5 - 2, i % 3, i % 4 * 0.125, 'ship ' || i
FROM n;
CREATE VIRTUAL TABLE near USING predictive_watch(ships, horizon = 60, within = 5);
UPDATE ships SET t = t + 1, x = x + vx, y = y + vy WHERE id % 4 = 0;
DELETE FROM ships WHERE id % 10 = 9;

-- Outlines: a hull of five corners, and a square dock with a hole; some are turned.
CREATE VIRTUAL TABLE hulls USING moving_objects(id, t, x, y, vx, vy, shape, heading, r);
WITH n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 40)
INSERT INTO hulls SELECT i, i % 3, i * 61.5 % 400, i * 29.25 % 350, i % 5 - 2, 1.5 - i % 4,
  CASE WHEN i % 8 THEN 'POLYGON((-4 -20, 4 -20, 4 12, 0 20, -4 12, -4 -20))'
       ELSE 'POLYGON((-30 -30, 30 -30, 30 30, -30 30, -30 -30), (-20 -20, -20 20, 20 20, 20 -20, -20 -20))' END,
  i * 23 % 360, i % 2 FROM n;

-- Meshes in three dimensions: a tetrahedron and a ramp.
CREATE VIRTUAL TABLE bodies USING moving_objects(id, x, y, z, vx, vy, vz, shape, heading);
INSERT INTO bodies
WITH n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 24)
SELECT i, i * 7.5 % 40, i * 11.25 % 35, i % 4 * 3, i % 3 - 1, 1 - i % 3, 0.5 - i % 2,
  CASE WHEN i % 3 THEN
    'POLYHEDRALSURFACE Z(((0 0 0, 0 2 0, 2 0 0, 0 0 0)), ((0 0 0, 2 0 0, 0 0 2, 0 0 0)), ((0 0 0, 0 0 2, 0 2 0, 0 0 0)), ((2 0 0, 0 2 0, 0 0 2, 2 0 0)))'
  ELSE
    'POLYHEDRALSURFACE Z(((0 0 0, 0 3 0, 4 3 0, 0 0 0)), ((0 0 0, 4 3 0, 4 0 0, 0 0 0)), ((0 0 0, 4 0 2, 4 3 2, 0 0 0)), ((0 0 0, 4 3 2, 0 3 0, 0 0 0)), ((4 0 0, 4 3 0, 4 3 2, 4 0 0)), ((4 0 0, 4 3 2, 4 0 2, 4 0 0)), ((0 0 0, 4 0 0, 4 0 2, 0 0 0)), ((0 3 0, 4 3 2, 4 3 0, 0 3 0)))'
  END, i * 45 % 360 FROM n;

VACUUM INTO 'version_0_2.db';
