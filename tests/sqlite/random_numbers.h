// Numbers drawn for tables that SQL makes, and written so that SQL reads the very same.
#pragma once

#include <charconv>
#include <random>
#include <string>

namespace foresee::testing {

using Engine = std::mt19937_64;

inline double drawn(Engine& random, double least, double most) {
  return std::uniform_real_distribution<double>(least, most)(random);
}
inline int drawn(Engine& random, int least, int most) {
  return std::uniform_int_distribution<int>(least, most)(random);
}

inline std::string shown_exactly(double number) {
  char digits[40];
  return {digits, std::to_chars(digits, digits + sizeof digits, number).ptr};
}

}  // namespace foresee::testing
