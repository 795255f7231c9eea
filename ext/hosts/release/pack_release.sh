#!/usr/bin/env bash
# Packs a release for every target: build/packages/release/, as `bash ext/hosts/pack.sh release [TARGET...]` runs it.
#
#   foresee-V-TARGET.tar.gz or .zip     one folder of that name: the module, README, LICENSE, THIRD_PARTY
#   foresee-V-py3-none-*.whl, foresee-V.tgz, foresee-TARGET-V.tgz, *.deb, foresee-V-source.tar.gz
#   TESTED                              each artefact of a target: its sum, where it was tested, how many rows agreed
#   SHA256SUMS, sqlpkg.json             the latter if FORESEE_RELEASE_URL says where the files will be
#
# A module that has not answered tests/release/rows.sql on its target as the native build does is not packed. macOS' modules
# cannot be tested here: FORESEE_UNTESTED=1 packs them with a file UNTESTED. The page for browsers is packed if emscripten is
# there, unless FORESEE_PAGE is 0. With TARGETs their artefacts alone are packed. The same commit packed twice gives the same
# sums.
set -euo pipefail
cd "$(dirname "$0")/../../.."
. sql/packages.sh
release=ext/hosts/release
packages=$PWD/build/packages/release
version=$(sed -n 's/^project(foresee VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct)}
export SOURCE_DATE_EPOCH

need_packages "${build_packages[@]}" "${release_packages[@]}"
targets=("$@")
[ $# -gt 0 ] || mapfile -t targets < <(awk 'NR > 1 && ($5 != "none" || ENVIRON["FORESEE_UNTESTED"] == "1") { print $1 }' $release/targets)
rm -rf "$packages"
mkdir -p "$packages"
bash $release/fetch_roots.sh debian11 arm64 musl-x64 musl-arm64 sqlite
bash $release/build_target.sh linux-x64-gnu     # with the native build, which all others are compared with

# column TARGET N: the value in the table of targets.
column() {
  awk -v target="$1" -v n="$2" '$1 == target { print $n }' $release/targets
}
runner=5 wheel=6 module_name=10

# tested_as TARGET: runs the module on its target and prints "qemu, 39615 rows"; "built only" where nothing runs it.
tested_as() {
  local said
  /usr/bin/python3 -B tests/release/module_format.py "$1" >&2 || return 1
  if [ "$(column "$1" $runner)" = none ]; then
    echo "built only"
    return
  fi
  said=$(/usr/bin/python3 -B tests/release/targets.py "$1") || {
    echo "${said:-$1: the module did not answer as the native build}" >&2
    return 1
  }
  sed 's/^[^:]*: //; s/ compared$//' <<<"$said"
}

for target in "${targets[@]}"; do
  [ "$target" = linux-x64-gnu ] || bash $release/build_target.sh "$target"
  tested=$(tested_as "$target")
  module=build/targets/$target/$(column "$target" $module_name)
  /usr/bin/python3 -B $release/archive.py "$packages" "$version" "$target" "$module" "$tested"
  for host in wheel npm; do
    FORESEE_PACKAGES=$packages bash ext/hosts/pack.sh $host "$target" "$module" >"build/targets/$target/$host.log" 2>&1 || {
      tail -n 20 "build/targets/$target/$host.log" >&2
      exit 1
    }
  done
  for artefact in "$packages"/foresee-{"$version-$target".{tar.gz,zip},"$target-$version".tgz} \
    "$packages"/*-"$(column "$target" $wheel)".whl; do
    [ ! -f "$artefact" ] || echo "$(basename "$artefact") $(sha256sum <"$artefact" | cut -d' ' -f1) $tested" >>"$packages/TESTED"
  done
  echo "Packed $target: $tested"
done

# What is the same for all machines, or for this one alone, belongs to a whole release.
if [ $# = 0 ]; then
  FORESEE_PACKAGES=$packages bash ext/hosts/pack.sh deb >build/targets/deb.log 2>&1 || { tail -n 20 build/targets/deb.log >&2; exit 1; }
  if [ "${FORESEE_PAGE:-1}" = 1 ] && command -v em++ >/dev/null 2>&1; then
    bash ext/hosts/pack.sh page >build/targets/page.log 2>&1 || { tail -n 20 build/targets/page.log >&2; exit 1; }
    cp build/packages/foresee.html "$packages"
  else
    echo "Left out: foresee.html, because FORESEE_PAGE is 0 or em++ is missing (bash ext/hosts/pack.sh page installs it)"
  fi
  git archive --format=tar --prefix="foresee-$version/" HEAD | gzip -n9 >"$packages/foresee-$version-source.tar.gz"
fi
[ -z "${FORESEE_RELEASE_URL:-}" ] || /usr/bin/python3 -B $release/sqlpkg.py "$packages" "$version"
rm -rf "$packages/stage"
(cd "$packages" && find . -type f ! -name SHA256SUMS -printf '%P\n' | LC_ALL=C sort | xargs sha256sum >SHA256SUMS)
echo "Packed build/packages/release:"
(cd "$packages" && du -h -- *)
