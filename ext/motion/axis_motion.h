// Motion on one axis.
#pragma once

#include "base/rooms.h"

namespace foresee::motion {

/// As of a reference time. Real: double, or several objects at once (base/doubles.h).
template <class Real>
struct AxisMotion {
  Real x, v, a;
};

}  // namespace foresee::motion
