// Measurement of processor time and of memory: repeated times with their median and ratio, and the peak
// memory and the written bytes of a child process.
#pragma once

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <exception>
#include <vector>

#include "base/error.h"

namespace foresee::bench {

/// User and system time of all threads so far.
inline double cpu_seconds() {
  timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

template <class Work>
double seconds_of(Work&& work) {
  const double begin = cpu_seconds();
  work();
  return cpu_seconds() - begin;
}

/// `written_bytes` counts what the process passes to write(), to any file.
struct Cost {
  double seconds, peak_bytes, written_bytes;
};

/// Bytes that this process has passed to write() so far; 0 where /proc does not tell.
inline double written_bytes() {
  double bytes = 0;
  if (std::FILE* io = std::fopen("/proc/self/io", "r")) {
    char name[32];
    for (double value; std::fscanf(io, "%31s %lf", name, &value) == 2;)
      if (std::strcmp(name, "wchar:") == 0) bytes = value;
    std::fclose(io);
  }
  return bytes;
}

/// Time, memory and written bytes of a child process that only does `work`, which returns the seconds that count. Call it
/// before this process has used much memory. Throws Error if the child failed.
template <class Work>
Cost cost_in_child(Work&& work) {
  std::fflush(stdout);
  int ends[2];
  if (::pipe(ends) != 0) throw Error("no pipe to a child process");
  const pid_t child = fork();
  if (child == 0) {
    try {
      const double seconds = work(), told[] = {seconds, written_bytes()};
      _exit(::write(ends[1], told, sizeof told) == sizeof told ? 0 : 1);
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s\n", error.what());
      _exit(1);
    }
  }
  double told[2] = {0, 0};
  ::close(ends[1]);
  const bool done = ::read(ends[0], told, sizeof told) == sizeof told;
  ::close(ends[0]);
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  if (!done) throw Error("a child process failed");
  return {told[0], static_cast<double>(usage.ru_maxrss) * 1024, told[1]};
}

/// The peak memory, in bytes, of such a child.
template <class Work>
double peak_of(Work&& work) {
  return cost_in_child([&] {
           work();
           return 0.0;
         })
      .peak_bytes;
}

inline double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Both times and their ratio, one repetition after another.
struct Comparison {
  std::vector<double> ours, rivals, ratios;

  void add(double our_seconds, double rival_seconds) {
    ours.push_back(our_seconds);
    rivals.push_back(rival_seconds);
    ratios.push_back(rival_seconds / our_seconds);
  }
};

}  // namespace foresee::bench
