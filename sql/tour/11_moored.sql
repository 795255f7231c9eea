.load build/release/foresee
.mode box

.print "A harbour: four ships at their berths, two under way. A watch of all of them holds every pair at the quay."
.print
CREATE TABLE reports(id INTEGER PRIMARY KEY, t, x, y, vx, vy, name);
INSERT INTO reports VALUES
  (1, 0,   0, 0, 0,   0, 'Anna'), (2, 0,  60, 0, 0, 0, 'Bruno'),      -- at the quay
  (3, 0, 120, 0, 0,   0, 'Clara'), (4, 0, 180, 0, 0.1, 0, 'Dora'),
  (5, 0, 100, 900, 0, -3, 'Emil'), (6, 0, 900, 500, -3, 0, 'Frida');  -- under way
CREATE VIRTUAL TABLE all_ships USING moving_objects(id, t, x, y, vx, vy, +name TEXT);
INSERT INTO all_ships SELECT * FROM reports;
CREATE VIRTUAL TABLE all_alerts USING predictive_watch(all_ships, horizon = 300, within = 200);
SELECT count(*) AS pairs, sum(t > 0) AS still_to_come FROM all_alerts;

.print
.print "Moored ships left out: category = iif(speed < 0.5, 2, 1), mask = iif(speed < 0.5, 1, 3). Two moored ships may not meet."
.print
CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy, category, mask, +name TEXT);
INSERT INTO ships
  SELECT id, t, x, y, vx, vy, iif(speed < 0.5, 2, 1), iif(speed < 0.5, 1, 3), name
  FROM (SELECT *, sqrt(vx * vx + vy * vy) AS speed FROM reports);
CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 300, within = 200);
SELECT s.name, o.name AS other, a.t FROM alerts a JOIN ships s ON s.id = a.a JOIN ships o ON o.id = a.b ORDER BY a.t, a.a, a.b;

.print
.print "Dora casts off: nothing but her category and mask change, and her pairs at the quay are news."
.print
UPDATE ships SET category = 1, mask = 3 WHERE name = 'Dora';
SELECT op, a, b, t FROM predictive_changes('alerts', 1);

.print
.print "What is under way in the next minute within 300 m of the quay?   ... WHERE mask = 1"
.print
SELECT w.id, s.name FROM predictive_window(60, 'ships', -300, 480, -300, 300) w JOIN ships s ON s.id = w.id WHERE w.mask = 1;

.print
.print "Which pairs does the rule leave out?   predictive_explain"
.print
SELECT stage, n_before, n_after FROM predictive_explain(300, 'ships', 200) LIMIT 2;
