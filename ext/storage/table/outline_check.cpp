#include "storage/table/outline_check.h"

#include "base/error.h"

namespace foresee::storage {

std::string OutlineCheck::object_fault(const double* record) const {
  const auto number = static_cast<std::int64_t>(record[format_.at.outline]);
  if (number == 0) return "";
  const std::string named = "outline " + std::to_string(number);
  const auto found = outlines_.find(number);
  if (found == outlines_.end()) return "has " + named + ", which is missing";
  if (!found->second) return "";  // damaged, as was said
  Extents<2> around;
  try {
    around = found->second->as_it_lies(value_or(record, format_.at.heading, 0)).extents();
  } catch (const Error& error) {
    return "has a heading that " + named + " cannot have: " + error.what();
  }
  const double* const bounds = record + format_.at.bounds;
  const bool agree = bounds[0] == around.lower[0] && bounds[1] == around.lower[1] &&
                     bounds[2] == around.upper[0] && bounds[3] == around.upper[1];
  return agree ? "" : "has other bounds than " + named;
}

}  // namespace foresee::storage
