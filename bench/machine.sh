# shellcheck shell=bash
# The machine and the build behind figures, as text; sourced by the scripts of this folder before they build.
#
#   . bench/machine.sh; …build…; describe_machine >machine.txt; …measure…; load_at_the_end >>machine.txt
load_before=$(cut -d' ' -f1-3 /proc/loadavg)  # a build would raise it

# "0.61 0.50 0.40", with a warning where other programs ran.
marked_load() {
  echo "$1" | awk '{ print $0 ($1 >= 0.3 ? " (a busy machine: times are too long)" : "") }'
}

# "1 core", "8 cores": those that this process may use. OMP_NUM_THREADS, which nproc follows, is of other programs.
shown_cores() {
  env -u OMP_NUM_THREADS -u OMP_THREAD_LIMIT nproc | awk '{ print $1 ($1 == 1 ? " core" : " cores") }'
}

describe_machine() {
  echo "CPU: $(sed -n 's/^model name\s*: //p' /proc/cpuinfo | head -n 1), $(shown_cores); processor time of one thread"
  echo "Compiler: $(g++ --version | head -n 1)"
  echo "Flags: -O3 -march=x86-64-v2 -ffp-contract=off -fno-math-errno -fno-trapping-math"
  echo "Library: $(sed -n 's/^CMAKE_PROJECT_VERSION:STATIC=//p' build/release/CMakeCache.txt), commit $(git rev-parse --short=12 HEAD)"
  echo "Load average at the start: $(marked_load "$load_before")"
}

# The program itself is one of those that run.
load_at_the_end() {
  echo "Load average at the end: $(cut -d' ' -f1-3 /proc/loadavg)"
}
