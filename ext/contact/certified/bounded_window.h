// A window as a bounded box: a face that the window does not have stands farther out than the object can
// come.
//
//   pieces.take_box(bounded_window<2>(setup, row_b));                 // its first two axes
//
// Such a face is at the largest double if the object can come farther: a position that no double holds is
// outside of the window then. Requires: the setup has a window, whose body is at the origin when the horizon
// starts.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/minkowski/relative_motion.h"
#include "motion/axis_aligned_box.h"
#include "shape/shapes.h"

namespace foresee {

template <int D>
Box<D> bounded_window(const Setup& setup, const double* row_b) {
  const WindowFaces& faces = *setup.window;
  const double h = setup.horizon.h;
  const double ago = std::abs(setup.horizon.now - value_or(row_b, setup.b.at.t, 0)) + h;
  const auto extent_of = [&]<int Axes>(int axis) {
    const Shape shape = setup.b.layout.shape;
    return reach_of(extents_of<Axes>(shape, row_b, setup.b.at))[axis] +
           ago * growth_of<Axes>(shape, row_b, setup.b.at)[axis];
  };
  const auto size = [&](int axis) {
    return setup.b.layout.axes == 3 ? extent_of.template operator()<3>(axis)
                                    : extent_of.template operator()<2>(axis);
  };
  Box<D> box;
  for (int axis = 0; axis < D; ++axis) {
    const auto j = static_cast<std::size_t>(axis);
    const AxisMotion<double> b = axis_motion(setup.b, row_b, axis);
    const double distance = std::abs(b.x) + ago * (std::abs(b.v) + ago * std::abs(b.a)) +
                            h * std::abs(faces.velocity[j]) + size(axis) + std::abs(faces.reference(axis));
    constexpr double largest = std::numeric_limits<double>::max();
    const double far = distance == 0            ? 1
                       : 2 * distance < largest ? 2 * distance
                                                : largest;  // also where `distance` is NaN
    box.lower[axis] = faces.has_lower(axis) ? faces.lower[j] : -far;
    box.upper[axis] = faces.has_upper(axis) ? faces.upper[j] : far;
  }
  return box;
}

}  // namespace foresee
