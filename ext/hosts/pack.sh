#!/usr/bin/env bash
# Packs foresee for its hosts: installs what is missing (Debian), builds where needed, writes build/packages/.
#
#   bash ext/hosts/pack.sh deb      # libsqlite3-mod-foresee and libforesee-dev
#   bash ext/hosts/pack.sh all      # each of them
#
# The build is build/release, which is only brought up to date where it is there already; FORESEE_BUILD names another folder.
set -euo pipefail
cd "$(dirname "$0")/../.."
. sql/packages.sh

everything=(deb)
usage() {
  echo "usage: bash ext/hosts/pack.sh $(IFS='|' && echo "${everything[*]}")|all" >&2
  exit 2
}
[ $# -gt 0 ] || usage
wanted=("$@")
[ "$*" != all ] || wanted=("${everything[@]}")
for host in "${wanted[@]}"; do
  case " ${everything[*]} " in *" $host "*) ;; *) usage ;; esac
done

deb_packages=("dpkg-dev: command dpkg-shlibdeps" "file: command file" "gzip: command gzip")

build=${FORESEE_BUILD:-build/release}
packages=$PWD/build/packages
mkdir -p "$packages"

# bring_up_to_date TARGET...: builds them in the build folder, which is made if it is not there.
bring_up_to_date() {
  need_packages "${build_packages[@]}"
  [ -f "$build/build.ninja" ] || cmake --preset release
  cmake --build "$build" --target "$@"
}

pack_deb() {
  need_packages "${deb_packages[@]}"
  bring_up_to_date foresee foresee_archive foresee_core
  rm -f "$packages"/*.deb
  (cd "$build" && cpack -G DEB -B "$packages/deb")
  mv "$packages"/deb/*.deb "$packages"
  rm -rf "$packages/deb"
}

for host in "${wanted[@]}"; do
  "pack_$host"
done
echo "Packed:"
ls -l "$packages" | sed '1d; s/^/  /'
