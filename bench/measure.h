// Measurement of processor time and of memory: repeated times with their median and ratio, memory of this
// process and of its children, their written bytes, and limits to their time.
#pragma once

#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <exception>
#include <fstream>
#include <string>
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

/// A value that child processes share with this one. It is trivially copyable.
template <class T>
class SharedValue {
 public:
  SharedValue()
      : value_(static_cast<T*>(
            ::mmap(nullptr, sizeof(T), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0))) {
    if (value_ == MAP_FAILED) throw Error("no memory to share with a child process");
    *value_ = {};
  }
  ~SharedValue() { ::munmap(value_, sizeof(T)); }
  SharedValue(const SharedValue&) = delete;
  SharedValue& operator=(const SharedValue&) = delete;
  T* operator->() { return value_; }
  T& operator*() { return *value_; }

 private:
  T* value_;
};

/// Waits for a child, and ends it after `limit` seconds of processor time; false then. A timer in the child
/// would do so too, but while it runs the kernel updates clocks of processor time only a few hundred times
/// per second.
inline bool wait_for(pid_t child, double limit, int& status, rusage& usage) {
  clockid_t clock;
  if (clock_getcpuclockid(child, &clock) != 0) throw Error("no clock of a child process");
  for (useconds_t pause = 100; wait4(child, &status, WNOHANG, &usage) == 0;
       pause = std::min(2 * pause, 20000u)) {
    timespec used{};
    if (clock_gettime(clock, &used) == 0 && static_cast<double>(used.tv_sec) >= limit) {
      kill(child, SIGKILL);
      wait4(child, &status, 0, &usage);
      return false;
    }
    usleep(pause);
  }
  return true;
}

/// Does `work` in a child process, which has a copy of this one's memory. False if it used more than `limit`
/// seconds of processor time. Throws Error if it failed.
template <class Work>
bool run_in_child(Work&& work, double limit = 1e9, rusage* usage = nullptr) {
  std::fflush(stdout);
  const pid_t child = fork();
  if (child < 0) throw Error("no child process");
  if (child == 0) {
    try {
      work();
      std::fflush(stdout);
      _exit(0);
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s\n", error.what());
      _exit(1);
    }
  }
  int status = 0;
  rusage used{};
  if (!wait_for(child, limit, status, usage ? *usage : used)) return false;
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) throw Error("a child process failed");
  return true;
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

/// Time, memory and written bytes of a child process that only does `work`, which returns the seconds that count.
/// Call it before this process has used much memory. Throws Error if the child failed.
template <class Work>
Cost cost_in_child(Work&& work) {
  SharedValue<Cost> cost;
  rusage usage{};
  run_in_child(
      [&] {
        cost->seconds = work();
        cost->written_bytes = written_bytes();
      },
      1e9, &usage);
  return {cost->seconds, static_cast<double>(usage.ru_maxrss) * 1024, cost->written_bytes};
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

/// Bytes of this process in memory, now and at most since forget_peak().
class Resident {
 public:
  static double now() { return bytes("VmRSS:"); }
  static double peak() { return bytes("VmHWM:"); }
  static void forget_peak() { std::ofstream("/proc/self/clear_refs") << 5; }

 private:
  static double bytes(const std::string& name) {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
      if (double kilobytes = 0; word == name && status >> kilobytes) return 1024 * kilobytes;
    throw Error("/proc/self/status does not have " + name);
  }
};

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
