#include "base/number_text.h"

#include <gtest/gtest.h>

#include <cmath>

namespace foresee {
namespace {

TEST(Shown, HasTheFewestDigitsThatReadBackToTheSameNumber) {
  EXPECT_EQ(shown(0.1), "0.1");
  EXPECT_EQ(shown(0.1 + 0.2), "0.30000000000000004");
  EXPECT_EQ(shown(-3), "-3");
  EXPECT_EQ(shown(9007199254740992), "9007199254740992");
  EXPECT_EQ(shown(0x1p60), "1152921504606846976");
  EXPECT_EQ(shown(1e300), "1e+300");
  EXPECT_EQ(shown(-HUGE_VAL), "-inf");
}

}  // namespace
}  // namespace foresee
