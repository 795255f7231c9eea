#!/usr/bin/env bash
# A join in tiles, seen from near: makes shards, joins them on a local cluster of Dask, kills a worker on the way, goes on, and compares
# with the single join. Installs what is missing (Debian) and builds.
#
#   bash sql/scale_demo.sh [OBJECTS [SHARDS]]     # 200000 and 4
#
# FORESEE_EXTENSION names a module that is built already. Ends with status 0 only if both joins have the same rows.
set -euo pipefail
cd "$(dirname "$0")/.."
. sql/packages.sh

objects=${1:-200000} shards=${2:-4}
need_packages "sqlite3: command sqlite3" "procps: command pgrep" "python3: command python3" "python3-distributed: python distributed"
extension=${FORESEE_EXTENSION:-$PWD/build/release/foresee.so}
if [ -z "${FORESEE_EXTENSION:-}" ]; then
  need_packages "${build_packages[@]}"
  echo "Building build/release/foresee.so (a few minutes the first time)"
  [ -f build/release/build.ninja ] || cmake --preset release >/dev/null
  cmake --build --preset release --target foresee >/dev/null
fi
export PYTHONPATH=$PWD/ext/hosts/python/src PYTHONDONTWRITEBYTECODE=1
folder=$(mktemp -d)
run=
cleanup() {
  [ -z "$run" ] || kill "$run" 2>/dev/null || true
  rm -rf "$folder"
}
trap cleanup EXIT

shell() { sqlite3 -batch -init /dev/null "$@"; }
TIMEFORMAT="   %R s, of processor %U s"

# load FILE FIRST END: ships FIRST to END - 1. Places and speeds follow from the id alone; each meets about one other.
load() {
  shell "$1" ".load ${extension%.so}" "PRAGMA synchronous = OFF" \
    "CREATE VIRTUAL TABLE ships USING moving_objects(id, t, x, y, vx, vy, r)" \
    "WITH RECURSIVE n(i) AS (SELECT $2 UNION ALL SELECT i + 1 FROM n WHERE i + 1 < $3)
     INSERT INTO ships SELECT i, i % 60, (i * 7919 % 1000003) / 1000003.0 * sqrt($objects) * 500, (i * 104729 % 999983) / 999983.0 * sqrt($objects) * 500,
       i * 31 % 17 - 8, i * 37 % 17 - 8, 20 FROM n" >/dev/null
}

echo "== Loading $objects ships into $shards shards, and into one file to compare with"
load_shards() {
  for ((i = 0; i < shards; i++)); do
    load "$folder/ships-$i.db" $((i * objects / shards)) $(((i + 1) * objects / shards))
  done
}
time load_shards
time load "$folder/single.db" 0 "$objects"

echo "== The single join"
time shell "$folder/single.db" ".load ${extension%.so}" "CREATE TABLE pairs AS SELECT a, b, t, d_cpa FROM predictive_join(120, 'ships', 50) ORDER BY a, b"
echo "   $(shell "$folder/single.db" 'SELECT count(*) FROM pairs') rows"

join=(/usr/bin/python3 -m foresee_dask join --extension "$extension" --table ships --horizon 120 --within 50 --columns t,d_cpa --tiles 32
  --workers 2 --out "$folder/pairs" "$folder"/ships-*.db)
files() { find "$folder/pairs" -name 'pairs-*.db' 2>/dev/null | wc -l; }

echo "== In tiles, by two workers; one of them is killed when five tiles are done"
in_tiles() {
  "${join[@]}" &
  run=$!
  killed=
  while kill -0 "$run" 2>/dev/null; do
    if [ -z "$killed" ] && [ "$(files)" -ge 5 ]; then
      killed=$(pgrep -P "$run" -f spawn_main | head -n 1)
      if [ -n "$killed" ] && kill -KILL "$killed" 2>/dev/null; then echo "   killed worker $killed when $(files) tiles were done"; fi
    fi
    sleep 0.02
  done
  wait "$run"
  run=
  [ -n "$killed" ] || echo "   done before a worker could be killed: take more OBJECTS"
}
time in_tiles

echo "== The same command once more"
time "${join[@]}"

echo "== Merged, and compared"
time /usr/bin/python3 -m foresee_dask merge "$folder/pairs" "$folder/merged.db"
differ=$(shell "$folder/merged.db" "ATTACH '$folder/single.db' AS single" \
  "SELECT (SELECT count(*) FROM (SELECT * FROM pairs EXCEPT SELECT * FROM single.pairs)) + (SELECT count(*) FROM (SELECT * FROM single.pairs EXCEPT SELECT * FROM pairs))
     + abs((SELECT count(*) FROM pairs) - (SELECT count(*) FROM single.pairs))")
echo "   rows that differ from the single join: $differ"
[ "$differ" = 0 ]
