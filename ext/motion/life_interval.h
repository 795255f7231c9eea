// When does an object exist during the horizon?
#pragma once

#include <algorithm>
#include <cmath>

#include "motion/motion.h"

namespace foresee {

/// When an object exists during the horizon, as time since its own t.
struct LifeInterval {
  double begin, end;
  double reach;  ///< no moment of the horizon is farther from the object's own t
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
