// Counts the steps of a long loop or sort, and polls an interrupt every 16384 of them.
//
//   Steps steps(interrupt);
//   std::sort(ids.begin(), ids.end(), [&](auto a, auto b) { return steps(), a < b; });
//
// Requires: the exception may leave the range that is being sorted in any order. Cost: 1 ns per step.
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
  /// Counts work that takes as long as `steps` steps; taken() does not include it.
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
  unsigned costly_ = 0;  ///< costly work since the last poll for it, in steps
};

}  // namespace foresee
