-- Creates version_0_1.db with the library of version 0.1 (format 2, no key `features`):
--
--   sqlite3 :memory: ".load ./foresee" ".read version_0_1.sql"
PRAGMA page_size = 4096;

-- Discs with t, loaded at once, then changed, so that the tree has both kinds of history.
CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy, r);
WITH n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 200)
INSERT INTO ships SELECT i, 100 + i % 7 * 0.25, i * 37.5 % 1000, i * 53.25 % 900, i % 7 - 3, i % 5 - 2, i % 3 FROM n;
UPDATE ships SET t = t + 1, x = x + vx, y = y + vy WHERE id % 4 = 0;
DELETE FROM ships WHERE id % 10 = 9;

-- Accelerated boxes with auxiliary columns of every type.
CREATE VIRTUAL TABLE crates USING moving_objects(id, x, y, vx, vy, ax, ay, hx, hy, +label TEXT, +cargo, horizon = 30);
WITH n(i) AS (SELECT -20 UNION ALL SELECT i + 1 FROM n WHERE i < 19)
INSERT INTO crates SELECT i, i * 8.5, i * i * 0.5, 1.5 - i % 3, 0, 0.125 * (i % 5), -0.25, 1, 1 + abs(i) % 2,
  'crate ' || i, CASE abs(i) % 5 WHEN 0 THEN NULL WHEN 1 THEN i WHEN 2 THEN i / 8.0 WHEN 3 THEN 'häfen' ELSE x'00ff' END
FROM n;

-- Forced cylinders with until.
CREATE VIRTUAL TABLE drones USING moving_objects(id, t, x, y, z, vx, vy, vz, fx, fy, fz, m, r, hz, until);
WITH n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 40)
INSERT INTO drones SELECT i, i % 4, i * 11.5 % 97, i * 7.25 % 89, i % 6 * 5, i % 3 - 1, 1 - i % 3, 0.5, 0, 0.25, -1, 2,
  1.5, 2, CASE WHEN i % 2 THEN i % 4 + 60 END FROM n;

VACUUM INTO 'version_0_1.db';
