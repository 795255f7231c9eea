// Selects which operations fail in a fault test: the first ones one by one, later ones in growing steps,
// until none fails.
//
//   for (long n = 0; disturbed(n); n = next_fault(n)) …
//
// FORESEE_EVERY_FAULT=1 makes every step one: minutes instead of seconds, for a run by hand. Sanitizers slow
// each run tenfold, so there the steps grow sooner.
#pragma once

#include <cstdlib>

#include "sanitized.h"

namespace foresee::testing {

inline const bool every_fault = std::getenv("FORESEE_EVERY_FAULT") != nullptr;

inline long next_fault(long n) {
  constexpr long one_by_one = sanitized ? 10 : 50, growth = sanitized ? 4 : 14;
  return every_fault || n < one_by_one ? n + 1 : n + 1 + n / growth;
}

/// For tests of many statements: far fewer of each.
inline long next_fault_of_many(long n) {
  constexpr long growth = sanitized ? 1 : 4;
  return every_fault ? n + 1 : n + 1 + n / growth;
}

}  // namespace foresee::testing
