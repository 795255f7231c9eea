#!/usr/bin/env bash
# Everything that must hold: installs what is missing (Debian), builds and runs all tests.
#
#   bash tests/run.sh            # the GCC release build, then the Clang build with sanitizers
#   bash tests/run.sh release    # one of them
#   bash tests/run.sh dev
#
# Ends with ctest's summary; the status is 0 only if every test of every build passed.
set -euo pipefail
cd "$(dirname "$0")/.."
. sql/packages.sh

presets=("$@")
[ ${#presets[@]} -gt 0 ] || presets=(release dev)
for preset in "${presets[@]}"; do
  case $preset in
    release | dev) ;;
    *)
      echo "usage: bash tests/run.sh [release] [dev]" >&2
      exit 2
      ;;
  esac
done

need_packages "${build_packages[@]}" "${test_packages[@]}"

# The newest SQLite, as a second one to test against: the amalgamation inside an npm package, kept in build/.
newest=build/sqlite_newest
fetch_newest_sqlite() {
  [ -f $newest/sqlite3.c ] && return 0
  mkdir -p $newest
  (
    cd $newest
    timeout 120 npm pack --silent --fetch-retries=1 --fetch-retry-mintimeout=1000 better-sqlite3 >/dev/null 2>npm.log || exit 1
    tar -xzf better-sqlite3-*.tgz --strip-components=3 package/deps/sqlite3
  )
}
amalgamation=
if fetch_newest_sqlite; then
  amalgamation=$PWD/$newest
  echo "Newest SQLite: $(sed -n 's/^#define SQLITE_VERSION  *"\(.*\)"/\1/p' $newest/sqlite3.h)"
else
  echo "SKIPPED: the tests against the newest SQLite, because npm could not fetch better-sqlite3 ($newest/npm.log)"
fi

for preset in "${presets[@]}"; do
  started=$SECONDS
  cmake --preset "$preset" -DFORESEE_TESTS=ON -DFORESEE_SQLITE_AMALGAMATION="$amalgamation"
  cmake --build --preset "$preset"
  echo "Built $preset in $((SECONDS - started)) s"
  ctest --preset "$preset" -LE hosts --parallel "$(nproc)"
done
