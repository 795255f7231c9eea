// Processor time of the calling thread, with which predictive_explain measures stages, batch by batch. One
// reading costs some hundred nanoseconds.
#pragma once

#include <ctime>

namespace foresee {

inline double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

}  // namespace foresee
