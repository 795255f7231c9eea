.load build/release/foresee
.mode box

.print "Who should do what? Head-on, overtaking, crossing; and eight drones in a ring, each bound for the opposite side."
.print
CREATE VIRTUAL TABLE traffic USING moving_objects(id, t, x, y, vx, vy, r, +name TEXT);
INSERT INTO traffic VALUES
  (1, 0,    0,    0,  0,  10, 10, 'Ada'), (2, 0,    0, 1000, 0, -10, 10, 'Bob'),
  (3, 0, 2000,    0,  0,   4, 10, 'Cleo'), (4, 0, 2000, -400, 0,  12, 10, 'Dirk'),
  (5, 0, 4000, -300,  0,   8, 10, 'Eve'), (6, 0, 4400,  100, -8,  0, 10, 'Finn'),
  (11, 0, 7000,    0, -10,  0, 10, 'E'), (12, 0, 6950,  350,  -7, -7, 10, 'NE'),
  (13, 0, 6600,  400,   0, -8, 10, 'N'), (14, 0, 6250,  350,   7, -7, 10, 'NW'),
  (15, 0, 6200,    0,  10,  0, 10, 'W'), (16, 0, 6250, -350,   7,  7, 10, 'SW'),
  (17, 0, 6600, -400,   0,  8, 10, 'S'), (18, 0, 6950, -350,  -7,  7, 10, 'SE');

.print "What keeps Ada 50 m clear of everybody for a minute?   FROM predictive_avoid(60, 'traffic', 1, 50)"
.print
SELECT manoeuvre, clear, round(k_from, 3) AS k_from, round(k_to, 3) AS k_to, below, above
  FROM predictive_avoid(60, 'traffic', 1, 50);

.print
.print "All encounters in order of time, and for each in turn the least change of the one with the larger number:"
.print
CREATE TABLE advice(id INTEGER PRIMARY KEY, other INTEGER, t REAL, manoeuvre TEXT, k REAL);
CREATE TRIGGER dissolved BEFORE INSERT ON advice WHEN NOT EXISTS (SELECT 1 FROM predictive_join(60, 'traffic', 50)
    WHERE a = min(new.id, new.other) AND b = max(new.id, new.other)) BEGIN
  SELECT raise(IGNORE);
END;
CREATE TRIGGER give_way AFTER INSERT ON advice BEGIN
  UPDATE advice SET (manoeuvre, k) = (SELECT manoeuvre, k FROM predictive_avoid(60, 'traffic', new.id, 50)
    WHERE clear ORDER BY manoeuvre = 'speed', round(abs(k), 6), k DESC LIMIT 1) WHERE id = new.id;
  UPDATE traffic SET (t, x, y, vx, vy) = (m.t, m.x, m.y, m.vx, m.vy)
    FROM advice a, predictive_avoid(60, 'traffic', new.id, 50, a.manoeuvre, a.k, a.k) m
    WHERE a.id = new.id AND traffic.id = new.id AND m.clear;
END;
SELECT count(*) AS encounters FROM predictive_join(60, 'traffic', 50) WHERE dt > 0;
INSERT OR IGNORE INTO advice(id, other, t)
  SELECT max(a, b), min(a, b), t FROM predictive_join(60, 'traffic', 50) WHERE dt > 0 ORDER BY t, a, b;
SELECT s.name, o.name AS "for", round(d.t, 1) AS t, d.manoeuvre, round(d.k, 2) AS k
  FROM advice d JOIN traffic s ON s.id = d.id JOIN traffic o ON o.id = d.other ORDER BY d.t, d.id;
SELECT count(*) AS encounters FROM predictive_join(60, 'traffic', 50) WHERE dt > 0;

.print
.print "k is in degrees to starboard, or in m/s. Each advice was written before the next was asked, so that none undoes another."
