#!/usr/bin/env bash
# Hulls of real ships in a database, by the recipe of docs/how-to/hulls.md, for bench_sql_outlines --real:
#
#   bash bench/real_hulls.sh ../shared/data/ships_us_20220103.csv.gz build/benchmarks/hulls.db
#
# Needs build/release/foresee.so, and SQLite's shell with its mathematical functions.
set -euo pipefail
reports=$(realpath "$1")
mkdir -p "$(dirname "$2")"
hulls=$(realpath "$2")
cd "$(dirname "$0")/.."
rm -f "$hulls"
{
  echo ".load ${FORESEE_EXTENSION:-build/release/foresee}"
  echo ".import --csv \"|gzip -dc $reports\" ais_reports"
  echo "CREATE TABLE ais_parameters(name TEXT PRIMARY KEY, value REAL);"
  echo "INSERT INTO ais_parameters VALUES ('moment', 1641168600), ('centre_lat', 30), ('centre_lon', -90.5);"
  echo ".read sql/import_ais.sql"
  awk '/^```/ { if (text ~ /TABLE ais_hulls/) printf "%s", text; text = ""; next } { text = text $0 "\n" }' docs/how-to/hulls.md
  echo "SELECT count(*) || ' ships, ' || count(shape) || ' hulls' FROM ais_hulls;"
} | sqlite3 -bail "$hulls"
