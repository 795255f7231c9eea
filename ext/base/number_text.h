// The shortest text of a number that reads back to the same double, as messages show it.
//
//   shown(0.1) == "0.1"    shown(-3.0) == "-3"    shown(1e300) == "1e+300"    shown(HUGE_VAL) == "inf"
#pragma once

#include <charconv>
#include <string>

namespace foresee {

std::string shown(double number);

inline std::string shown(double number) {
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, number).ptr};
}

}  // namespace foresee
