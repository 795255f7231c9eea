.load build/release/foresee
.mode box

.print "Two tables: forklifts move, crates stand. What will the forklifts hit in the next 30 s?"
.print
CREATE VIRTUAL TABLE forklifts USING moving_objects(id, x, y, vx, vy, hx, hy);
CREATE VIRTUAL TABLE crates USING moving_objects(id, x, y, hx, hy, +content TEXT);
INSERT INTO forklifts VALUES
  (1,  0,  0,   2,  0,   1, 0.5),
  (2, 30, 12,   0, -1,   0.5, 1);
INSERT INTO crates VALUES
  (10, 20,  1,   0.5, 0.5, 'glass'),
  (11, 20,  5,   0.5, 0.5, 'paper'),
  (12, 30, -2,   0.5, 0.5, 'paint');

.print "SELECT ... FROM predictive_join(30, 'forklifts', 0, 'crates')"
.print
SELECT j.a AS forklift, c.content, j.t, j.t_end
  FROM predictive_join(30, 'forklifts', 0, 'crates') j JOIN crates c ON c.id = j.b
  ORDER BY j.t;

.print
.print "Forklift 1 drives along y = 0 and is 0.5 m wide to each side; the glass begins at y = 0.5. They graze: touching counts."
.print "It is 20 m away; 1 m of forklift and 0.5 m of crate leave 18.5 m at 2 m/s."
.print "Forklift 2 has 14 m - 1 m - 0.5 m = 12.5 m to the paint, at 1 m/s."
.print
.print "Only what forklift 2 meets:   WHERE a = 2"
.print
SELECT a AS forklift, b AS crate, dt FROM predictive_join(30, 'forklifts', 0, 'crates') WHERE a = 2;
