// Random numbers for tables that SQL creates, written so that SQL reads back the same number.
#pragma once

#include <charconv>
#include <random>
#include <string>

namespace foresee::testing {

using Engine = std::mt19937_64;

inline double drawn(Engine& random, double lowest, double highest) {
  return std::uniform_real_distribution<double>(lowest, highest)(random);
}
inline int drawn(Engine& random, int lowest, int highest) {
  return std::uniform_int_distribution<int>(lowest, highest)(random);
}

inline std::string shown_exactly(double number) {
  char digits[40];
  return {digits, std::to_chars(digits, digits + sizeof digits, number).ptr};
}

}  // namespace foresee::testing
