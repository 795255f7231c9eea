.load build/release/foresee
.mode box

.print "Drones in space: boxes of 1 m, accelerating. Constant acceleration makes x + v s + a s^2 / 2 of the path."
.print
CREATE VIRTUAL TABLE drones USING moving_objects(id, x, y, z, vx, vy, vz, ax, ay, az, hx, hy, hz, +what TEXT);
INSERT INTO drones VALUES
  (1,   0,  0, 50,   0, 0,  0,   2, 0, 0,   0.5, 0.5, 0.5, 'starts with 2 m/s^2'),
  (2, 101,  0, 50,   0, 0,  0,   0, 0, 0,   0.5, 0.5, 0.5, 'hovers in its way'),
  (3,   0, 80, 50,  20, 0,  0,  -2, 0, 0,   0.5, 0.5, 0.5, 'brakes with 2 m/s^2'),
  (4, 102, 80, 50,   0, 0,  0,   0, 0, 0,   0.5, 0.5, 0.5, 'hovers beyond the stop'),
  (5,   0,  0, 98,   0, 0, -4,   2, 0, 0,   0.5, 0.5, 0.5, 'as 1, and sinks by 4 m/s');
SELECT id, what FROM drones;

.print
.print "SELECT a, b, t, t_end FROM predictive_join(30)"
.print
SELECT a, b, t, t_end FROM predictive_join(30) ORDER BY t, a, b;

.print
.print "1 and 2: the gap is 101 m less two halves, 100 m; a s^2 / 2 = s^2 covers it in 10 s."
.print "1 and 5 fly alike but 48 m apart in height, closing at 4 m/s: their boxes (1 m high) touch after 47 / 4 = 11.75 s."
.print "3 and 4 never touch: 3 comes to rest 10 s later, after 100 m. How near does it get?"
.print
SELECT a, b, t_cpa, d_cpa FROM predictive_join(30, 'drones', 1) WHERE a = 3;
.print
.print "2 m from centre to centre, 1 m from box to box, at the turning point."
