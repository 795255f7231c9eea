#include "base/float_environment.h"

#include <gtest/gtest.h>

#include <cfenv>

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

namespace foresee {
namespace {

TEST(FloatEnvironment, RoundsToNearestAndGivesTheHostItsModeBack) {
  // Volatile on both sides, so that no compiler moves a division past a change of the mode.
  volatile double one = 1, three = 3, nearest, upward, inside;
  nearest = one / three;
  std::fesetround(FE_UPWARD);
  upward = one / three;
  {
    const FloatEnvironment environment;
    inside = one / three;
  }
  const int mode = std::fegetround();
  std::fesetround(FE_TONEAREST);
  EXPECT_NE(double{upward}, double{nearest});
  EXPECT_EQ(double{inside}, double{nearest});
  EXPECT_EQ(mode, FE_UPWARD);
}

#if defined(__x86_64__)
TEST(FloatEnvironment, KeepsSubnormalNumbers) {
  constexpr unsigned flush_both = 0x8040;
  const unsigned host = _mm_getcsr();
  _mm_setcsr(host | flush_both);
  volatile double small = 0x1p-1022, flushed, kept;
  flushed = small / 4;
  {
    const FloatEnvironment environment;
    kept = small / 4;
  }
  const unsigned after = _mm_getcsr();
  _mm_setcsr(host);
  EXPECT_EQ(double{flushed}, 0);
  EXPECT_EQ(double{kept}, 0x1p-1024);
  EXPECT_EQ(after & flush_both, flush_both);
}
#endif

}  // namespace
}  // namespace foresee
