#!/usr/bin/env bash
# Does every build give the same bytes? Run by hand (some minutes); Debian, x86-64.
#
#   bash tests/portability.sh
#
# Builds the core and tests/portability/rows.cpp for several targets, runs each, and compares what they print (every
# row of seeded joins and of the hard families, as bit patterns) with the first. The status is 0 only if all are equal.
#
#   x86-64 release       GCC, the flags that are shipped
#   x86-64-v2            the same program on an emulated CPU of 2008: no AVX, no fused multiply-add
#   x86-64-v3            GCC for CPUs with AVX2 and fused multiply-add
#   x86-64 -O0           GCC, no optimisation
#   x86-64 clang         Clang
#   aarch64              GCC, cross-built, emulated
#
# With -ffast-math nothing must build at all.
set -euo pipefail
cd "$(dirname "$0")/.."
. sql/packages.sh

need_packages "${build_packages[@]}" "clang: command clang++" "g++-aarch64-linux-gnu: command aarch64-linux-gnu-g++" \
  "qemu-user: command qemu-aarch64"

out=build/portability
mkdir -p $out

# build NAME COMPILER FLAGS [cmake arguments]: the core with the flags of CMakeLists.txt, then FLAGS; the program beside it.
build() {
  local name=$1 compiler=$2 flags=$3
  shift 3
  # Only headers of SQLite are looked for: the core does not use it, and another CPU's library is not needed.
  cmake -S . -B $out/"$name" -G Ninja -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_COMPILER="$compiler" \
    -DCMAKE_CXX_FLAGS="$flags" -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON -DFORESEE_BY_FOLDER=OFF -DFORESEE_TESTS=OFF \
    -DSQLite3_INCLUDE_DIR=/usr/include -DSQLite3_LIBRARY=unused "$@" >$out/"$name".log 2>&1 &&
    cmake --build $out/"$name" --target portability_rows >>$out/"$name".log 2>&1 || {
    echo "$name does not build:"
    tail -n 20 $out/"$name".log
    exit 1
  }
}

different=0
first=
# run NAME PROGRAM...: keeps what it prints and compares it with what the first one has printed.
run() {
  local name=$1
  shift
  "$@" >$out/"$name".rows
  if [ -z "$first" ]; then
    first=$name
    echo "$name: $(wc -l <$out/"$name".rows) lines, $(wc -c <$out/"$name".rows) bytes"
  elif cmp -s $out/"$first".rows $out/"$name".rows; then
    echo "$name: the same bytes"
  else
    echo "$name: DIFFERS: $(cmp $out/"$first".rows $out/"$name".rows 2>&1 || true)"
    different=1
  fi
}

optimised="-O3 -DNDEBUG"
program=tests/portability/portability_rows

build x86-64-release g++ "$optimised"
run x86-64-release $out/x86-64-release/$program
run x86-64-v2 qemu-x86_64 -cpu Nehalem $out/x86-64-release/$program

build x86-64-v3 g++ "$optimised" -DFORESEE_MARCH=x86-64-v3
if grep -qw fma /proc/cpuinfo; then run x86-64-v3 $out/x86-64-v3/$program; else echo "x86-64-v3: this CPU has no FMA"; fi

build x86-64-O0 g++ "-O0"
run x86-64-O0 $out/x86-64-O0/$program

build x86-64-clang clang++ "$optimised"
run x86-64-clang $out/x86-64-clang/$program

build aarch64 aarch64-linux-gnu-g++ "$optimised" -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=aarch64
run aarch64 qemu-aarch64 -L /usr/aarch64-linux-gnu $out/aarch64/$program

check_syntax() { g++ -std=c++20 "$@" -fsyntax-only -Iext -x c++ ext/base/float_environment.h 2>$out/syntax.log; }
if check_syntax && ! check_syntax -ffast-math && grep -q "#error" $out/syntax.log; then
  echo "-ffast-math: refused"
else
  echo "-ffast-math: BUILDS, or something else is wrong: $(head -n 3 $out/syntax.log)"
  different=1
fi

exit $different
