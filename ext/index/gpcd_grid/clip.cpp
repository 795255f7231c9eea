#include "index/gpcd_grid/clip.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace foresee::gpcd {
namespace {

constexpr float inf = std::numeric_limits<float>::infinity();

struct Heights {
  float lower = inf, upper = -inf;
};

/// What the boxes cover along one axis; those alone whose class has none of `without`.
template <int D>
Heights heights_of(const LaneView<D>& boxes, int axis, std::uint32_t without) {
  Heights heights;
  for (std::size_t i = 0; i < boxes.size; ++i) {
    const bool counts = (boxes.classes[i] & without) == 0;
    heights.lower = std::min(heights.lower, counts ? boxes.lower[axis][i] : inf);
    heights.upper = std::max(heights.upper, counts ? boxes.upper[axis][i] : -inf);
  }
  return heights;
}

/// A part of the horizon.
struct Part {
  double begin = 0, end = 1;
};

/// A beam on one axis: its middle at half the horizon, how far that moves, and half of what moves.
struct Beam1 {
  double centre, travel, half;

  template <int D>
  Beam1(const LaneView<D>& view, std::size_t i, int axis)
      : centre((static_cast<double>(view.lower[axis][i]) + static_cast<double>(view.upper[axis][i])) / 2),
        travel(static_cast<double>(view.travel[axis][i])),
        half((static_cast<double>(view.upper[axis][i]) - static_cast<double>(view.lower[axis][i]) -
              std::abs(travel)) /
             2) {}

  /// Leaves of `part` when the beam has heights in common. NaN, where travel is too large, leaves all.
  void cut(const Heights& heights, Part& part) const {
    if (travel == 0) return;
    const double low = heights.lower, high = heights.upper;
    const double room = half + 0x1p-30 * (std::abs(low) + std::abs(high) + std::abs(centre) + half);
    const double one = (low - room - centre) / travel + 0.5, other = (high + room - centre) / travel + 0.5;
    part.begin = std::max(part.begin, std::min(one, other) - 0x1p-30);
    part.end = std::min(part.end, std::max(one, other) + 0x1p-30);
  }
};

}  // namespace

template <int D>
void clip(const LaneView<D>& giants, const LaneView<D>& inside, float* from, float* to) {
  constexpr std::size_t kinds = D == 1 ? 1 : D == 2 ? 2 : 4;
  // A giant whose class has a bit is reported with boxes without it.
  Heights heights[kinds][D];
  for (std::size_t kind = 0; kind < kinds; ++kind)
    for (int axis = 1; axis < D; ++axis)
      heights[kind][axis] = heights_of(inside, axis, static_cast<std::uint32_t>(kind));
  for (std::size_t i = 0; i < giants.size; ++i) {
    Part part;
    for (int axis = 1; axis < D; ++axis) Beam1(giants, i, axis).cut(heights[giants.classes[i]][axis], part);
    const Beam1 x(giants, i, 0);
    from[i] = giants.lower[0][i], to[i] = giants.upper[0][i];
    if (part.begin > part.end) from[i] = inf, to[i] = -inf;
    if (!(x.travel < 0 || x.travel > 0) || part.begin > part.end) continue;
    const double first = x.centre + x.travel * (part.begin - 0.5),
                 last = x.centre + x.travel * (part.end - 0.5);
    const double room = x.half + 0x1p-22 * (std::abs(x.centre) + std::abs(x.travel) + x.half);
    const double lower = from[i], upper = to[i];
    from[i] = static_cast<float>(std::clamp(std::min(first, last) - room, lower, upper));
    to[i] = static_cast<float>(std::clamp(std::max(first, last) + room, lower, upper));
  }
}

template void clip(const LaneView<1>&, const LaneView<1>&, float*, float*);
template void clip(const LaneView<2>&, const LaneView<2>&, float*, float*);
template void clip(const LaneView<3>&, const LaneView<3>&, float*, float*);

}  // namespace foresee::gpcd
