#!/usr/bin/env bash
# Builds the modules of targets: build/targets/TARGET/ gets the module, without symbols, and THIRD_PARTY.
#
#   bash ext/hosts/release/build_target.sh linux-arm64-gnu win32-x64
#
# linux-x64-gnu is the release build (FORESEE_BUILD or build/release), linked against an older C library; the others are
# built from the sources in build/TARGET: some minutes of one processor each. FORESEE_JOBS is the number of compilers.
set -euo pipefail
cd "$(dirname "$0")/../../.."
. sql/packages.sh
release=ext/hosts/release
jobs=${FORESEE_JOBS:-$(nproc)}

# column TARGET NAME: the value in ext/hosts/release/targets.
column() {
  awk -v target="$1" -v name="$2" 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == name) n = i } $1 == target { print $n }' $release/targets
}

# build_TOOLCHAIN TARGET MODULE: chained, since a caller that tests the status ignores `set -e`.
build_gcc() {
  local build=${FORESEE_BUILD:-build/release}
  cmake --preset release -B "$build" -DFORESEE_LIBC_ROOT="$PWD/build/roots/debian11" &&
    cmake --build "$build" --target foresee foresee_old_libc -- -j "$jobs" &&
    strip --strip-unneeded -o "$2" "$build/old_libc/$(basename "$2")"
}
# The linker has stripped it: a signature of macOS' covers every byte.
build_zig() {
  cmake --preset "$1" && cmake --build --preset "$1" -- -j "$jobs" && cp "build/$1/$(basename "$2")" "$2"
}
build_mingw() {
  build_zig "$@"
}
declare -A roots_of=([gcc]=debian11 [zig]="zig include" [mingw]=include)

[ $# -gt 0 ] || {
  echo "usage: bash $release/build_target.sh TARGET..." >&2
  exit 2
}
need_packages "${build_packages[@]}"
for target in "$@"; do
  toolchain=$(column "$target" toolchain)
  [ -n "$toolchain" ] || { echo "build_target.sh: there is no target $target in $release/targets" >&2; exit 2; }
  folder=build/targets/$target
  mkdir -p "$folder"
  # shellcheck disable=SC2086  # a few words
  bash $release/fetch_roots.sh ${roots_of[$toolchain]}
  [ "$toolchain" != mingw ] || need_packages "${windows_packages[@]}"
  "build_$toolchain" "$target" "$folder/$(column "$target" module)" >"$folder/build.log" 2>&1 || {
    tail -n 20 "$folder/build.log" >&2
    echo "build_target.sh: $target was not built ($folder/build.log)" >&2
    exit 1
  }
  cat $release/third_party/every_target "$release/third_party/$toolchain" >"$folder/THIRD_PARTY"
  echo "Built $folder/$(column "$target" module)"
done
