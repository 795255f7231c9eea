-- README's question in degrees. Sine and cosine are the C library's: targets agree to within 1e-8, not to the bit.
CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy, r);
INSERT INTO ships SELECT column1, 0, p.x, p.y, p.vx, p.vy, 30
  FROM (VALUES (1, 54, 8, 6, 90), (2, 54, 8.0183, 6, 270), (3, 53.9856, 8.00915, 8, 0), (4, 54.0027, 8.00915, 0, 0)),
    geo_to_plane(column2, column3, column4, column5, 54, 8) p;
SELECT id, x, y, vx, vy FROM ships ORDER BY id;
SELECT a, b, t, t_end, d_cpa FROM predictive_join(300, 'ships') ORDER BY t;
SELECT s.id, g.lat, g.lon, g.speed, g.course FROM predictive_position(95, 'ships') s, plane_to_geo(s.x, s.y, s.vx, s.vy, 54, 8) g ORDER BY s.id;
SELECT x, y, z FROM geo_to_globe(54, 8, 6, 90, 100);
