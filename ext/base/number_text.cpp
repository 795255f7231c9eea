#include "base/number_text.h"

#include <charconv>

namespace foresee {

std::string shown(double number) {
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, number).ptr};
}

}  // namespace foresee
