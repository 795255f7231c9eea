// Motion on one axis.
#pragma once

namespace foresee {

/// As of a reference time. Real: double, or several objects at once (base/doubles.h).
template <class Real>
struct AxisMotion {
  Real x, v, a;
};

}  // namespace foresee
