# shellcheck shell=bash disable=SC2034
# What must be on the machine before foresee can be built, and how it gets there. Sourced by sql/demo.sh, sql/scale_demo.sh,
# tests/run.sh and ext/hosts/pack.sh:
#
#   need_packages "${build_packages[@]}"
#
# Each line is "Debian package: how we see that it is there". What is there is left alone, wherever it came from. What is
# missing is installed with apt where there is apt; anywhere else the list is printed and nothing is begun.

build_packages=(
  "g++: command g++"
  "cmake: command cmake"
  "ninja-build: command ninja"
  "git: command git"
  "sqlite3: command sqlite3"
  "libsqlite3-dev: header sqlite3ext.h"
  "libboost-dev: header boost/version.hpp"
)
test_packages=(
  "ccache: command ccache"
  "clang: command clang++"
  "libclang-rt-14-dev: sanitizers"
  "libgtest-dev: header gtest/gtest.h"
  "python3: command python3"
  "npm: command npm"
  "clang-format: command clang-format"
  "binutils: command nm"
)
host_packages=(
  "pkg-config: command pkg-config"
  "groff-base: command groff"
  "chromium: command chromium"
  "python3-distributed: python distributed"
  "python3-sqlalchemy: python sqlalchemy"
  "cargo: file /usr/bin/cargo"
  "librust-rusqlite-dev: file /usr/share/cargo/registry/rusqlite-*/Cargo.toml"
  "golang-go: file /usr/bin/go"
  "golang-github-mattn-go-sqlite3-dev: file /usr/share/gocode/src/github.com/mattn/go-sqlite3/go.mod"
  "sqlite-utils: file /usr/bin/sqlite-utils"
  "mosquitto: command mosquitto"
  "python3-paho-mqtt: python paho.mqtt.client"
  "gpsd-clients: command gpsdecode"
)

# What builds and asks the modules for other machines; zig comes by npm (ext/hosts/release/fetch_roots.sh).
windows_packages=(
  "g++-mingw-w64-x86-64-posix: command x86_64-w64-mingw32-g++-posix"
  "wine64: command /usr/lib/wine/wine64"
)
release_packages=(
  "${windows_packages[@]}"
  "qemu-user-static: command qemu-aarch64-static"
  "npm: command npm"
  "binutils: command readelf"
  "python3-build: python build"
  "python3-wheel: python wheel"
  "python3-setuptools: python setuptools"
  "python3-venv: python ensurepip"
)

# Is one of the headers found by the C++ compiler?
has_header() {
  local header
  for header in "$@"; do
    if echo "#include <$header>" | g++ -std=c++20 -E -x c++ - >/dev/null 2>&1; then return 0; fi
  done
  return 1
}

# Does Clang find its sanitizer runtimes?
has_sanitizers() {
  echo 'int main() {}' | clang++ -fsanitize=address,undefined -x c++ - -o /dev/null >/dev/null 2>&1
}

is_there() {
  local kind=$1
  shift
  case $kind in
    command) PATH=$PATH:/usr/sbin command -v "$1" >/dev/null 2>&1 ;;
    file) [ -e "$1" ] ;;
    header) has_header "$@" ;;
    sanitizers) has_sanitizers ;;
    python) (cd / && /usr/bin/python3 -c "import $1") >/dev/null 2>&1 ;;  # a folder build/ here is a module too
  esac
}

# The names of those packages whose check fails, one a line.
missing_packages() {
  local need
  for need in "$@"; do
    # shellcheck disable=SC2086  # the check is a few words
    is_there ${need#*: } || echo "${need%%: *}"
  done
}

install_with_apt() {
  local as_root=()
  [ "$(id -u)" = 0 ] || as_root=(sudo)
  echo "Installing: $*"
  "${as_root[@]}" apt-get update -qq &&
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "$@" >/dev/null
}

say_what_is_missing() {
  {
    echo "Missing on this machine (by their Debian names): $*"
    echo "Install them, then run this script again."
  } >&2
}

need_packages() {
  local missing
  mapfile -t missing < <(missing_packages "$@")
  [ ${#missing[@]} -eq 0 ] && return 0
  if ! command -v apt-get >/dev/null 2>&1 || { [ "$(id -u)" != 0 ] && ! command -v sudo >/dev/null 2>&1; }; then
    say_what_is_missing "${missing[@]}"
    return 1
  fi
  install_with_apt "${missing[@]}" || { say_what_is_missing "${missing[@]}"; return 1; }
  mapfile -t missing < <(missing_packages "$@")
  [ ${#missing[@]} -eq 0 ] || { say_what_is_missing "${missing[@]}"; return 1; }
}
