#!/usr/bin/env bash
# Everything that must hold: installs what is missing (Debian), builds and runs all tests.
#
#   bash tests/run.sh            # the GCC release build, then the Clang build with sanitizers
#   bash tests/run.sh release    # one of them
#   bash tests/run.sh dev
#   bash tests/run.sh hosts      # packs foresee for its hosts (ext/hosts/pack.sh) and tests what was packed
#   bash tests/run.sh targets    # builds, asks and packs the modules for all other machines, by hand before a release
#   bash tests/run.sh target     # builds and asks one of them, the next with every commit; 6 minutes at most
#
# Ends with ctest's summary; the status is 0 only if every test of every build passed.
set -euo pipefail
cd "$(dirname "$0")/.."
. sql/packages.sh
. sql/newest_sqlite.sh

presets=("$@")
[ ${#presets[@]} -gt 0 ] || presets=(release dev)
for preset in "${presets[@]}"; do
  case $preset in
    release | dev | hosts | targets | target) ;;
    *)
      echo "usage: bash tests/run.sh [release] [dev] [hosts] [targets|target]" >&2
      exit 2
      ;;
  esac
done

need_packages "${build_packages[@]}" "${test_packages[@]}"

# What was compiled in this folder before is taken from ccache, also after the build's folder is gone. Precompiled headers need
# the sloppiness. A compiler is known by what it says of itself, because zig and Emscripten are called through scripts.
export CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache
export CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_COMPILERCHECK='%compiler% --version'

amalgamation=
if fetch_newest_sqlite; then
  amalgamation=$PWD/$newest_sqlite
  echo "Newest SQLite: $(sed -n 's/^#define SQLITE_VERSION  *"\(.*\)"/\1/p' $newest_sqlite/sqlite3.h)"
else
  echo "SKIPPED: the tests against the newest SQLite, because npm could not fetch better-sqlite3 ($newest_sqlite/npm.log)"
fi

# The packages are those of the release build. What a test of a host lacks on this machine it says.
test_hosts() {
  need_packages "${host_packages[@]}"
  cmake --preset release -DFORESEE_TESTS=ON
  FORESEE_PAGE_FLAGS=-O1 bash ext/hosts/pack.sh all
  local status=0
  ctest --preset release -L hosts --parallel "$(nproc)" || status=$?
  grep -oh 'SKIPPED: .*' build/release/Testing/Temporary/LastTest.log || true
  return $status
}

# Every target that something here runs, and those that are only built; then what was packed.
test_targets() {
  FORESEE_UNTESTED=1 bash ext/hosts/pack.sh release
  /usr/bin/python3 -B tests/hosts/release_test.py
}

# The time of a build without its compilers' caches: some three minutes of one processor. What was built stays for the next.
test_one_target() {
  local foreign target status=0
  mapfile -t foreign < <(awk 'NR > 1 && $5 != "native" && $5 != "none" { print $1 }' ext/hosts/release/targets)
  target=${foreign[$(($(git rev-list --count HEAD) % ${#foreign[@]}))]}
  timeout 360 bash tests/release/one_target.sh "$target" || status=$?
  case $status in
    75) echo "SKIPPED: $target, because npm or apt could not fetch what it needs" ;;
    124) echo "SKIPPED: $target, because six minutes did not suffice (build/targets/$target/build.log)" ;;
    *) return $status ;;
  esac
}

for preset in "${presets[@]}"; do
  case $preset in
    hosts) test_hosts ;;
    targets) test_targets ;;
    target) test_one_target ;;
  esac
  case $preset in hosts | targets | target) continue ;; esac
  started=$SECONDS
  cmake --preset "$preset" -DFORESEE_TESTS=ON -DFORESEE_SQLITE_AMALGAMATION="$amalgamation"
  cmake --build --preset "$preset"
  echo "Built $preset in $((SECONDS - started)) s"
  ctest --preset "$preset" -LE hosts --parallel "$(nproc)"
done
