.load build/release/foresee
.mode box

.print "A bay with zones to watch, and depots that look for the nearest boat."
.print
CREATE VIRTUAL TABLE boats USING moving_objects(id, x, y, vx, vy, r, +name TEXT);
INSERT INTO boats VALUES
  (1,   0,    0,  10,  0, 10, 'Erik'),      -- eastward
  (2, 900,  500,   0, -4, 10, 'Freya'),     -- southward
  (3, 300, -200,   0,  0, 10, 'Gerda');     -- at anchor
CREATE TABLE zones(name, x0, x1, y0, y1);
INSERT INTO zones VALUES ('channel', 400, 1000, -100, 100), ('south of the pier', NULL, NULL, NULL, -190);
CREATE TABLE depots(name, x, y);
INSERT INTO depots VALUES ('pier', 300, 40), ('yard', 900, 30);

.print "What enters a zone within 120 s?   FROM zones z, predictive_window(120, 'boats', z.x0, z.x1, z.y0, z.y1)"
.print
SELECT z.name AS zone, b.name AS boat, w.t, w.t_end
  FROM zones z, predictive_window(120, 'boats', z.x0, z.x1, z.y0, z.y1) w JOIN boats b ON b.id = w.id
  ORDER BY w.t, z.name, b.id;

.print
.print "Erik's bow is 390 m away at 10 m/s; his stern leaves after 1010 m. Freya's hull is 390 m away, at 4 m/s."
.print "Bounds that are left out (NULL) are none: south of y = -190 lies everything down there."
.print
.print "Which two boats come nearest to each depot within 120 s?   FROM depots d, predictive_nearest(120, 'boats', 2, d.x, d.y)"
.print
SELECT d.name AS depot, n.rank, b.name AS boat, n.distance, n.t
  FROM depots d, predictive_nearest(120, 'boats', 2, d.x, d.y) n JOIN boats b ON b.id = n.id
  ORDER BY d.name, n.rank;

.print
.print "Distances are those of the centres: Erik passes the pier at 30 s, 40 m off; Gerda stays 240 m away."
