#!/usr/bin/env bash
# Packs SQLite, foresee and the page into one HTML file, build/packages/foresee.html; called by ext/hosts/pack.sh page.
#
# The ships of the Lower Mississippi are in it where ../shared/data (or the folder that FORESEE_SHARED_DATA names) holds
# them. FORESEE_PAGE_FLAGS: how it is optimised, -O2 unless told.
set -euo pipefail
cd "$(dirname "$0")/../../.."
. sql/packages.sh
. sql/newest_sqlite.sh

need_packages "emscripten: command emcc" "cmake: command cmake" "ninja-build: command ninja" "python3: command python3" \
  "npm: command npm" "libboost-dev: header boost/version.hpp"
fetch_newest_sqlite || {
  echo "SQLite's amalgamation could not be fetched by npm ($newest_sqlite/npm.log): put sqlite3.c and sqlite3.h into $newest_sqlite" >&2
  exit 1
}

flags=${FORESEE_PAGE_FLAGS:--O2}
version=$(sed -n 's/^project(foresee VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
# Debian's emcc needs Debian's JavaScript packages, also where Node comes from elsewhere.
export NODE_PATH=/usr/share/nodejs
emcmake cmake -S ext/hosts/browser -B build/page -G Ninja -DCMAKE_BUILD_TYPE=None "-DCMAKE_C_FLAGS=$flags" "-DCMAKE_CXX_FLAGS=$flags" \
  -DFORESEE_SQLITE_AMALGAMATION="$PWD/$newest_sqlite" -DFORESEE_VERSION="$version" >/dev/null
cmake --build build/page

ships=${FORESEE_SHARED_DATA:-../shared/data}/ships_mississippi.csv
[ -f "$ships" ] || ships=
/usr/bin/python3 ext/hosts/browser/make_page.py build/page build/packages/foresee.html ${ships:+"$ships"}
