#!/usr/bin/env bash
# Packs foresee for its hosts: installs what is missing (Debian), builds where needed, writes build/packages/.
#
#   bash ext/hosts/pack.sh deb      # libsqlite3-mod-foresee and libforesee-dev
#   bash ext/hosts/pack.sh wheel    # Python's
#   bash ext/hosts/pack.sh npm      # Node's
#   bash ext/hosts/pack.sh page     # SQLite and foresee in one HTML file for browsers (installs emscripten, 800 MB)
#   bash ext/hosts/pack.sh docs     # the pages as a site
#   bash ext/hosts/pack.sh all      # each of them
#
# The build is build/release, which is only brought up to date where it is there already; FORESEE_BUILD names another folder.
set -euo pipefail
cd "$(dirname "$0")/../.."
. sql/packages.sh

everything=(deb wheel npm page docs)
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
wheel_packages=("python3-build: python build" "python3-wheel: python wheel" "python3-setuptools: python setuptools"
  "python3-venv: python ensurepip" "binutils: command strip")
npm_packages=("npm: command npm" "binutils: command strip")

build=${FORESEE_BUILD:-build/release}
packages=$PWD/build/packages
version=$(sed -n 's/^project(foresee VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
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

# staged HOST: a copy of ext/hosts/HOST with the licence, where packing leaves its traces.
staged() {
  local stage=$packages/stage/$1
  rm -rf "$stage"
  mkdir -p "$stage"
  cp -r "ext/hosts/$1/." LICENSE "$stage"
  echo "$stage"
}

pack_wheel() {
  need_packages "${wheel_packages[@]}"
  bring_up_to_date foresee
  local stage
  stage=$(staged python)
  strip --strip-unneeded -o "$stage/foresee.so" "$build/foresee.so"
  rm -f "$packages"/foresee-*.whl
  FORESEE_MODULE=$stage/foresee.so FORESEE_VERSION=$version \
    /usr/bin/python3 -m build --wheel --no-isolation --outdir "$packages" "$stage"
}

pack_npm() {
  need_packages "${npm_packages[@]}"
  bring_up_to_date foresee
  local stage
  stage=$(staged npm)
  strip --strip-unneeded -o "$stage/foresee.so" "$build/foresee.so"
  rm -f "$packages"/foresee-*.tgz
  (
    cd "$stage"
    npm pkg set version="$version"
    npm pack --silent --pack-destination "$packages"
  )
}

pack_page() {
  bash ext/hosts/browser/pack_page.sh
}

pack_docs() {
  bash ext/hosts/docs/build.sh "$packages/docs"
}

for host in "${wanted[@]}"; do
  "pack_$host"
done
rm -rf "$packages/stage"
echo "Packed:"
(cd "$packages" && du -h -- *)
