// The number of cases that a test draws: the number it requests, 50 times as many with FORESEE_LONG=1, and a
// twentieth under sanitizers, which make the oracles twenty times slower.
#pragma once

#include <cstdlib>

#include "sanitized.h"

namespace foresee::testing_by_hand {

using testing::sanitized;

inline int scaled_count(int cases) {
  return std::getenv("FORESEE_LONG") ? cases * 50 : sanitized ? (cases + 19) / 20 : cases;
}

}  // namespace foresee::testing_by_hand
