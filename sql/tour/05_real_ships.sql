.load build/release/foresee
.mode box

.print "Real ships: 25 minutes of AIS reports from New York Harbour, errors included. (The names are made up.)"
.print
.import --csv sql/data/new_york_20220103.csv ais_reports
SELECT count(*) AS reports, count(DISTINCT mmsi) AS ships, min(BaseDateTime) AS first, max(BaseDateTime) AS last FROM ais_reports;

.print
.print "The harbour at ten past midnight:   .read sql/import_ais.sql"
.print
CREATE TABLE ais_parameters(name TEXT PRIMARY KEY, value REAL);
INSERT INTO ais_parameters VALUES ('moment', unixepoch('2022-01-03 00:10:00')), ('centre_lat', 40.65), ('centre_lon', -74.05);
.read sql/import_ais.sql
SELECT count(*) AS ships, sum(vx <> 0 OR vy <> 0) AS under_way FROM ais_ships;

.print
.print "Which pairs come within half a nautical mile (926 m) of each other in the next ten minutes?"
.print
SELECT count(*) AS pairs, sum(dt = 0) AS close_already, sum(dt > 0) AS still_to_come
  FROM predictive_join(600, 'ais_ships', 926, NULL, unixepoch('2022-01-03 00:10:00'));

.print
.print "The encounters of ships that are both under way: time to the closest point of approach (TCPA), its distance"
.print "(CPA), and where the first of the two will be then."
.print
WITH query(now) AS (VALUES (unixepoch('2022-01-03 00:10:00')))
SELECT s.name, o.name, format('%.1f min', (j.t_cpa - q.now) / 60) AS tcpa, format('%.0f m', j.d_cpa) AS cpa,
       format('%.4f N %.4f W', g.lat, -g.lon) AS place
  FROM query q JOIN predictive_join(600, 'ais_ships', 926, NULL, q.now) j
  JOIN ais_ships s ON s.id = j.a JOIN ais_ships o ON o.id = j.b,
       plane_to_geo(s.x + s.vx * (j.t_cpa - s.t), s.y + s.vy * (j.t_cpa - s.t), s.vx, s.vy, 40.65, -74.05) g
  WHERE j.t_cpa > q.now AND (s.vx <> 0 OR s.vy <> 0) AND (o.vx <> 0 OR o.vy <> 0)
  ORDER BY j.t_cpa LIMIT 10;

.print
.print "Moored ships left out: a watch of all of them, and one that leaves out pairs of two ships slower than half a knot"
.print
CREATE VIRTUAL TABLE all_pairs USING predictive_watch(ais_ships, horizon = 600, within = 926);
CREATE VIRTUAL TABLE traffic USING moving_objects(id, t, x, y, vx, vy, category, mask);
INSERT INTO traffic
  SELECT id, t, x, y, vx, vy, iif(vx = 0 AND vy = 0, 1, 2), iif(vx = 0 AND vy = 0, 2, 3) FROM ais_ships;
CREATE VIRTUAL TABLE under_way USING predictive_watch(traffic, horizon = 600, within = 926);
SELECT 'all_pairs' AS watch, count(*) AS pairs, sum(t <= now) AS close_already, sum(t > now) AS news
  FROM predictive_changes('all_pairs', 0)
UNION ALL SELECT 'under_way', count(*), sum(t <= now), sum(t > now) FROM predictive_changes('under_way', 0);
