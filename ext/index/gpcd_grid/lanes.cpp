#include "index/gpcd_grid/lanes.h"

namespace foresee::gpcd {
namespace {

constexpr std::size_t boxes_per_check = 8192;

}  // namespace

template <int D>
void Lanes<D>::gather(std::span<const Key> keys, const std::vector<FloatBox<D>>& boxes,
                      Interrupt& interrupt) {
  size = keys.size();
  if (ids.size() < size + lanes_per_step) {
    const std::size_t room = size + size / 2 + lanes_per_step;
    for (int axis = 0; axis < D; ++axis) lower[axis].resize(room), upper[axis].resize(room);
    classes.resize(room), ids.resize(room);
  }
  float extent = 0;
  for (std::size_t i = 0; i < size; ++i) {
    if (i % boxes_per_check == boxes_per_check - 1) interrupt.check();
    const std::uint32_t id = id_of(keys[i]);
    const FloatBox<D>& box = boxes[id];
    ids[i] = id;
    classes[i] = 0;
    for (int axis = 0; axis < D; ++axis) lower[axis][i] = box.lower[axis], upper[axis][i] = box.upper[axis];
    extent = std::max(extent, box.extent(0));
  }
  longest = static_cast<double>(extent) * (1 + 0x1p-20);
  std::fill_n(lower[0].begin() + static_cast<std::ptrdiff_t>(size), lanes_per_step,
              std::numeric_limits<float>::infinity());
}

template <int D>
void Lanes<D>::gather(std::span<const Key> keys, const std::vector<FloatBox<D>>& boxes,
                      const Partition<D>& partition, const int (&stripe)[D], Interrupt& interrupt) {
  gather(keys, boxes, interrupt);
  classify(partition, stripe);
}

template <int D>
void Lanes<D>::classify(const Partition<D>& partition, const int (&stripe)[D]) {
  for (int axis = 1; axis < D; ++axis) {
    if (stripe[axis] == 0) continue;
    const auto here = static_cast<float>(stripe[axis]);
    const std::uint32_t bit = axis == 1 ? 1 : 2;
    for (std::size_t i = 0; i < size; ++i)
      classes[i] |= partition.axis[axis].position(lower[axis][i]) < here ? bit : 0;
  }
}

template struct Lanes<1>;
template struct Lanes<2>;
template struct Lanes<3>;

}  // namespace foresee::gpcd
