#include "motion/float_environment.h"

#include <gtest/gtest.h>

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

namespace foresee {
namespace {

TEST(FloatEnvironment, RoundsToNearestAndGivesTheHostItsModeBack) {
  volatile double one = 1, three = 3;
  const double nearest = one / three;
  std::fesetround(FE_UPWARD);
  const double upward = one / three;
  double inside;
  {
    const FloatEnvironment environment;
    inside = one / three;
  }
  const int mode = std::fegetround();
  std::fesetround(FE_TONEAREST);
  EXPECT_NE(upward, nearest);
  EXPECT_EQ(inside, nearest);
  EXPECT_EQ(mode, FE_UPWARD);
}

#if defined(__x86_64__)
TEST(FloatEnvironment, KeepsSubnormalNumbers) {
  constexpr unsigned flush_both = 0x8040;
  const unsigned host = _mm_getcsr();
  _mm_setcsr(host | flush_both);
  volatile double small = 0x1p-1022;
  const double flushed = small / 4;
  double kept;
  {
    const FloatEnvironment environment;
    kept = small / 4;
  }
  const unsigned after = _mm_getcsr();
  _mm_setcsr(host);
  EXPECT_EQ(flushed, 0);
  EXPECT_EQ(kept, 0x1p-1024);
  EXPECT_EQ(after & flush_both, flush_both);
}
#endif

}  // namespace
}  // namespace foresee
