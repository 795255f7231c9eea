// Converts a double to a 64-bit integer if it has exactly that value.
//
//   integer_of(7.0) == 7
//   integer_of(0.5), integer_of(0x1p63), integer_of(NAN)           // nothing
#pragma once

#include <cstdint>
#include <optional>

namespace foresee {

/// Empty if the number is not an integer, or does not fit into 64 bits.
inline std::optional<std::int64_t> integer_of(double number) {
  if (!(number >= -0x1p63 && number < 0x1p63)) return std::nullopt;
  const auto integer = static_cast<std::int64_t>(number);
  if (static_cast<double>(integer) != number) return std::nullopt;
  return integer;
}

}  // namespace foresee
