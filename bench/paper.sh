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

need_packages "${build_packages[@]}" "gnuplot-nox: command gnuplot"

out=docs/developers/benchmarks
[ "${1:-}" != --quick ] || out=build/benchmarks
mkdir -p $out

cmake --preset release -DFORESEE_BENCH=ON >/dev/null
cmake --build --preset release --target bench_paper

{
  echo "CPU: $(sed -n 's/^model name\s*: //p' /proc/cpuinfo | head -n 1), $(nproc) cores; processor time of one thread"
  echo "Compiler: $(g++ --version | head -n 1)"
  echo "Flags: -O3 -march=x86-64-v2 -ffp-contract=off -fno-math-errno -fno-trapping-math"
  echo "Library: $(cd build/release && sed -n 's/^CMAKE_PROJECT_VERSION:STATIC=//p' CMakeCache.txt), commit $(git rev-parse --short=12 HEAD)"
  echo "Load when it began: $(cut -d' ' -f1 /proc/loadavg)"
} >$out/paper_machine.txt

build/release/bench/bench_paper "$@" $out
gnuplot -c bench/paper.gnuplot $out
echo "Written: $out/"
