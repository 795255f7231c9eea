#!/usr/bin/env bash
# Builds one target and compares its rows with those of the native build: `bash tests/run.sh target` runs this.
#
#   bash tests/release/one_target.sh linux-arm64-gnu
#
# The status is 75 if npm or apt cannot fetch what the target needs, and 0 if its rows are those of the native build.
set -euo pipefail
cd "$(dirname "$0")/../.."
. sql/packages.sh

need_packages "${release_packages[@]}" || exit 75
bash ext/hosts/release/fetch_roots.sh debian11 arm64 musl-x64 musl-arm64 zig sqlite include
[ -f build/release/foresee.so ] || bash ext/hosts/release/build_target.sh linux-x64-gnu
bash ext/hosts/release/build_target.sh "$1"
/usr/bin/python3 -B tests/release/module_format.py "$1"
/usr/bin/python3 -B tests/release/targets.py "$1"
