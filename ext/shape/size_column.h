// Which columns hold the size of a shape?
#pragma once

#include "shape/layout.h"

namespace foresee {

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
constexpr SizeColumn growth_column{"growth", false, &Offsets::growth, "a growth is negative"};
constexpr SizeColumn growth_z_column{"growth_z", false, &Offsets::growth_z, "a growth is negative"};

/// Of the columns of a layout's shape: whether it is there. Each is, but for outlines and meshes, which say
/// with the number of axes and apart which of them they have, and for what starts as a point.
constexpr bool has_column(const Layout& layout, const SizeColumn& column) {
  if (!is_stored_apart(layout.shape)) return !layout.starts_as_point;
  return column.place == &Offsets::r ? layout.has_radius : layout.axes == 3;
}

}  // namespace foresee
