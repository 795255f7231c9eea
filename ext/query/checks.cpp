#include "query/checks.h"

#include <charconv>
#include <cmath>
#include <string>

#include "motion/error.h"

namespace foresee {
namespace {

[[noreturn]] void reject(const char* name, const char* kind, double value) {
  char digits[32];
  const std::string written(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
  throw Error(std::string(name) + " must be " + kind + ", not " + written);
}

}  // namespace

void check_not_negative(const char* name, double value) {
  if (!(std::isfinite(value) && value >= 0)) reject(name, "a finite number >= 0", value);
}

void check_finite(const char* name, double value) {
  if (!std::isfinite(value)) reject(name, "a finite number", value);
}

}  // namespace foresee
