#include "storage/table/form_check.h"

#include <algorithm>

#include "base/error.h"

namespace foresee {

std::string FormCheck::object_fault(const double* record) {
  const auto number = static_cast<std::int64_t>(record[format_.at.outline]);
  if (number == 0) return "";
  const std::string named = name(number);
  const auto found = forms_.find(number);
  if (found == forms_.end()) return "has " + named + ", which is missing";
  if (!found->second) return "";  // damaged, as was said
  Extents<3> around = Extents<3>::none();
  try {
    around = known_.of(number, *found->second, value_or(record, format_.at.heading, 0));
  } catch (const Error& error) {
    return "has a heading that " + named + " cannot have: " + error.what();
  }
  const double* const bounds = record + format_.at.bounds;
  const int axes = bounded_axes(format_.layout.shape);
  const bool agree = std::equal(bounds, bounds + axes, around.lower.data()) &&
                     std::equal(bounds + axes, bounds + 2 * axes, around.upper.data());
  return agree ? "" : "has other bounds than " + named;
}

}  // namespace foresee
