// A pair of objects by row numbers: the type of join candidates and results.
#pragma once

#include <compare>
#include <cstdint>

namespace foresee {

/// Row numbers of two objects: one of the bodies a, one of the bodies b (of a again in a self-join).
struct Pair {
  std::uint32_t a;
  std::uint32_t b;

  friend bool operator==(const Pair&, const Pair&) = default;
  friend auto operator<=>(const Pair&, const Pair&) = default;
};

}  // namespace foresee
