#!/usr/bin/env bash
# The report on accuracy, error against run time: raw CSV and pictures into docs/explanation/accuracy/ (Debian).
#
#   bash bench/accuracy.sh            # a few minutes
#   bash bench/accuracy.sh --quick    # less than half a minute, into build/accuracy/: docs/ stays as it is
#
# docs/explanation/accuracy.md explains what comes out.
set -euo pipefail
cd "$(dirname "$0")/.."
. sql/packages.sh

load=$(cut -d' ' -f1 /proc/loadavg)      # before the build, which raises it
need_packages "${build_packages[@]}" "gnuplot-nox: command gnuplot"

out=docs/explanation/accuracy
[ "${1:-}" != --quick ] || out=build/accuracy
mkdir -p $out build/accuracy

# Boost's quartic_roots is younger than Debian's default Boost: unpack the newer headers, install nothing.
boost=
if ! echo '#include <boost/math/tools/quartic_roots.hpp>' | g++ -E -x c++ - >/dev/null 2>&1; then
  boost=$PWD/build/accuracy/boost
  if [ ! -d "$boost" ]; then
    (cd build/accuracy && apt-get download -qq libboost1.81-dev 2>/dev/null && dpkg-deb -x libboost1.81-dev_*.deb boost) ||
      echo "SKIPPED: the line of Boost's quartic_roots, because apt could not fetch libboost1.81-dev"
  fi
  [ -d "$boost" ] && boost=$boost/usr/include || boost=
fi

cmake --preset release -DFORESEE_BENCH=ON -DFORESEE_NEWER_BOOST="$boost" >/dev/null
cmake --build --preset release --target bench_accuracy bench_extreme_scenes bench_exponent_fuzz
bench=build/release/bench

{
  echo "CPU: $(sed -n 's/^model name\s*: //p' /proc/cpuinfo | head -n 1), $(nproc) cores; processor time of one thread"
  echo "Compiler: $(g++ --version | head -n 1)"
  echo "Flags: -O3 -march=x86-64-v2 -ffp-contract=off -fno-math-errno -fno-trapping-math"
  echo "Library: $(cd build/release && sed -n 's/^CMAKE_PROJECT_VERSION:STATIC=//p' CMakeCache.txt), commit $(git rev-parse --short=12 HEAD)"
  echo "Seed: 20260101 for every family"
  echo "Load average when it began: $load$(awk -v load="$load" 'BEGIN { if (load >= 0.3) print " (a busy machine: times are too long)" }')"
} >$out/machine.txt

$bench/bench_accuracy $out "$@"
$bench/bench_extreme_scenes >$out/extreme_scenes.csv
$bench/bench_exponent_fuzz >$out/exponent_fuzz.csv
gnuplot -c bench/accuracy/pictures.gnuplot $out
echo "Written: $out/"
