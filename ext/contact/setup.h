// Setup of a contact test, the input of all its stages; and the common lifetime of a pair. A setup has two tables,
// or a moving window and a table; the horizon; and the rule of their distance.
//
//   const PairLifetime lifetime = pair_lifetime_of(setup, row_a, row_b);
//   if (!lifetime.none) use(lifetime.start(), lifetime.end());
//
// A setup is made once per statement (make_contact.cpp). A lifetime is exact, each of its numbers rounded once.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "contact/pair_rule.h"
#include "numbers/crossed_root.h"
#include "shape/bodies.h"

namespace foresee {

/// A moving window: a closed box that may be open to any side. The positions of its faces at `now`, one pair
/// per axis of the tables. Requires: lower < +infinity, upper > -infinity, lower <= upper; velocity finite.
struct WindowFaces {
  std::array<double, 3> lower{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  std::array<double, 3> upper{HUGE_VAL, HUGE_VAL, HUGE_VAL};
  std::array<double, 3> velocity{};

  bool has_lower(int axis) const { return std::isfinite(lower[static_cast<std::size_t>(axis)]); }
  bool has_upper(int axis) const { return std::isfinite(upper[static_cast<std::size_t>(axis)]); }
  /// The origin of coordinates along an axis: a finite face if one exists, else 0.
  double reference(int axis) const {
    const auto j = static_cast<std::size_t>(axis);
    return has_lower(axis) ? lower[j] : has_upper(axis) ? upper[j] : 0;
  }
};

/// The inputs of contact: two tables, the horizon and the rule of their distance. If the first table is a
/// window, then `window` has its faces.
struct Setup {
  Bodies a, b;
  Horizon horizon;
  PairRule rule = {};
  const WindowFaces* window = nullptr;
};

/// When both objects exist within the horizon, measured from now and absolute; each rounded once.
struct PairLifetime {
  double dt_start, dt_end;
  double t_start, t_end;
  bool start_exact, end_exact;  ///< dt_start, dt_end are the exact values
  bool ends_with_horizon;       ///< the end is now + h, not that of an object
  bool none;                    ///< the two objects never exist together during the horizon

  Instant start() const { return {dt_start, t_start}; }
  Instant end() const { return {dt_end, t_end}; }
};

/// The lifetime of a pair. `none` is decided exactly.
inline PairLifetime pair_lifetime_of(const Setup& setup, const double* row_a, const double* row_b) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  const double now = setup.horizon.now, h = setup.horizon.h;
  const double start = std::max({now, value_or(row_a, setup.a.at.t, 0), value_or(row_b, setup.b.at.t, 0)});
  const double stop =
      std::min(value_or(row_a, setup.a.at.until, inf), value_or(row_b, setup.b.at.until, inf));
  const DoubleDouble begin = difference(start, now);
  PairLifetime lifetime{begin.high, h, start, now + h, begin.low == 0, true, true, false};
  lifetime.none = start > stop || begin.high > h || (begin.high == h && begin.low > 0);
  if (stop < inf) {
    const DoubleDouble end = difference(stop, now);
    if (end.high < h || (end.high == h && end.low < 0)) {
      lifetime.dt_end = end.high;
      lifetime.t_end = stop;
      lifetime.end_exact = end.low == 0;
      lifetime.ends_with_horizon = false;
    }
  }
  return lifetime;
}

}  // namespace foresee
