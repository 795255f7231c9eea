// Runs a test with every set of vector instructions, since results must not depend on the CPU.
//
//   const Lanes lanes = settled();
//   for_every_simd([&](Simd) { EXPECT_EQ(settled(), lanes); });
//
// A failure within names the instructions. Afterwards the instructions that were in use before are restored.
#pragma once

#include <gtest/gtest.h>

#include "base/simd.h"

namespace foresee::testing {

/// Restores the instructions in use in its destructor.
class KeptSimd {
 public:
  KeptSimd() = default;
  KeptSimd(const KeptSimd&) = delete;
  KeptSimd& operator=(const KeptSimd&) = delete;
  ~KeptSimd() { use_simd(usual_); }

 private:
  Simd usual_ = simd_in_use();
};

/// Calls run(simd) with each set of instructions that this CPU supports in use, narrowest first.
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
