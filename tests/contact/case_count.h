// How many cases a test looks at: as many as it asks for; FORESEE_LONG=1 makes them 50 times as many, and
// under sanitizers, which make the judges twenty times slower, they are a twentieth.
#pragma once

#include <cstdlib>

namespace foresee::contact::testing_by_hand {

#if defined(__SANITIZE_ADDRESS__)
constexpr bool sanitized = true;
#elif defined(__has_feature)
constexpr bool sanitized = __has_feature(address_sanitizer);
#else
constexpr bool sanitized = false;
#endif

inline int scaled_count(int cases) {
  return std::getenv("FORESEE_LONG") ? cases * 50 : sanitized ? (cases + 19) / 20 : cases;
}

}  // namespace foresee::contact::testing_by_hand
