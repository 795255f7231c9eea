// Cache of the bounding boxes of rotated forms, by form number and heading.
//
//   ExtentsCache known;
//   known.of(3, *hull, 37.5)              // as hull->extents(37.5); throws as that does
//
// It saves rotating a form again for the next row of the same form and heading. Requires: a number always
// means the same form. Memory: some megabytes at most.
#pragma once

#include <cstdint>
#include <unordered_map>

#include "shape/form_rows.h"
#include "shape/shared_form.h"

namespace foresee {

class ExtentsCache {
 public:
  const Extents<3>& of(std::int64_t number, const Form& form, double heading) {
    const Pose<std::int64_t> pose{number, heading};
    const auto found = known_.find(pose);
    if (found != known_.end()) return found->second;
    if (known_.size() >= limit) known_.clear();
    return known_.emplace(pose, form.extents(heading)).first->second;
  }

 private:
  static constexpr std::size_t limit = 1 << 16;

  std::unordered_map<Pose<std::int64_t>, Extents<3>, PoseHash<std::int64_t>> known_;
};

}  // namespace foresee
