// Answers must not depend on the CPU: what does a computation give with every set of vector instructions?
//
//   const Lanes lanes = settled();
//   for_every_simd([&](Simd) { EXPECT_EQ(settled(), lanes); });
//
// Failures within name the instructions. Afterwards those in use are the ones that were before.
#pragma once

#include <gtest/gtest.h>

#include "base/simd.h"

namespace foresee::testing {

/// Puts the instructions in use back when it goes, however that happens.
class KeptSimd {
 public:
  KeptSimd() = default;
  KeptSimd(const KeptSimd&) = delete;
  KeptSimd& operator=(const KeptSimd&) = delete;
  ~KeptSimd() { use_simd(usual_); }

 private:
  Simd usual_ = simd_in_use();
};

/// run(simd) with each set of instructions that this CPU has in use, narrowest first: Simd::baseline, ...
template <class Run>
void for_every_simd(Run&& run) {
  const KeptSimd kept;
  for (const Simd simd : available_simd()) {
    SCOPED_TRACE(name_of(simd));
    use_simd(simd);
    run(simd);
  }
}

}  // namespace foresee::testing
