#!/usr/bin/env bash
# Packs foresee for its hosts: installs what is missing (Debian), builds where needed, writes build/packages/.
#
#   bash ext/hosts/pack.sh deb      # libsqlite3-mod-foresee and libforesee-dev
#   bash ext/hosts/pack.sh wheel    # Python's
#   bash ext/hosts/pack.sh npm      # Node's
#   bash ext/hosts/pack.sh page     # SQLite and foresee in one HTML file for browsers (installs emscripten, 800 MB)
#   bash ext/hosts/pack.sh docs     # the pages as a site
#   bash ext/hosts/pack.sh all      # each of them
#   bash ext/hosts/pack.sh release [TARGET...]   # archives and packages for every target, each tested there: release/pack_release.sh
#   bash ext/hosts/pack.sh wheel TARGET MODULE   # Python's for a target of ext/hosts/release/targets, around a finished module
#   bash ext/hosts/pack.sh npm TARGET MODULE     # Node's: the package of that target, and foresee, which is the same for all
#
# The build is build/release, which is only brought up to date where it is there already; FORESEE_BUILD names another folder,
# FORESEE_PACKAGES another one to write to. A module that is given is not stripped; it must suit the target (machine.py). A file
# THIRD_PARTY beside it goes into the package.
set -euo pipefail
cd "$(dirname "$0")/../.."
. sql/packages.sh

if [ "${1:-}" = release ]; then
  shift
  exec bash ext/hosts/release/pack_release.sh "$@"
fi

everything=(deb wheel npm page docs)
usage() {
  {
    echo "usage: bash ext/hosts/pack.sh $(IFS='|' && echo "${everything[*]}")|all"
    echo "       bash ext/hosts/pack.sh release [TARGET...]"
    echo "       bash ext/hosts/pack.sh wheel|npm TARGET MODULE, TARGET being one of $(targets | xargs)"
  } >&2
  exit 2
}
targets() {
  sed '/^#/d; 1d; s/ .*//' ext/hosts/release/targets
}
[ $# -gt 0 ] || usage
wanted=("$@")
given=()
[ "$*" != all ] || wanted=("${everything[@]}")
if [ $# = 3 ] && targets | grep -qxF -- "$2" && [ -f "$3" ]; then
  case $1 in wheel | npm) wanted=("$1") given=("$2" "$3") ;; *) usage ;; esac
fi
for host in "${wanted[@]}"; do
  case " ${everything[*]} " in *" $host "*) ;; *) usage ;; esac
done

deb_packages=("dpkg-dev: command dpkg-shlibdeps" "file: command file" "gzip: command gzip")
wheel_packages=("python3-build: python build" "python3-wheel: python wheel" "python3-setuptools: python setuptools"
  "python3-venv: python ensurepip" "binutils: command strip")
npm_packages=("npm: command npm" "python3: command python3" "binutils: command strip")

build=${FORESEE_BUILD:-build/release}
packages=$(realpath -m "${FORESEE_PACKAGES:-build/packages}")
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

# stripped_module: the build's module without symbols, in a folder where packing leaves its traces.
stripped_module() {
  mkdir -p "$packages/stage"
  strip --strip-unneeded -o "$packages/stage/foresee.so" "$build/foresee.so"
  echo "$packages/stage/foresee.so"
}

# pack_wheel [TARGET MODULE]: without them the build's module, tagged by what it needs of a machine.
pack_wheel() {
  local target=${1:-} module=${2:-} hosts=$packages/stage/hosts
  need_packages "${wheel_packages[@]}"
  if [ -z "$module" ]; then
    bring_up_to_date foresee
    module=$(stripped_module)
    rm -f "$packages"/foresee-*.whl
  else
    /usr/bin/python3 ext/hosts/machine.py "$module" "$target" >/dev/null
  fi
  rm -rf "$hosts"
  mkdir -p "$hosts/release"
  cp -r ext/hosts/python ext/hosts/machine.py "$hosts"
  cp ext/hosts/release/targets "$hosts/release"
  cp LICENSE "$hosts/python"
  [ ! -f "$(dirname "$module")/THIRD_PARTY" ] || cp "$(dirname "$module")/THIRD_PARTY" "$hosts/python"
  FORESEE_MODULE=$(realpath "$module") FORESEE_TARGET=$target FORESEE_VERSION=$version \
    /usr/bin/python3 -m build --wheel --no-isolation --outdir "$packages" "$hosts/python"
}

# pack_npm [TARGET MODULE]: without them the build's module, for the machine that packs.
pack_npm() {
  local target=${1:-} module=${2:-} npm=$packages/stage/npm
  need_packages "${npm_packages[@]}"
  if [ -z "$module" ]; then
    bring_up_to_date foresee
    module=$(stripped_module)
    target=$(/usr/bin/python3 ext/hosts/machine.py "$module")
    rm -f "$packages"/foresee-*.tgz
  else
    /usr/bin/python3 ext/hosts/machine.py "$module" "$target" >/dev/null
  fi
  rm -rf "$npm"
  /usr/bin/python3 -B ext/hosts/npm/write_packages.py "$npm" "$version" "$target" "$module"
  (cd "$npm" && npm pack --silent --pack-destination "$packages" ./foresee "./foresee-$target")
}

pack_page() {
  bash ext/hosts/browser/pack_page.sh
}

pack_docs() {
  bash ext/hosts/docs/build.sh "$packages/docs"
}

for host in "${wanted[@]}"; do
  "pack_$host" "${given[@]}"
done
rm -rf "$packages/stage"
echo "Packed:"
(cd "$packages" && du -h -- *)
