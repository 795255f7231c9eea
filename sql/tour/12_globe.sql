.load build/release/foresee
.mode box

.print "Ships on both sides of the date line, where longitude changes from 180 to -180: a table with origin = globe."
.print
CREATE VIRTUAL TABLE ships USING moving_objects(id, t, lat, lon, speed, course, r, +name TEXT,
  origin = globe, speed_unit = knots);
INSERT INTO ships VALUES
  (1, 0, -18.500,  179.950, 14,  90, 60, 'Anna'),      -- east of Fiji, eastward
  (2, 0, -18.505, -179.940, 12, 270, 60, 'Bruno'),     -- westward, on the other side of the date line
  (3, 0, -18.460, -179.990,  9, 180, 40, 'Clara'),     -- southward
  (4, 0, -18.500,  179.700,  0, NULL, 90, 'Dora');     -- at anchor
SELECT name, lat, lon, speed AS knots, course FROM ships ORDER BY id;

.print
.print "Who comes within half a nautical mile (926 m) in the next half hour, when, how close, and where?"
.print
SELECT a.name AS ship, b.name AS other, round(j.t_cpa / 60, 1) AS tcpa_minutes, round(j.d_cpa) AS cpa_metres,
       round(p.lat, 4) AS lat, round(p.lon, 4) AS lon
  FROM predictive_join(1800, 'ships', 926) j JOIN ships a ON a.id = j.a JOIN ships b ON b.id = j.b,
       predictive_position(j.t_cpa, 'ships') p
  WHERE p.id = j.a ORDER BY j.t_cpa;

.print
.print "Anna's path, a row per five minutes: the longitude changes its sign, the path goes on.   predictive_track(0, 1800, 300)"
.print
SELECT round(t / 60) AS minute, round(lat, 4) AS lat, round(lon, 4) AS lon
  FROM predictive_track(0, 1800, 300, 'ships') WHERE id = 1;

.print
.print "Which two ships come nearest to the wreck at 18.49 S, 180 E within the half hour?"
.print
SELECT s.name, round(n.distance) AS metres, round(n.dt / 60, 1) AS in_minutes
  FROM predictive_nearest n JOIN ships s ON s.id = n.id
  WHERE n.h = 1800 AND n.tbl = 'ships' AND n.k = 2 AND n.lat = -18.49 AND n.lon = 180 ORDER BY n.rank;

.print
.print "A watch keeps the pairs: after two minutes Bruno turns south, and Emil reports.   SELECT * FROM predictive_changes('alerts', 1)"
.print
CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 1800, within = 926);
BEGIN;
UPDATE ships SET t = 120, lon = -179.947, course = 180 WHERE name = 'Bruno';
INSERT INTO ships VALUES (5, 120, -18.540, -179.980, 10, 0, 50, 'Emil');
COMMIT;
SELECT c.op, a.name AS ship, b.name AS other, round((c.t - c.now) / 60, 1) AS in_minutes
  FROM predictive_changes('alerts', 1) c JOIN ships a ON a.id = c.a JOIN ships b ON b.id = c.b ORDER BY c.seq;
