-- From AIS reports (latitude, longitude, speed, course) to moving objects on a plane, in plain SQL.
--
--   .load build/release/foresee
--   .import --csv AIS_2022_01_03.csv ais_reports      -- a file of NOAA, of the Danish Maritime Authority, or your own
--   .read sql/import_ais.sql
--   SELECT * FROM predictive_join(600, 'ais_ships', 926);
--
-- Columns, by name, in any case and order; others may be there too. The script checks first and reports what is missing:
--   ship       mmsi
--   time       t (Unix seconds), BaseDateTime or base_date_time (NOAA), # Timestamp (DMA: day/month/year); UTC
--   latitude   lat, Latitude          longitude   lon, Longitude       degrees, north and east positive
--   speed      sog_kn, SOG            knots over ground
--   course     cog_deg, COG           degrees over ground, clockwise from north
--   name       name, VesselName, vessel_name: may be missing
-- What AIS sends for "not available" (lat 91, lon 181, sog 102.3, cog 360, or nothing) is left out. Of DMA's file only
-- ships count (Type of mobile is Class A or Class B).
--
-- The result is the table ais_ships: id = MMSI, t as reported, metres and metres per second, the newest name. Reading the
-- file again rebuilds it. The plane is that of geo_to_plane (docs/how-to/latitude_and_longitude.md): every ship has its
-- true distance and bearing from the centre, on the ellipsoid; at 150 km from there other distances are wrong by up to
-- 0.01 %. A ship follows its geodesic, so its velocity is the one that it has on the plane at the time of the report.

DROP TABLE IF EXISTS temp.ais_missing;
DROP VIEW IF EXISTS temp.ais_read;
CREATE TEMP TABLE ais_missing AS
  WITH known(place, quantity, name) AS (VALUES
    (1, 'ship', 'mmsi'), (2, 'time', 't'), (2, 'time', 'BaseDateTime'), (2, 'time', 'base_date_time'), (2, 'time', '# Timestamp'),
    (3, 'latitude', 'lat'), (3, 'latitude', 'Latitude'), (4, 'longitude', 'lon'), (4, 'longitude', 'Longitude'),
    (5, 'speed', 'sog_kn'), (5, 'speed', 'SOG'), (6, 'course', 'cog_deg'), (6, 'course', 'COG')),
  present(name) AS (SELECT lower(name) FROM pragma_table_info('ais_reports'))
  SELECT place, quantity, group_concat(name, ' or ') AS names FROM known
    GROUP BY place, quantity HAVING max(lower(name) IN present) = 0;
CREATE TEMP TRIGGER ais_refused BEFORE UPDATE ON ais_missing BEGIN
  SELECT RAISE(ABORT, 'ais_reports: there is no such table; .import --csv FILE ais_reports first')
    WHERE NOT EXISTS (SELECT 1 FROM pragma_table_info('ais_reports'));
  SELECT RAISE(ABORT, 'ais_reports: no column for the ship; .import a file with a column mmsi') WHERE NEW.place = 1;
  SELECT RAISE(ABORT, 'ais_reports: no column for the time; .import a file with t, BaseDateTime or # Timestamp') WHERE NEW.place = 2;
  SELECT RAISE(ABORT, 'ais_reports: no column for the latitude; .import a file with lat or Latitude') WHERE NEW.place = 3;
  SELECT RAISE(ABORT, 'ais_reports: no column for the longitude; .import a file with lon or Longitude') WHERE NEW.place = 4;
  SELECT RAISE(ABORT, 'ais_reports: no column for the speed; .import a file with sog_kn or SOG') WHERE NEW.place = 5;
  SELECT RAISE(ABORT, 'ais_reports: no column for the course; .import a file with cog_deg or COG') WHERE NEW.place = 6;
END;
SELECT 'ais_reports has no column for the ' || quantity || ': ' || names AS missing FROM ais_missing
  WHERE EXISTS (SELECT 1 FROM pragma_table_info('ais_reports')) ORDER BY place;
UPDATE ais_missing SET place = place;                             -- an error where a column is missing

-- A column that the file does not have is found in `absent`, one level further out, where it is NULL.
CREATE TEMP VIEW ais_read AS
  SELECT k.place,
         (SELECT mmsi FROM ais_reports r WHERE r.rowid = k.place) AS mmsi,
         (SELECT coalesce(t, BaseDateTime, base_date_time, "# Timestamp") FROM ais_reports r WHERE r.rowid = k.place) AS time,
         (SELECT coalesce(lat, Latitude) FROM ais_reports r WHERE r.rowid = k.place) AS lat,
         (SELECT coalesce(lon, Longitude) FROM ais_reports r WHERE r.rowid = k.place) AS lon,
         (SELECT coalesce(sog_kn, SOG) FROM ais_reports r WHERE r.rowid = k.place) AS sog,
         (SELECT coalesce(cog_deg, COG) FROM ais_reports r WHERE r.rowid = k.place) AS cog,
         (SELECT nullif(trim(coalesce(name, VesselName, vessel_name)), '') FROM ais_reports r WHERE r.rowid = k.place) AS name,
         (SELECT "Type of mobile" FROM ais_reports r WHERE r.rowid = k.place) AS kind
  FROM (SELECT NULL AS mmsi, NULL AS t, NULL AS BaseDateTime, NULL AS base_date_time, NULL AS "# Timestamp", NULL AS lat,
               NULL AS Latitude, NULL AS lon, NULL AS Longitude, NULL AS sog_kn, NULL AS SOG, NULL AS cog_deg, NULL AS COG,
               NULL AS name, NULL AS VesselName, NULL AS vessel_name, NULL AS "Type of mobile") absent,
       (SELECT rowid AS place FROM ais_reports) k;

-- .import delivers text; numbers from here on. A report without a position or a speed says nothing about the future.
DROP TABLE IF EXISTS temp.ais_numbers;
CREATE TEMP TABLE ais_numbers(place, mmsi INTEGER, t REAL, lat REAL, lon REAL, sog REAL, cog REAL, name);
INSERT INTO ais_numbers                                           -- the last statement that fails without ais_reports
  SELECT place, CAST(mmsi AS INTEGER) AS mmsi,
         CASE WHEN time LIKE '__/__/____ %'
              THEN CAST(strftime('%s', substr(time, 7, 4) || '-' || substr(time, 4, 2) || '-' || substr(time, 1, 2) || substr(time, 11)) AS REAL)
              WHEN time LIKE '%:%' THEN CAST(strftime('%s', time) AS REAL)
              ELSE CAST(time AS REAL) END AS t,
         CAST(lat AS REAL) AS lat, CAST(lon AS REAL) AS lon, CAST(sog AS REAL) AS sog,
         iif(cog = '', NULL, CAST(cog AS REAL)) AS cog, name
  FROM ais_read
  WHERE time <> '' AND lat <> '' AND lon <> '' AND sog <> '' AND (kind IS NULL OR kind LIKE 'Class%')
    AND NOT EXISTS (SELECT 1 FROM ais_missing);

-- The parameters. What the table holds already stays: to choose another time or place, change it and read the file
-- again, as in   UPDATE ais_parameters SET value = 1641168600 WHERE name = 'moment';
CREATE TABLE IF NOT EXISTS ais_parameters(name TEXT PRIMARY KEY, value REAL);
INSERT OR IGNORE INTO ais_parameters SELECT * FROM (
  SELECT 'moment', max(t) FROM ais_numbers                        -- the newest report of each ship up to this time,
  UNION ALL SELECT 'heard_within_s', 180                          -- if it is no older than this, in seconds
  UNION ALL SELECT 'centre_lat', avg(lat) FROM ais_numbers WHERE abs(lat) <= 90
  UNION ALL SELECT 'centre_lon', avg(lon) FROM ais_numbers WHERE abs(lon) <= 180
  UNION ALL SELECT 'reach_m', 150000                              -- ships farther from the centre are left out
  UNION ALL SELECT 'rest_below_kn', 0.5)                          -- slower ships lie still: their course is noise
  WHERE NOT EXISTS (SELECT 1 FROM ais_missing);

CREATE VIRTUAL TABLE IF NOT EXISTS ais_ships USING moving_objects(id, t, x, y, vx, vy, +name TEXT);
DELETE FROM ais_ships WHERE NOT EXISTS (SELECT 1 FROM ais_missing);

WITH
parameter AS (
  SELECT max(value) FILTER (WHERE name = 'moment') AS moment,
         max(value) FILTER (WHERE name = 'heard_within_s') AS heard_within_s,
         max(value) FILTER (WHERE name = 'centre_lat') AS lat0,
         max(value) FILTER (WHERE name = 'centre_lon') AS lon0,
         max(value) FILTER (WHERE name = 'reach_m') AS reach_m,
         max(value) FILTER (WHERE name = 'rest_below_kn') AS rest_below_kn
  FROM ais_parameters),
usable AS (
  SELECT mmsi, t, lat, lon, nullif(cog, 360) AS course, iif(sog < rest_below_kn, 0, sog * 1852 / 3600) AS speed, place
  FROM ais_numbers, parameter
  WHERE abs(lat) <= 90 AND abs(lon) <= 180 AND sog BETWEEN 0 AND 102.15
    AND (sog < rest_below_kn OR (cog >= 0 AND cog < 360))
    AND t BETWEEN moment - heard_within_s AND moment),
newest AS (
  SELECT *, row_number() OVER (PARTITION BY mmsi ORDER BY t DESC, place DESC) AS age
  FROM usable),
named AS (
  SELECT mmsi, name, row_number() OVER (PARTITION BY mmsi ORDER BY t DESC, place DESC) AS age
  FROM ais_numbers WHERE name IS NOT NULL)

INSERT INTO ais_ships(id, t, x, y, vx, vy, name)
  SELECT n.mmsi, n.t, p.x, p.y, p.vx, p.vy, m.name
  FROM newest n CROSS JOIN parameter c, geo_to_plane(n.lat, n.lon, n.speed, n.course, c.lat0, c.lon0) p
  LEFT JOIN named m ON m.mmsi = n.mmsi AND m.age = 1
  WHERE n.age = 1 AND p.x * p.x + p.y * p.y <= c.reach_m * c.reach_m;

-- A file of a whole continent has its middle where no ship is.
SELECT printf('no ship within %.0f km of %.2f %.2f in the %.0f s before %s', max(value) FILTER (WHERE name = 'reach_m') / 1000,
              max(value) FILTER (WHERE name = 'centre_lat'), max(value) FILTER (WHERE name = 'centre_lon'),
              max(value) FILTER (WHERE name = 'heard_within_s'), datetime(max(value) FILTER (WHERE name = 'moment'), 'unixepoch')) AS empty,
       'UPDATE ais_parameters SET value = … WHERE name = ''centre_lat'', and so for centre_lon; then .read this file again' AS write
  FROM ais_parameters WHERE NOT EXISTS (SELECT 1 FROM ais_ships UNION ALL SELECT 1 FROM ais_missing) GROUP BY NULL;

DROP TABLE temp.ais_missing;
DROP TABLE temp.ais_numbers;
DROP VIEW temp.ais_read;
