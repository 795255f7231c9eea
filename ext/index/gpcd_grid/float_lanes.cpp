#include "index/gpcd_grid/float_lanes.h"

#include <algorithm>
#include <cmath>

#include "shape/beam.h"

namespace foresee::gpcd {

template <int D>
std::vector<FloatBox<D>> boxes_of(std::span<const Beam<D>> beams, const FloatFrame<D>& frame,
                                  Columns columns) {
  std::vector<FloatBox<D>> boxes;
  const FloatKernels<D>& kernels = float_kernels<D>();
  BeamLanes<D> lanes;
  FloatLanes<D> rounded;
  for (std::size_t first = 0; first < beams.size(); first += lanes.width) {
    const std::size_t count = std::min(lanes.width, beams.size() - first);
    for (std::size_t l = 0; l < count; ++l) put(beams[first + l], lanes, l);
    kernels.round_outward(lanes, count, frame, columns, rounded);
    for (std::size_t l = 0; l < count; ++l) boxes.push_back(rounded.box(l));
  }
  return boxes;
}

template <int D>
FloatBox<D> round_inward(const Box<D>& box, const FloatFrame<D>& frame) {
  FloatBox<D> out;
  for (int axis = 0; axis < D; ++axis) {
    const double scale = frame.scale[axis], origin = frame.scaled_origin[axis];
    const double lower = box.lower[axis] * scale - origin, upper = box.upper[axis] * scale - origin;
    const double size = std::max(std::abs(lower), std::abs(upper)), room = size * 0x1p-18 + 0x1p-40;
    if (!(size < too_large && lower + room < upper - room)) return FloatBox<D>::empty();
    out.lower[axis] = static_cast<float>(lower + room), out.upper[axis] = static_cast<float>(upper - room);
  }
  return out;
}

#define FORESEE_OF_AXES(D)                                                                             \
  template std::vector<FloatBox<D>> boxes_of(std::span<const Beam<D>>, const FloatFrame<D>&, Columns); \
  template FloatBox<D> round_inward(const Box<D>&, const FloatFrame<D>&)
FORESEE_OF_AXES(1);
FORESEE_OF_AXES(2);
FORESEE_OF_AXES(3);
#undef FORESEE_OF_AXES

}  // namespace foresee::gpcd
