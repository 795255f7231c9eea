.load build/release/foresee
.mode box

.print "A geofence in degrees: ships report latitude, longitude, knots and a course; a zone is a polygon on the chart."
.print
CREATE VIRTUAL TABLE ships USING moving_objects(id, t, lat, lon, speed, course, +name TEXT, origin = '53.9 7.9', speed_unit = knots);
INSERT INTO ships VALUES
  (211, 0, 53.88, 7.70, 14,  90, 'Anna'),       -- eastward
  (244, 0, 53.98, 7.90, 10,   0, 'Bruno'),      -- northward, away from the zone
  (219, 0, 53.90, 7.88,  0, NULL, 'Dora');      -- at anchor
CREATE VIRTUAL TABLE zones USING moving_objects(id, zone, +name TEXT, origin = '53.9 7.9');
INSERT INTO zones VALUES (1, 'POLYGON((7.8 53.85, 8 53.85, 7.95 53.95, 7.8 53.9, 7.8 53.85))', 'nature reserve');
SELECT s.name, z.name AS zone, round(j.dt / 60, 1) AS in_minutes, round(j.dt_end / 60, 1) AS until_minutes
  FROM predictive_join(3600, 'ships', 0, 'zones') j JOIN ships s ON s.id = j.a JOIN zones z ON z.id = j.b ORDER BY j.dt;

.print
.print "Where does Anna enter?"
.print
SELECT round(p.lat, 4) AS lat, round(p.lon, 4) AS lon
  FROM predictive_join(3600, 'ships', 0, 'zones') j, predictive_position(j.t, 'ships') p WHERE j.a = 211 AND p.id = j.a;

.print
.print "A watch keeps the answer: Anna turns south, Bruno comes about.   SELECT * FROM predictive_changes('fence', 1)"
.print
CREATE VIRTUAL TABLE fence USING predictive_watch(ships, horizon = 3600, other = zones);
UPDATE ships SET t = 300, lon = 7.73, course = 180 WHERE id = 211;
UPDATE ships SET t = 300, lat = 53.995, course = 180 WHERE id = 244;
SELECT c.seq, c.op, s.name, z.name AS zone, round((c.t - c.now) / 60, 1) AS in_minutes
  FROM predictive_changes('fence', 1) c JOIN ships s ON s.id = c.a JOIN zones z ON z.id = c.b;

.print
.print "The two ships nearest to a buoy at 53.92 N, 7.9 E within the next half hour:"
.print
SELECT s.name, round(n.distance) AS metres, round(n.dt / 60, 1) AS in_minutes
  FROM predictive_nearest n JOIN ships s ON s.id = n.id
  WHERE n.h = 1800 AND n.tbl = 'ships' AND n.k = 2 AND n.lat = 53.92 AND n.lon = 7.9 ORDER BY n.rank;
