// Which columns hold the size of a shape?
#pragma once

#include "shape/layout.h"

namespace foresee::shape {

/// One quantity of a shape's size: "r", or "h" on every axis for hx, hy, hz.
struct SizeColumn {
  const char* name;
  bool on_all_axes;
  int Offsets::*place;        ///< where its numbers stand in a record or row
  const char* when_negative;  ///< what is wrong with a stored number below 0
};

constexpr SizeColumn half_extent_columns{"h", true, &Offsets::half, "a half extent is negative"};
constexpr SizeColumn half_height_column{"hz", false, &Offsets::hz, "a half extent is negative"};
constexpr SizeColumn radius_column{"r", false, &Offsets::r, "a radius is negative"};

}  // namespace foresee::shape
