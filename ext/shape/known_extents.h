// The boxes of forms as they lie, for whoever asks about row after row: a form and heading that was just
// asked about is not turned again.
//
//   KnownExtents known;
//   known.of(3, *hull, 37.5)              // as hull->extents(37.5); throws as that does
//
// Requires: a number always means the same form. Memory: some megabytes at most.
#pragma once

#include <cstdint>
#include <functional>
#include <unordered_map>

#include "shape/form.h"

namespace foresee {

class KnownExtents {
 public:
  const Extents<3>& of(std::int64_t number, const Form& form, double heading) {
    const Lie lie{number, heading};
    const auto found = known_.find(lie);
    if (found != known_.end()) return found->second;
    if (known_.size() >= most) known_.clear();
    return known_.emplace(lie, form.extents(heading)).first->second;
  }

 private:
  static constexpr std::size_t most = 1 << 16;

  struct Lie {
    std::int64_t number;
    double heading;

    friend bool operator==(const Lie&, const Lie&) = default;
  };
  struct HashOfLie {
    std::size_t operator()(const Lie& lie) const {
      return std::hash<std::int64_t>()(lie.number) * 0x9e3779b97f4a7c15U ^ std::hash<double>()(lie.heading);
    }
  };

  std::unordered_map<Lie, Extents<3>, HashOfLie> known_;
};

}  // namespace foresee
