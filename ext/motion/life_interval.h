// The part of a horizon during which an object exists.
#pragma once

#include <algorithm>
#include <cmath>

#include "motion/motion.h"

namespace foresee {

/// The intersection of an object's [t, until] with the horizon, as time since t.
struct LifeInterval {
  double begin, end;
  double reach;  ///< upper bound of the distance in time between the object's t and any time of the horizon
  bool none;
};

inline LifeInterval life_of(double t, double until, const Horizon& horizon) {
  const double since = horizon.now - t;
  LifeInterval life;
  life.begin = std::max(since, 0.0);
  life.end = std::min(since + horizon.h, until - t);
  life.reach = std::abs(since) + horizon.h;
  // Rounding keeps order: if t - now, rounded, exceeds the double h, then so does the exact difference.
  life.none = t - horizon.now > horizon.h || until < horizon.now;
  return life;
}

}  // namespace foresee
