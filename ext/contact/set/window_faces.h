// A moving window: a closed box that may be open to any side.
//
//   WindowFaces faces;                                           // nothing bounds it
//   faces.lower[0] = 0, faces.upper[0] = 100, faces.velocity[0] = 1;
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace foresee {

/// Where the faces are at `now`, as many as there are axes. Requires: lower < +infinity, upper > -infinity,
/// lower <= upper; velocity finite.
struct WindowFaces {
  std::array<double, 3> lower{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  std::array<double, 3> upper{HUGE_VAL, HUGE_VAL, HUGE_VAL};
  std::array<double, 3> velocity{};

  bool has_lower(int axis) const { return std::isfinite(lower[static_cast<std::size_t>(axis)]); }
  bool has_upper(int axis) const { return std::isfinite(upper[static_cast<std::size_t>(axis)]); }
  /// From where the contact room measures along an axis: a finite face, if there is one.
  double reference(int axis) const {
    const auto j = static_cast<std::size_t>(axis);
    return has_lower(axis) ? lower[j] : has_upper(axis) ? upper[j] : 0;
  }
};

}  // namespace foresee
