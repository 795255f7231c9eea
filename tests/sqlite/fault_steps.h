// Which operation fails next? The first ones one by one, later ones in growing steps, until none fails.
//
//   for (long n = 0; disturbed(n); n = next_fault(n)) …
//
// FORESEE_EVERY_FAULT=1 makes every step one: minutes instead of seconds, for a run by hand. Sanitizers slow
// each run tenfold, so there the steps grow sooner.
#pragma once

#include <cstdlib>

#include "all_rooms.h"

namespace foresee::testing {

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define FORESEE_TESTS_ARE_SLOW 1
#endif
#endif

inline long next_fault(long n) {
#ifdef FORESEE_TESTS_ARE_SLOW
  constexpr long one_by_one = 20, growth = 6;
#else
  constexpr long one_by_one = 150, growth = 40;
#endif
  static const bool every = std::getenv("FORESEE_EVERY_FAULT") != nullptr;
  return every || n < one_by_one ? n + 1 : n + 1 + n / growth;
}

}  // namespace foresee::testing
