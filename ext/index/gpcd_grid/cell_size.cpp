#include "index/gpcd_grid/cell_size.h"

#include <cmath>
#include <vector>

namespace foresee::gpcd {
namespace {

constexpr double stripe_height = 2;       // in mean extents: flat optimum between 1.5 and 3
constexpr double part_of_x = 0.5;         // in mean extents: the unit of "long along x"
constexpr double giant_extent = 8;        // in mean extents: flat between 3 and 32
constexpr std::size_t giants_max = 4096;  // visiting the stripes of more costs more than coarser cells
constexpr double parts_max = 1 << 20;     // on one axis; a float still distinguishes them

double at_rank(std::vector<float>& values, double rank) {
  const auto place = static_cast<std::ptrdiff_t>(rank * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + place, values.end());
  return values[static_cast<std::size_t>(place)];
}

/// The mean over the extents that are at most four times the median.
template <int D>
double typical_extent(std::span<const FloatBox<D>> sample, int axis) {
  std::vector<float> extents;
  for (const FloatBox<D>& box : sample) extents.push_back(box.extent(axis));
  const double limit = 4 * at_rank(extents, 0.5);
  double sum = 0, counted = 0;
  for (float extent : extents)
    if (extent <= limit) {
      sum += extent;
      ++counted;
    }
  return counted > 0 ? std::min(sum / counted, limit) : limit;
}

/// The range of the lower ends: of the whole sample, but at most a quarter of the length of its middle 98 %
/// beyond that middle.
template <int D>
Range middle_range(std::span<const FloatBox<D>> sample, int axis) {
  std::vector<float> ends;
  for (const FloatBox<D>& box : sample) ends.push_back(box.lower[axis]);
  const double low = at_rank(ends, 0.01), high = at_rank(ends, 0.99), margin = (high - low) / 4;
  const auto [first, last] = std::minmax_element(ends.begin(), ends.end());
  return {static_cast<float>(std::max<double>(*first, low - margin)),
          static_cast<float>(std::min<double>(*last, high + margin))};
}

/// Doubles the mean extents until the sample has few giants.
template <int D>
void coarsen_until_few_giants(std::span<const FloatBox<D>> sample, std::size_t count, double (&mean)[D]) {
  const double allowed = static_cast<double>(giants_max) / static_cast<double>(std::max(count, giants_max));
  for (int round = 0; round < 64; ++round) {
    std::size_t giants = 0;
    for (const FloatBox<D>& box : sample) {
      bool giant = false;
      for (int axis = 0; axis < D; ++axis) giant |= box.extent(axis) > giant_extent * mean[axis];
      giants += giant;
    }
    if (static_cast<double>(giants) <= allowed * static_cast<double>(sample.size())) return;
    for (double& m : mean) m *= 2;
  }
}

double parts(double length, double width, double limit) {
  const double wished = width > 0 ? std::ceil(length / width) : length > 0 ? limit : 1;
  return std::clamp(wished, 1.0, std::max(1.0, std::min(limit, parts_max)));
}

Cuts cuts_of(const Range& range, double count) {
  const double per_unit = range.length() > 0 ? count / range.length() : 1;
  const double largest = std::numeric_limits<float>::max();
  return {static_cast<float>(range.from), static_cast<float>(std::clamp(per_unit, 0x1p-126, largest)),
          static_cast<int>(count)};
}

}  // namespace

template <int D>
Partition<D> choose_partition(std::span<const FloatBox<D>> sample, std::size_t count) {
  Partition<D> partition;
  std::fill_n(partition.largest_inside, D, std::numeric_limits<float>::max());
  if (sample.empty()) return partition;

  double mean[D], wished[D];
  Range range[D];
  for (int axis = 0; axis < D; ++axis) {
    mean[axis] = typical_extent(sample, axis);
    range[axis] = middle_range(sample, axis);
  }
  coarsen_until_few_giants(sample, count, mean);

  const double stripes_max = std::max(1.0, static_cast<double>(count) / 8);
  double stripes = 1;
  for (int axis = 1; axis < D; ++axis) {
    wished[axis] = parts(range[axis].length(), stripe_height * mean[axis], stripes_max);
    stripes *= wished[axis];
  }
  if (D == 3 && stripes > stripes_max) {
    const double shrink = std::sqrt(stripes / stripes_max);
    double& fewer = wished[1] < wished[D - 1] ? wished[1] : wished[D - 1];
    double& more = wished[1] < wished[D - 1] ? wished[D - 1] : wished[1];
    fewer = std::max(1.0, std::floor(fewer / shrink));
    more = std::min(more, std::max(1.0, std::floor(stripes_max / fewer)));
    stripes = fewer * more;
  }
  const double parts_of_x_max = 2 * static_cast<double>(count) / stripes;
  wished[0] = parts(range[0].length(), part_of_x * mean[0], parts_of_x_max);

  partition.x = range[0];
  for (int axis = 0; axis < D; ++axis) {
    const Cuts cuts = cuts_of(range[axis], wished[axis]);
    if (axis > 0) partition.axis[axis] = cuts;
    // A box that fits into a few parts is not a giant, however small the mean is.
    const double size = axis == 0 ? part_of_x : stripe_height;
    const double few_parts = giant_extent / size / cuts.per_unit;
    partition.largest_inside[axis] = static_cast<float>(
        std::min<double>(std::max(giant_extent * mean[axis], few_parts), std::numeric_limits<float>::max()));
  }
  return partition;
}

template Partition<1> choose_partition(std::span<const FloatBox<1>>, std::size_t);
template Partition<2> choose_partition(std::span<const FloatBox<2>>, std::size_t);
template Partition<3> choose_partition(std::span<const FloatBox<3>>, std::size_t);

}  // namespace foresee::gpcd
