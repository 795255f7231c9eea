// How fine should the grid be? GPCD step 2: cells follow the mean projected interval of the objects.
//
//   Partition<2> partition = choose_partition<2>(sample, count);
//   partition.axis[1].index(box.lower[1]);                // the stripe in which a box begins
//
// The mean is taken over intervals of at most four times the median, so that a few large or fast objects do
// not coarsen the grid for all. A stripe is twice as high as the mean; x is not cut, as stripes are kept in
// order of the lower ends along it. There are at most n/8 stripes, and the range that is cut covers all but
// the farthest hundredths at either end: what lies outside counts into the outermost stripe. So no scene
// makes the grid large.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "index/gpcd_grid/float_box.h"

namespace foresee::gpcd {

/// A range cut into equal parts. The first and the last reach to infinity.
struct Cuts {
  float from = 0;
  float per_unit = 1;
  int count = 1;

  /// How many parts lie between `from` and x, unclamped.
  float position(float x) const { return (x - from) * per_unit; }
  /// Never decreases with x.
  int index(float x) const {
    return static_cast<int>(std::min(std::max(position(x), 0.0f), static_cast<float>(count - 1)));
  }
};

/// Where most values lie.
struct Range {
  float from = 0, to = 0;

  double length() const { return static_cast<double>(to) - static_cast<double>(from); }
};

template <int D>
struct Partition {
  Range x;                  ///< of lower ends
  Cuts axis[D];             ///< stripes; x is not cut
  float largest_inside[D];  ///< a box longer than this on any axis stays outside the grid

  std::size_t stripes() const {
    std::size_t product = 1;
    for (int k = 1; k < D; ++k) product *= static_cast<std::size_t>(axis[k].count);
    return product;
  }
};

/// How to cut space for `count` boxes like those of `sample`, none of which is empty. Any partition is right,
/// a good one is faster.
template <int D>
Partition<D> choose_partition(std::span<const FloatBox<D>> sample, std::size_t count);

}  // namespace foresee::gpcd
