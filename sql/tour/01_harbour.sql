.load build/release/foresee
.mode box

.print "Four ships in a harbour. Positions in metres, speeds in metres per second, every hull a circle of radius 30 m."
.print
CREATE VIRTUAL TABLE ships USING moving_objects(id, x, y, vx, vy, r, +name TEXT);
INSERT INTO ships VALUES
  (1,    0,     0,  6, 0, 30, 'Anna'),     -- eastward
  (2, 1200,     0, -6, 0, 30, 'Bruno'),    -- westward, on Anna's line
  (3,  600, -1600,  0, 8, 30, 'Clara'),    -- northward, across both
  (4,  600,   300,  0, 0, 30, 'Dora');     -- at anchor, in Clara's way
SELECT * FROM ships;

.print
.print "Who will touch within 300 s?   SELECT ... FROM predictive_join(300)"
.print
SELECT s.name AS ship, o.name AS other, j.t, j.t_end, j.t_cpa, j.d_cpa
  FROM predictive_join(300) j JOIN ships s ON s.id = j.a JOIN ships o ON o.id = j.b
  ORDER BY j.t;

.print
.print "Anna and Bruno: 1200 m apart, closing at 12 m/s: the centres meet after 100 s, the hulls (30 m + 30 m) 5 s earlier."
.print "Clara and Dora: 1900 m at 8 m/s are 237.5 s, the hulls touch 60 / 8 = 7.5 s earlier."
.print "Anna and Clara are not in the list: both pass the point (600, 0), but at 100 s and at 200 s."
.print
.print "How close do they come? Counting as touching whatever comes within 450 m:   predictive_join(300, 'ships', 450)"
.print
SELECT s.name AS ship, o.name AS other, j.t, j.t_cpa, j.d_cpa
  FROM predictive_join(300, 'ships', 450) j JOIN ships s ON s.id = j.a JOIN ships o ON o.id = j.b
  ORDER BY j.t, j.a, j.b;

.print
.print "Anna passes Clara at 164 s: she is 6 * 64 = 384 m beyond the crossing, Clara 8 * 36 = 288 m before it;"
.print "384, 288, 480 is the triangle 4 : 3 : 5."
