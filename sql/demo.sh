#!/usr/bin/env bash
# The tour: installs what is missing (Debian), builds the extension and runs sql/tour/ in the sqlite3 shell.
#
#   bash sql/demo.sh
#
# Prints what a person at the shell would see. Step 05 imports the real ships of sql/data/.
set -euo pipefail
cd "$(dirname "$0")/.."
. sql/packages.sh

need_packages "${build_packages[@]}"

log=build/demo.log
mkdir -p build
build() {
  [ -f build/release/build.ninja ] || cmake --preset release
  cmake --build --preset release --target foresee
}
echo "Building build/release/foresee.so (a few minutes the first time; log: $log)"
if ! build >"$log" 2>&1; then
  tail -n 40 "$log" >&2
  echo "The build failed; the whole log is $log." >&2
  exit 1
fi

for step in sql/tour/*.sql; do
  printf '\n=== %s ===\n' "$step"
  # The step that shows mistakes ends with the status of an error; no other one may.
  sqlite3 -batch -init /dev/null :memory: <"$step" 2>&1 || [ "$step" = sql/tour/04_mistakes.sql ]
done

cat <<'END'

That was the tour. Your turn, from this directory:

  sqlite3 fleet.db
  sqlite> .load build/release/foresee
  sqlite> .read sql/tour/01_harbour.sql
END
