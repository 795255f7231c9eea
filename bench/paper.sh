#!/usr/bin/env bash
# The paper's experiments: raw CSV and pictures into docs/developers/benchmarks/ (Debian).
#
#   bash bench/paper.sh            # a few minutes
#   bash bench/paper.sh --quick    # less than two minutes, into build/benchmarks/: docs/ stays as it is
#
# docs/developers/benchmarks.md explains what comes out.
set -euo pipefail
cd "$(dirname "$0")/.."
. sql/packages.sh
. bench/machine.sh

need_packages "${build_packages[@]}" "python3: command python3"

out=docs/developers/benchmarks
[ "${1:-}" != --quick ] || out=build/benchmarks
mkdir -p $out

cmake --preset release -DFORESEE_BENCH=ON >/dev/null
cmake --build --preset release --target bench_paper

describe_machine >$out/paper_machine.txt

build/release/bench/bench_paper "$@" $out
load_at_the_end >>$out/paper_machine.txt
python3 docs/pictures/draw.py --into $out paper_time paper_prune
echo "Written: $out/"
