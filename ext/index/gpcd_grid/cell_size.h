// Cell size of the grid, GPCD step 2: stripes are twice as high as the mean projected interval of the
// objects.
//
//   Partition<2> partition = choose_partition<2>(sample, count);
//   partition.axis[1].index(box.lower[1]);                // the stripe in which a box starts
//
// The mean includes only intervals of at most four times the median, so a few large or fast objects do not
// coarsen the grid for all. The x axis is not cut: a stripe keeps its boxes in order of their lower ends
// along x. There are at most n/8 stripes. The range that is cut omits the farthest hundredths at either end;
// values outside it count into the outermost stripe. So no scene makes the grid large.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "index/gpcd_grid/float_box.h"

namespace foresee::gpcd {

/// A range cut into equal parts. The first and the last part extend to infinity.
struct Cuts {
  float from = 0;
  float per_unit = 1;
  int count = 1;

  /// The number of parts between `from` and x, not clamped.
  float position(float x) const { return (x - from) * per_unit; }
  /// Never decreases as x increases.
  int index(float x) const {
    return static_cast<int>(std::min(std::max(position(x), 0.0f), static_cast<float>(count - 1)));
  }
};

/// The range that holds most values.
struct Range {
  float from = 0, to = 0;

  double length() const { return static_cast<double>(to) - static_cast<double>(from); }
};

template <int D>
struct Partition {
  Range x;                  ///< of the lower ends
  Cuts axis[D];             ///< stripes; x is not cut
  float largest_inside[D];  ///< a box longer than this on any axis is a giant: it is not in the grid

  std::size_t stripes() const {
    std::size_t product = 1;
    for (int k = 1; k < D; ++k) product *= static_cast<std::size_t>(axis[k].count);
    return product;
  }
};

/// Cuts space for `count` boxes like those of `sample`, none of which is empty. The result is correct for any
/// sample; a typical one makes the grid faster.
template <int D>
Partition<D> choose_partition(std::span<const FloatBox<D>> sample, std::size_t count);

}  // namespace foresee::gpcd
