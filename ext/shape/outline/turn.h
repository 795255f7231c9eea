// Where does an outline lie that is turned? Each coordinate is the exact real one, rounded once.
//
//   Outline as_it_lies = turned(hull, 37.5);         // degrees clockwise from the y axis
//
// x' = x cos h + y sin h, y' = y cos h - x sin h, each the nearest double, ties to even: the same on every
// machine, which sin() and cos() of the C library are not.
#pragma once

#include "shape/outline/outline.h"

namespace foresee::shape {

/// Requires: -360 <= heading <= 360.
Outline turned(const Outline& outline, double heading);

}  // namespace foresee::shape
