// Sets the floating-point environment for every computation: round to nearest, subnormal numbers kept.
//
//   const FloatEnvironment environment;      // the host's settings are back when it goes out of scope
//
// A host application may use another rounding mode, or flush subnormal numbers to zero; results must not
// depend on that. On x86-64 doubles are computed in SSE registers, and only their control word is saved and
// set: some nanoseconds. Other processors need the whole environment: some tens. Once per batch is enough.
#pragma once

#include "base/error.h"  // refuses -ffast-math

#ifdef __SSE2_MATH__
#include <xmmintrin.h>

#include <atomic>
#else
#include <cfenv>
#endif

namespace foresee {

class FloatEnvironment {
 public:
  FloatEnvironment(const FloatEnvironment&) = delete;
  FloatEnvironment& operator=(const FloatEnvironment&) = delete;

#ifdef __SSE2_MATH__
  FloatEnvironment() : host_(_mm_getcsr()) {
    set(round_to_nearest);
  }
  ~FloatEnvironment() {
    set(host_);
  }

 private:
  static constexpr unsigned round_to_nearest = 0x1f80;  // all exceptions masked, no flags, nothing flushed

  /// The fences keep the compiler from moving reads and writes of numbers across the switch.
  static void set(unsigned control) {
    std::atomic_signal_fence(std::memory_order_seq_cst);
    _mm_setcsr(control);
    std::atomic_signal_fence(std::memory_order_seq_cst);
  }

  unsigned host_;
#else
  FloatEnvironment() {
    std::fegetenv(&host_);
    std::fesetenv(FE_DFL_ENV);
  }
  ~FloatEnvironment() {
    std::fesetenv(&host_);
  }

 private:
  std::fenv_t host_;
#endif
};

}  // namespace foresee
