// The loops for the CPU that the build asks for, and the choice of wider ones.
#include "index/gpcd_grid/float_lanes.h"

#include "base/simd.h"
#include "index/gpcd_grid/float_lanes_kernel.h"
#include "shape/beam.h"

namespace foresee::gpcd {

template <int D>
void round_outward(const BeamLanes<D>& beams, std::size_t count, const Frame<D>& frame, Columns columns,
                   FloatLanes<D>& out) {
#if defined(__x86_64__)
  if (simd_in_use() == Simd::avx512) return round_outward_avx512(beams, count, frame, columns, out);
  if (simd_in_use() == Simd::avx2) return round_outward_avx2(beams, count, frame, columns, out);
#endif
  round_outward_here(beams, count, frame, columns, out);
}

template <int D>
void find_stripes(FloatLanes<D>& lanes, std::size_t count, const Partition<D>& partition) {
#if defined(__x86_64__)
  if (simd_in_use() == Simd::avx512) return find_stripes_avx512(lanes, count, partition);
  if (simd_in_use() == Simd::avx2) return find_stripes_avx2(lanes, count, partition);
#endif
  find_stripes_here(lanes, count, partition);
}

template <int D>
std::vector<FloatBox<D>> boxes_of(std::span<const Beam<D>> beams, const Frame<D>& frame, Columns columns) {
  std::vector<FloatBox<D>> boxes;
  BeamLanes<D> lanes;
  FloatLanes<D> rounded;
  for (std::size_t first = 0; first < beams.size(); first += lanes.width) {
    const std::size_t count = std::min(lanes.width, beams.size() - first);
    for (std::size_t l = 0; l < count; ++l) put(beams[first + l], lanes, l);
    round_outward(lanes, count, frame, columns, rounded);
    for (std::size_t l = 0; l < count; ++l) boxes.push_back(rounded.box(l));
  }
  return boxes;
}

template <int D>
FloatBox<D> round_inward(const Box<D>& box, const Frame<D>& frame) {
  FloatBox<D> out;
  for (int axis = 0; axis < D; ++axis) {
    const double scale = frame.scale[axis], origin = frame.scaled_origin[axis];
    const double lower = box.lower[axis] * scale - origin, upper = box.upper[axis] * scale - origin;
    const double size = greatest(size_of(lower), size_of(upper)), room = size * 0x1p-18 + 0x1p-40;
    if (!(size < too_large && lower + room < upper - room)) return FloatBox<D>::empty();
    out.lower[axis] = static_cast<float>(lower + room), out.upper[axis] = static_cast<float>(upper - room);
  }
  return out;
}

#define FORESEE_FLOATS_OF_AXES(D)                                                                          \
  template void round_outward(const BeamLanes<D>&, std::size_t, const Frame<D>&, Columns, FloatLanes<D>&); \
  template std::vector<FloatBox<D>> boxes_of(std::span<const Beam<D>>, const Frame<D>&, Columns);          \
  template FloatBox<D> round_inward(const Box<D>&, const Frame<D>&);                                       \
  template void find_stripes(FloatLanes<D>&, std::size_t, const Partition<D>&)
FORESEE_FLOATS_OF_AXES(1);
FORESEE_FLOATS_OF_AXES(2);
FORESEE_FLOATS_OF_AXES(3);
#undef FORESEE_FLOATS_OF_AXES

}  // namespace foresee::gpcd
