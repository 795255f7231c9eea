// The shortest text of a number that reads back to the same double, as messages show it.
//
//   shown(0.1) == "0.1"    shown(-3.0) == "-3"    shown(1e300) == "1e+300"    shown(HUGE_VAL) == "inf"
//   shown(1796000000.0) == "1796000000"                  // as all integers up to 2^53: times are often round
#pragma once

#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>

namespace foresee {

std::string shown(double number);

inline std::string shown(double number) {
  char digits[32];
  const bool is_integer = number != 0 && std::abs(number) <= 0x1p53 && number == std::trunc(number);
  return {digits, is_integer
                      ? std::to_chars(digits, digits + sizeof digits, static_cast<std::int64_t>(number)).ptr
                      : std::to_chars(digits, digits + sizeof digits, number).ptr};
}

}  // namespace foresee
