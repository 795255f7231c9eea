// The floating-point environment that every answer is computed in: round to nearest, subnormal numbers kept.
//
//   const FloatEnvironment environment;      // the host's settings are back when it goes out of scope
//
// A host may have switched to another rounding mode, or to flushing subnormal numbers to zero; answers must
// not depend on that. Once per batch is enough: it costs some tens of nanoseconds.
#pragma once

#include <cfenv>

#ifdef __FAST_MATH__
#error "foresee needs IEEE arithmetic: build without -ffast-math (and -Ofast)"
#endif

namespace foresee {

class FloatEnvironment {
 public:
  FloatEnvironment() {
    std::fegetenv(&host_);
    std::fesetenv(FE_DFL_ENV);
  }
  ~FloatEnvironment() { std::fesetenv(&host_); }
  FloatEnvironment(const FloatEnvironment&) = delete;
  FloatEnvironment& operator=(const FloatEnvironment&) = delete;

 private:
  std::fenv_t host_;
};

}  // namespace foresee
