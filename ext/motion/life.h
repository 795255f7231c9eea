// What swept boxes and beams share: when an object exists during the horizon, and bounds rounded outward.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/bodies.h"

namespace foresee {

/// When an object exists during the horizon, as time since its own t.
struct Life {
  double begin, end;
  double reach;  ///< no moment of the horizon is farther from the object's own t
  bool none;
};

inline Life life_of(double t, double until, const Horizon& horizon) {
  const double since = horizon.now - t;
  Life life;
  life.begin = std::max(since, 0.0);
  life.end = std::min(since + horizon.h, until - t);
  life.reach = std::abs(since) + horizon.h;
  // Rounding keeps order: if t - now, rounded, exceeds the double h, then so does the exact difference.
  life.none = t - horizon.now > horizon.h || until < horizon.now;
  return life;
}

struct Ends {
  double lower, upper;
};

/// [lower - grow, upper + grow], rounded outward; infinite where no double holds it.
inline Ends grown(double lower, double upper, double grow) {
  constexpr double u = 0x1p-53, inf = std::numeric_limits<double>::infinity();
  const double g = grow + 8 * u * grow;
  const double low = lower - g, high = upper + g;
  const double safe_low = low - (4 * u * std::abs(low) + 0x1p-1022);
  const double safe_high = high + (4 * u * std::abs(high) + 0x1p-1022);
  const bool sound = std::isfinite(lower) && std::isfinite(upper) && std::isfinite(g);
  return {sound && std::isfinite(safe_low) ? safe_low : -inf,
          sound && std::isfinite(safe_high) ? safe_high : inf};
}

}  // namespace foresee
