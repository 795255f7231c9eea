# shellcheck shell=bash
# The machine and the build behind figures, as text; sourced by the scripts of this folder.
#
#   describe_machine >machine.txt; …; load_at_the_end >>machine.txt
# The load is that before the script's own build.
load_at_the_start=$(cut -d' ' -f1-3 /proc/loadavg)

describe_machine() {
  echo "CPU: $(sed -n 's/^model name\s*: //p' /proc/cpuinfo | head -n 1), $(nproc) cores; processor time of one thread"
  echo "Compiler: $(g++ --version | head -n 1)"
  echo "Flags: -O3 -march=x86-64-v2 -ffp-contract=off -fno-math-errno -fno-trapping-math"
  echo "Library: $(sed -n 's/^CMAKE_PROJECT_VERSION:STATIC=//p' build/release/CMakeCache.txt), commit $(git rev-parse --short=12 HEAD)"
  echo "Load average at the start: $load_at_the_start"
}

load_at_the_end() {
  echo "Load average at the end: $(cut -d' ' -f1-3 /proc/loadavg)"
}
