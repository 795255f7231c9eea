// An outline of its own, flat, or the upright prism over it of half height hz; with r it is grown on all
// sides in x and y. What has no outline is what its other columns say: a point, a disc, or an upright
// cylinder.
//
// A row knows the number of its outline and the smallest box around it as it lies (outline/turn.h), so that
// who only needs boxes looks no outline up.
#pragma once

#include "shape/size_column.h"
#include "shape/stored_bounds.h"

namespace foresee {

struct OutlineShape {
  static constexpr Shape shape = Shape::outline;
  static constexpr SizeColumn sizes[] = {radius_column, half_height_column};

  template <int D>
  static Extents<D> extents(const double* numbers, const Offsets& at) {
    Extents<D> around = extents_of_bounds<D, 2>(numbers, at);
    if constexpr (D == 3) around.lower[2] = -numbers[at.hz], around.upper[2] = numbers[at.hz];
    return around;
  }
  /// None: what lies within the box may lie in a hole.
  template <int D>
  static Extents<D> core(const double* /*numbers*/, const Offsets& /*at*/) {
    return no_extents<D>();
  }
};

}  // namespace foresee
