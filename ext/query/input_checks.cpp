#include "query/input_checks.h"

#include <cmath>

#include "base/error.h"
#include "base/number_text.h"

namespace foresee {
namespace {

[[noreturn]] void reject(const char* name, const char* kind, double value) {
  throw Error(std::string(name) + " must be " + kind + ", not " + shown(value));
}

std::string axes_in_words(const SearchTarget& objects) {
  const char* axes[] = {"1 axis (x)", "2 axes (x, y)", "3 axes (x, y, z)"};
  return objects.name + " has " + axes[objects.layout().axes - 1];
}

}  // namespace

void require_not_negative(const char* name, double value) {
  if (!(std::isfinite(value) && value >= 0)) reject(name, "a finite number >= 0", value);
}

void require_positive(const char* name, double value) {
  if (!(std::isfinite(value) && value > 0)) reject(name, "a finite number > 0", value);
}

void require_finite(const char* name, double value) {
  if (!std::isfinite(value)) reject(name, "a finite number", value);
}

void require_lower_bound(const char* name, double value) {
  if (!(value < HUGE_VAL)) reject(name, "a finite number, or left out for no bound", value);
}

void require_upper_bound(const char* name, double value) {
  if (!(value > -HUGE_VAL)) reject(name, "a finite number, or left out for no bound", value);
}

void require_order(const char* lower_name, double lower, const char* upper_name, double upper) {
  if (lower <= upper) return;
  throw Error(std::string(lower_name) + " must not be greater than " + upper_name + ": " + lower_name +
              " is " + shown(lower) + ", " + upper_name + " is " + shown(upper));
}

bool wants_all_contacts(std::string_view text) {
  if (text == "all") return true;
  if (text == "first") return false;
  throw Error("contacts must be 'first' or 'all', not '" + std::string(text) + "'");
}

void refuse_all_contacts_of_forms(const Layout& layout) {
  if (is_stored_apart(layout.shape))
    throw Error("contacts = 'all' is not for outlines and meshes: leave it out");
}

void reject_axis(const SearchTarget& objects, const std::string& given) {
  throw Error(axes_in_words(objects) + ": leave out " + given);
}

void reject_missing(const SearchTarget& objects, const std::string& coordinate) {
  throw Error(axes_in_words(objects) + ": " + coordinate + " is missing; give one number for each axis");
}

}  // namespace foresee
