#include "index/gpcd_grid/float_box.h"

#include <vector>

#include "shape/beam.h"

namespace foresee::gpcd {
namespace {

constexpr std::size_t enough = 64;  // the number of beams that suffices to find where most objects are

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The typical distance from the origin; if most objects are at one place, the largest distance or extent.
double typical_distance(std::vector<double>& distances, double largest) {
  const double typical = median(distances);
  if (typical > 0) return typical;
  return largest > 0 ? largest : 1;
}

}  // namespace

template <int D>
FloatFrame<D> frame_of(std::span<const Beam<D>> sample) {
  FloatFrame<D> frame;
  const std::size_t step = std::max<std::size_t>(1, sample.size() / enough);
  for (int axis = 0; axis < D; ++axis) {
    std::vector<double> centres, distances;
    double largest = 0;
    for (std::size_t i = 0; i < sample.size(); i += step) {
      const Box<D>& box = sample[i].box;
      const double half = box.upper[axis] * 0.5 - box.lower[axis] * 0.5;
      if (box.is_empty() || !std::isfinite(half)) continue;
      centres.push_back(box.lower[axis] + half);
      largest = std::max(largest, half);
    }
    frame.scale[axis] = 1;
    frame.scaled_origin[axis] = 0;
    if (centres.empty()) continue;

    const double origin = median(centres);
    for (double centre : centres) distances.push_back(std::abs(centre * 0.5 - origin * 0.5));
    largest = std::max(largest, *std::max_element(distances.begin(), distances.end()));
    int exponent = -std::ilogb(typical_distance(distances, largest));
    // Neither the scale nor the scaled origin may overflow.
    exponent = std::min(exponent, origin == 0 ? 1000 : std::min(1000, 1000 - std::ilogb(origin)));
    frame.scale[axis] = std::ldexp(1.0, exponent);
    frame.scaled_origin[axis] = origin * frame.scale[axis];
  }
  return frame;
}

template FloatFrame<1> frame_of(std::span<const Beam<1>>);
template FloatFrame<2> frame_of(std::span<const Beam<2>>);
template FloatFrame<3> frame_of(std::span<const Beam<3>>);

}  // namespace foresee::gpcd
