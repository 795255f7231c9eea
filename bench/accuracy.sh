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
. bench/machine.sh

need_packages "${build_packages[@]}" "python3: command python3"

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

{ describe_machine && echo "Seed: 20260101 for every family"; } >$out/machine.txt

$bench/bench_accuracy $out "$@"
$bench/bench_extreme_scenes >$out/extreme_scenes.csv
$bench/bench_exponent_fuzz >$out/exponent_fuzz.csv
load_at_the_end >>$out/machine.txt
python3 docs/pictures/draw.py --into $out wrong stages
echo "Written: $out/"
