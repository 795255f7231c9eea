#!/usr/bin/env bash
# Everything that must hold: installs what is missing (Debian), builds and runs all tests.
#
#   bash tests/run.sh            # the GCC release build, then the Clang build with sanitizers
#   bash tests/run.sh release    # one of them
#   bash tests/run.sh dev
#   bash tests/run.sh hosts      # packs foresee for its hosts (ext/hosts/pack.sh) and tests what was packed
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
    release | dev | hosts) ;;
    *)
      echo "usage: bash tests/run.sh [release] [dev] [hosts]" >&2
      exit 2
      ;;
  esac
done

need_packages "${build_packages[@]}" "${test_packages[@]}"

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
  ctest --preset release -L hosts || status=$?
  grep -oh 'SKIPPED: .*' build/release/Testing/Temporary/LastTest.log || true
  return $status
}

for preset in "${presets[@]}"; do
  if [ "$preset" = hosts ]; then
    test_hosts
    continue
  fi
  started=$SECONDS
  cmake --preset "$preset" -DFORESEE_TESTS=ON -DFORESEE_SQLITE_AMALGAMATION="$amalgamation"
  cmake --build --preset "$preset"
  echo "Built $preset in $((SECONDS - started)) s"
  ctest --preset "$preset" -LE hosts --parallel "$(nproc)"
done
