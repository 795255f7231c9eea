.load build/release/foresee
.mode box

.print "A harbour of hulls. A shape is well-known text around the ship's position; a heading turns it, clockwise from north."
.print
CREATE VIRTUAL TABLE ships USING moving_objects(id, x, y, vx, vy, shape, heading, +name TEXT);
WITH hull(wkt) AS (VALUES ('POLYGON((-8 -90, 8 -90, 8 60, 0 90, -8 60, -8 -90))'))    -- 180 m long, the bow to the north
INSERT INTO ships
            SELECT 1,    0,   0,  4,   4, wkt,  45, 'Anna'  FROM hull       -- north-eastward
  UNION ALL SELECT 2,  684, 600, -4,  -4, wkt, 225, 'Bruno' FROM hull       -- south-westward, on a lane beside hers
  UNION ALL SELECT 3, 1050,   0,  0,   2, wkt,   0, 'Clara' FROM hull       -- northward, into the quay's basin
  UNION ALL SELECT 4, 1220, 110,  0, 0.5, wkt,   0, 'Dora'  FROM hull;      -- in the lock, slowly ahead
SELECT id, name, x, y, vx, vy, heading FROM ships;

.print
.print "What stands: a quay around a basin that is open to the south, and a lock whose chamber is a hole."
CREATE VIRTUAL TABLE works USING moving_objects(id, x, y, shape, +name TEXT);
INSERT INTO works VALUES
  (1, 1000, 300, 'POLYGON((0 0, 20 0, 20 180, 80 180, 80 0, 100 0, 100 200, 0 200, 0 0))', 'quay'),
  (2, 1200,   0, 'POLYGON((0 0, 40 0, 40 260, 0 260, 0 0), (10 10, 30 10, 30 250, 10 250, 10 10))', 'lock');
.print
.print "What will the ships hit within 300 s?   FROM predictive_join(300, 'ships', 0, 'works')"
.print
SELECT s.name AS ship, w.name AS work, j.t
  FROM predictive_join(300, 'ships', 0, 'works') j JOIN ships s ON s.id = j.a JOIN works w ON w.id = j.b
  ORDER BY j.t;

.print
.print "Dora's bow is at y = 200; the chamber ends at 250, 100 s away at 0.5 m/s. She lies within the lock's box all the time,"
.print "and within its outer ring, and touches neither: what lies in a hole does not touch."
.print "Clara's bow is at y = 90. She enters the quay's box at 300, after 105 s, passes the basin's mouth with 22 m on each"
.print "side, and touches its back wall at 480: 390 m at 2 m/s."
.print
.print "Which ships touch each other?   FROM predictive_join(300, 'ships')"
.print
SELECT count(*) AS pairs FROM predictive_join(300, 'ships');

.print
.print "None: Anna and Bruno pass. Their boxes do meet, as the last two stages of predictive_explain(300, 'ships') tell:"
.print
SELECT stage, n_before, n_after FROM predictive_explain(300, 'ships') WHERE stage IN ('exact time', 'refinement');

.print
.print "How much room is between the hulls? Counting as touching what comes within 40, and within 45 m:"
.print
SELECT d.within, s.name AS ship, o.name AS other, j.t, j.t_end, j.d_cpa
  FROM (SELECT 40 AS within UNION ALL SELECT 45) d JOIN predictive_join j ON j.h = 300 AND j.tbl = 'ships' AND j.within = d.within
  JOIN ships s ON s.id = j.a JOIN ships o ON o.id = j.b;

.print
.print "Their lanes are 84 / sqrt(2) = 59.4 m apart, which is d_cpa, and each hull is 8 m wide to that side: 43.4 m are left."
.print
.print "Who is in the fairway, a zone with a bend, and until when?   FROM predictive_window WHERE ... AND zone = 'POLYGON((...))'"
.print
SELECT s.name, w.t, w.t_end
  FROM predictive_window w JOIN ships s ON s.id = w.id
  WHERE w.h = 300 AND w.tbl = 'ships'
    AND w.zone = 'POLYGON((1030 -300, 1300 -300, 1300 -200, 1070 -200, 1070 200, 1030 200, 1030 -300))';

.print
.print "Clara is in it from the start; her stern, at y = -90, leaves it at 200, after 290 m. Dora lies in the corner that the bend"
.print "leaves out: a window from 1030 to 1300 and from -300 to 200 would have her too."
