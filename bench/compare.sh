#!/usr/bin/env bash
# foresee beside other methods that join moving objects: GPCD, TPR-trees, R-trees, DuckDB, brute force, time stepping. On the
# same scenes of 10^3 to 10^6 objects, and on real ships: build, join, report and memory apart (Debian).
#
#   bash bench/compare.sh            # ten minutes; figures into docs/developers/benchmarks/, README.md and the pages
#   bash bench/compare.sh --quick    # less than two minutes once built, to 10^5, into build/benchmarks/: docs/ stays as it is
#
# A method that takes more than 60 s for one join (--quick: 10) stops at that size. bench/compare.cpp says what is measured;
# docs/developers/benchmarks.md explains what comes out. DuckDB comes by npm; without a registry it is left out.
set -euo pipefail
cd "$(dirname "$0")/.."
. sql/packages.sh
. bench/machine.sh

need_packages "${build_packages[@]}" "libspatialindex-dev: header spatialindex/SpatialIndex.h" "python3: command python3"

out=docs/developers/benchmarks seconds=60
[ "${1:-}" != --quick ] || out=build/benchmarks seconds=10
scenes=build/benchmarks/scenes
rm -rf $scenes
mkdir -p $out $scenes build/duckdb

cmake --preset release -DFORESEE_BENCH=ON >/dev/null
cmake --build --preset release --target bench_compare

duckdb=
if command -v npm >/dev/null && cp bench/duckdb/package.json build/duckdb/ &&
  npm install --prefix build/duckdb --no-audit --no-fund --loglevel=error >/dev/null 2>&1; then
  duckdb=$(sed -n 's/.*"@duckdb\/node-api": "\(.*\)".*/\1/p' bench/duckdb/package.json)
else
  echo "SKIPPED: DuckDB, because npm cannot bring @duckdb/node-api"
fi

describe_machine >$out/compare_machine.txt
echo "DuckDB: ${duckdb:-left out}" >>$out/compare_machine.txt
build/release/bench/bench_compare "$@" --csv $out/compare.csv --export $scenes --ships sql/data/new_york_20220103.csv
[ -z "$duckdb" ] || node bench/duckdb/compare.mjs $scenes $out/compare.csv build/duckdb $seconds
load_at_the_end >>$out/compare_machine.txt
python3 docs/pictures/draw.py --into $out compare

python3 bench/compare_pages.py "$@"
