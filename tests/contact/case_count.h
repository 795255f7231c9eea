// How many cases a test looks at: as many as it asks for; FORESEE_LONG=1 makes them 50 times as many, and
// under sanitizers, which make the judges twenty times slower, they are a twentieth.
#pragma once

#include <cstdlib>

#include "sanitized.h"

namespace foresee::testing_by_hand {

using testing::sanitized;

inline int scaled_count(int cases) {
  return std::getenv("FORESEE_LONG") ? cases * 50 : sanitized ? (cases + 19) / 20 : cases;
}

}  // namespace foresee::testing_by_hand
