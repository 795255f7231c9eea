// How something moves over the ground.
#pragma once

#include <optional>

#include "geography/geodesic.h"

namespace foresee {

struct Course {
  double speed;    ///< metres per second
  double degrees;  ///< clockwise from north
};

/// A report of a ship: where, and how it moves if that is known.
struct Fix {
  LatLon place;
  std::optional<Course> course;
};

}  // namespace foresee
