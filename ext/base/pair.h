// Two objects by row number: what candidates and hits are.
#pragma once

#include <compare>
#include <cstdint>

namespace foresee {

/// Row numbers of two objects, the first among the bodies a, the second among the bodies b (or a again).
struct Pair {
  std::uint32_t a;
  std::uint32_t b;

  friend bool operator==(const Pair&, const Pair&) = default;
  friend auto operator<=>(const Pair&, const Pair&) = default;
};

}  // namespace foresee
