.load build/release/foresee
.mode box

.print "A watch keeps the pairs of a join up to date, and tells what changed."
.print
CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy, r, +name TEXT);
INSERT INTO ships VALUES
  (1, 0,    0, 0,  6, 0, 30, 'Anna'),       -- eastward
  (2, 0, 1200, 0, -6, 0, 30, 'Bruno'),      -- westward on the same line
  (3, 0,  600, 300, 0, 0, 30, 'Dora');      -- at anchor
CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, horizon = 300);
SELECT a, b, t FROM alerts;

.print
.print "Anna reports at 20 s: she has slowed down.   SELECT * FROM predictive_changes('alerts', 1)"
.print
UPDATE ships SET t = 20, x = 120, vx = 3 WHERE name = 'Anna';
SELECT * FROM predictive_changes('alerts', 1);

.print
.print "Bruno turns to the north-west at 40 s, and makes for Dora."
.print
UPDATE ships SET t = 40, x = 960, vx = -6, vy = 5 WHERE name = 'Bruno';
SELECT * FROM predictive_changes('alerts', 2);

.print
.print "Nobody reports, but time passes: at 110 s they have parted.   INSERT INTO alerts(alerts, now) VALUES('advance', 110)"
.print
INSERT INTO alerts(alerts, now) VALUES('advance', 110);
SELECT * FROM predictive_changes('alerts', (SELECT max(seq) - 1 FROM alerts_log));
SELECT name, now, seq, pairs FROM predictive_watches;
