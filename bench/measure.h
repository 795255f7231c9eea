// How long does it take, and how much memory? Processor time of this process, repeated, as a median and as a
// ratio; the peak of a child process.
#pragma once

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <vector>

#include "all_rooms.h"

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

/// The most memory, in bytes, of a process that only does `work`; this one should not have done much yet.
template <class Work>
double peak_of(Work&& work) {
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    work();
    _exit(0);
  }
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024;
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
