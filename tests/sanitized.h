// Whether the build has sanitizers: they slow everything about tenfold, so tests use smaller scenes.
#pragma once

namespace foresee::testing {

#if defined(__SANITIZE_ADDRESS__)
constexpr bool sanitized = true;
#elif defined(__has_feature)
constexpr bool sanitized = __has_feature(address_sanitizer);
#else
constexpr bool sanitized = false;
#endif

}  // namespace foresee::testing
