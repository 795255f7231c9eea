#!/usr/bin/env bash
# The join beside its peers, with and without SQL, and how it grows: raw CSV and a picture into docs/developers/benchmarks/ (Debian).
#
#   bash bench/peers.sh            # half an hour, most of it the peers'
#   bash bench/peers.sh --quick    # less than two minutes, into build/benchmarks/: docs/ stays as it is
#
# CGAL takes part where it is installed (libcgal-dev). docs/developers/benchmarks.md explains what comes out.
set -euo pipefail
cd "$(dirname "$0")/.."
. sql/packages.sh
. bench/machine.sh

need_packages "${build_packages[@]}" "python3: command python3"

out=docs/developers/benchmarks
growth=(S-1000 S-10000 S-100000 S-1000000 L-1 L-3 L-10 L-30 L-100 L-300 G-0.01 G-0.03 G-0.1 G-0.3 G-1)
if [ "${1:-}" = --quick ]; then
  out=build/benchmarks
  growth=(S-1000 S-10000 S-100000 L-1 L-3 L-10 G-0.01 G-0.1 G-1)
fi
mkdir -p $out

cmake --preset release -DFORESEE_BENCH=ON >/dev/null
cmake --build --preset release --target bench_core_join bench_sql_join

describe_machine >$out/peers_machine.txt

build/release/bench/bench_core_join "$@" --csv $out/peers_core.csv
build/release/bench/bench_core_join --quick --csv $out/growth.csv "${growth[@]}"
build/release/bench/bench_sql_join "$@" --csv $out/peers_sql.csv
load_at_the_end >>$out/peers_machine.txt
python3 docs/pictures/draw.py --into $out growth
echo "Written: $out/"
