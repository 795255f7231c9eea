.load build/release/foresee
.mode box

.print "Robots in a warehouse: each has a plan, with the place and time of every stop and turn."
.print
CREATE VIRTUAL TABLE robots USING moving_objects(id, x, y, plan, r, +task TEXT);
INSERT INTO robots(id, plan, r, task) VALUES
  (1, 'LINESTRING M(0 0 0, 10 0 5, 10 0 9, 10 20 29)', 0.4, 'fetch'),
  (2, 'LINESTRING M(10 20 0, 10 3 17, 20 3 27)',       0.4, 'bring'),
  (3, 'LINESTRING M(30 30 0, 0 30 15, 30 30 30)',      0.4, 'patrol');
INSERT INTO robots(id, x, y, r, task) VALUES (4, 15, 4.2, 0.4, 'charge');
SELECT id, task, x, y, plan FROM robots;

.print
.print "Robot 1 drives for 5 s, waits for 4 s, and turns left. Robot 4 stands: a plain row."
.print "Who comes within 0.5 m of whom in the next 60 s, from 0 on?"
.print
SELECT a, b, round(t, 2) AS t, round(t_end, 2) AS t_end
  FROM predictive_join(60, 'robots', 0.5) WHERE now = 0 ORDER BY t;

.print
.print "Robot 2 passes robot 4 with less than 0.5 m to spare. Robot 1 meets it head on: its new plan waits longer."
.print
UPDATE robots SET plan = 'LINESTRING M(0 0 0, 10 0 5, 10 0 21, 10 20 41)' WHERE id = 1;
SELECT a, b, round(t, 2) AS t, round(t_end, 2) AS t_end
  FROM predictive_join(60, 'robots', 0.5) WHERE now = 0 ORDER BY t;

.print
.print "Where is everybody at t = 14?"
.print
SELECT id, x, y, vx, vy FROM predictive_position(14, 'robots') ORDER BY id;
