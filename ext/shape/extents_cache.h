// Cache of the bounding boxes of rotated forms, by form number and heading.
//
//   ExtentsCache known;
//   known.of(3, *hull, 37.5)              // as hull->extents(37.5); throws as that does
//
// It saves rotating a form again for the next row of the same form and heading. Requires: a number always
// means the same form. Memory: some megabytes at most.
#pragma once

#include <cstdint>
#include <functional>
#include <unordered_map>

#include "shape/shared_form.h"

namespace foresee {

class ExtentsCache {
 public:
  const Extents<3>& of(std::int64_t number, const Form& form, double heading) {
    const Pose pose{number, heading};
    const auto found = known_.find(pose);
    if (found != known_.end()) return found->second;
    if (known_.size() >= limit) known_.clear();
    return known_.emplace(pose, form.extents(heading)).first->second;
  }

 private:
  static constexpr std::size_t limit = 1 << 16;

  struct Pose {
    std::int64_t number;
    double heading;

    friend bool operator==(const Pose&, const Pose&) = default;
  };
  struct PoseHash {
    std::size_t operator()(const Pose& pose) const {
      return std::hash<std::int64_t>()(pose.number) * 0x9e3779b97f4a7c15U ^ std::hash<double>()(pose.heading);
    }
  };

  std::unordered_map<Pose, Extents<3>, PoseHash> known_;
};

}  // namespace foresee
