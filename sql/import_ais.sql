-- From AIS reports (latitude, longitude, speed, course) to moving objects on a plane, in plain SQL.
--
--   .load build/release/foresee
--   .import --csv reports.csv ais_reports      -- columns mmsi, t, lat, lon, sog_kn, cog_deg; others may be there too
--   .read sql/import_ais.sql
--   SELECT * FROM predictive_join(600, 'ais_ships', 926);
--
-- t: Unix seconds; lat, lon: degrees, north and east positive; sog_kn: speed over ground in knots; cog_deg: course over
-- ground, clockwise from north. What AIS sends for "not available" (lat 91, lon 181, sog 102.3, cog 360, or nothing) is
-- left out. The result is the table ais_ships: id = MMSI, t as reported, metres and metres per second. Reading the file
-- again makes it anew.
--
-- The plane is that of geo_to_plane (docs/how-to/latitude_and_longitude.md): every ship has its true distance and bearing from the centre, on the
-- ellipsoid; at 150 km from there other distances are wrong by up to 0.01 %. A ship is taken to follow its geodesic, so its
-- velocity is the one that it has on the plane at the moment of the report.

-- The parameters. What the table holds already stays: to choose another moment or place, change it and read the file
-- again, as in   UPDATE ais_parameters SET value = 1641168600 WHERE name = 'moment';
CREATE TABLE IF NOT EXISTS ais_parameters(name TEXT PRIMARY KEY, value REAL);
INSERT OR IGNORE INTO ais_parameters
  SELECT 'moment', max(CAST(t AS REAL)) FROM ais_reports          -- the newest report of each ship up to this moment,
  UNION ALL SELECT 'heard_within_s', 180                          -- if it is no older than this, in seconds
  UNION ALL SELECT 'centre_lat', avg(CAST(lat AS REAL)) FROM ais_reports WHERE abs(CAST(lat AS REAL)) <= 90
  UNION ALL SELECT 'centre_lon', avg(CAST(lon AS REAL)) FROM ais_reports WHERE abs(CAST(lon AS REAL)) <= 180
  UNION ALL SELECT 'reach_m', 150000                              -- ships farther from the centre are left out
  UNION ALL SELECT 'rest_below_kn', 0.5;                          -- slower ships lie still: their course is noise

CREATE VIRTUAL TABLE IF NOT EXISTS ais_ships USING moving_objects(id, t, x, y, vx, vy);
DELETE FROM ais_ships;

WITH
parameter AS (
  SELECT max(value) FILTER (WHERE name = 'moment') AS moment,
         max(value) FILTER (WHERE name = 'heard_within_s') AS heard_within_s,
         max(value) FILTER (WHERE name = 'centre_lat') AS lat0,
         max(value) FILTER (WHERE name = 'centre_lon') AS lon0,
         max(value) FILTER (WHERE name = 'reach_m') AS reach_m,
         max(value) FILTER (WHERE name = 'rest_below_kn') AS rest_below_kn
  FROM ais_parameters),

-- .import delivers text; numbers from here on. A report without a position or a speed says nothing about the future.
report AS (
  SELECT rowid AS place, CAST(mmsi AS INTEGER) AS mmsi, CAST(t AS REAL) AS t, CAST(lat AS REAL) AS lat, CAST(lon AS REAL) AS lon,
         CAST(sog_kn AS REAL) AS sog, iif(cog_deg = '', NULL, CAST(cog_deg AS REAL)) AS cog
  FROM ais_reports
  WHERE t <> '' AND lat <> '' AND lon <> '' AND sog_kn <> ''),
usable AS (
  SELECT mmsi, t, lat, lon, nullif(cog, 360) AS course, iif(sog < rest_below_kn, 0, sog * 1852 / 3600) AS speed, place
  FROM report, parameter
  WHERE abs(lat) <= 90 AND abs(lon) <= 180 AND sog BETWEEN 0 AND 102.15
    AND (sog < rest_below_kn OR (cog >= 0 AND cog < 360))
    AND t BETWEEN moment - heard_within_s AND moment),
newest AS (
  SELECT *, row_number() OVER (PARTITION BY mmsi ORDER BY t DESC, place DESC) AS age
  FROM usable)

INSERT INTO ais_ships(id, t, x, y, vx, vy)
  SELECT n.mmsi, n.t, p.x, p.y, p.vx, p.vy
  FROM newest n, parameter c, geo_to_plane(n.lat, n.lon, n.speed, n.course, c.lat0, c.lon0) p
  WHERE n.age = 1 AND p.x * p.x + p.y * p.y <= c.reach_m * c.reach_m;
