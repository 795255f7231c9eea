// How does a long loop or sort heed an interrupt? It counts its steps, and asks now and then.
//
//   Steps steps(interrupt);
//   std::sort(ids.begin(), ids.end(), [&](auto a, auto b) { return steps(), a < b; });
//
// Requires: what is sorted may be left in any order by the exception. Cost: a nanosecond a step.
#pragma once

#include <cstdint>

#include "base/error.h"

namespace foresee {

class Steps {
 public:
  explicit Steps(Interrupt& interrupt) : interrupt_(interrupt) {}

  void operator()() {
    if (++steps_ % between == 0) interrupt_.check();
  }
  /// What takes as long as so many steps, and is none.
  void costly(unsigned steps) {
    costly_ += steps;
    if (costly_ < between) return;
    costly_ = 0;
    interrupt_.check();
  }
  std::uint64_t taken() const { return steps_; }

 private:
  static constexpr unsigned between = 1 << 14;

  Interrupt& interrupt_;
  std::uint64_t steps_ = 0;
  unsigned costly_ = 0;  ///< since it was asked last about these
};

}  // namespace foresee
