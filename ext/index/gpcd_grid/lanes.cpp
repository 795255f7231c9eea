#include "index/gpcd_grid/lanes.h"

#include <limits>
#include <utility>

namespace foresee::gpcd {
namespace {

constexpr std::size_t boxes_per_check = 8192;
constexpr std::size_t ahead = 12;  // rows lie anywhere in memory: ask for them early

}  // namespace

/// A column for each place in a row, all in one block; a cache line's worth of sentinels behind each.
template <int D>
void Lanes<D>::make_room(std::size_t count, Columns columns) {
  constexpr std::size_t line = 16;
  room_ = (count + lanes_max + line - 1) / line * line;
  const auto width = static_cast<std::size_t>(FloatRows<D>::width(columns));
  floats_ = memory_.floats.room(room_ * width);
  classes_ = memory_.words.room(2 * room_);
  ids_ = classes_ + room_;
  view_.size = count;
  view_.classes = classes_;
  view_.ids = ids_;
  const float* column = floats_;
  auto next = [&] { return std::exchange(column, column + room_); };
  for (const float*& lower : view_.lower) lower = next();
  for (const float*& upper : view_.upper) upper = next();
  for (const float*& travel : view_.travel) travel = columns.travel ? next() : nullptr;
  view_.begin = columns.life ? next() : nullptr;
  view_.end = columns.life ? next() : nullptr;
}

template <int D>
void Lanes<D>::gather(std::span<const Key> keys, const FloatRows<D>& rows, Interrupt& interrupt) {
  const std::size_t size = keys.size();
  make_room(size, rows.columns());
  const int width = FloatRows<D>::width(rows.columns());
  float extent = 0;
  for (std::size_t i = 0; i < size; ++i) {
    if (i % boxes_per_check == boxes_per_check - 1) interrupt.check();
    if (i + ahead < size) __builtin_prefetch(rows.row(id_of(keys[i + ahead])));
    const std::uint32_t id = id_of(keys[i]);
    const float* row = rows.row(id);
    ids_[i] = id;
    classes_[i] = 0;
    float* place = floats_ + i;
    for (int k = 0; k < width; ++k, place += room_) *place = row[k];
    extent = std::max(extent, row[D] - row[0]);
  }
  view_.longest = static_cast<double>(extent) * (1 + 0x1p-20);
  std::fill_n(floats_ + size, room_ - size, std::numeric_limits<float>::infinity());
}

template <int D>
void Lanes<D>::sort_and_gather(std::span<const Key> keys, const FloatRows<D>& rows,
                               const Partition<D>& partition, const int (&stripe)[D], Interrupt& interrupt) {
  gather(along_x(keys, partition.x, memory_, interrupt), rows, partition, stripe, interrupt);
}

template <int D>
void Lanes<D>::gather(std::span<const Key> keys, const FloatRows<D>& rows, const Partition<D>& partition,
                      const int (&stripe)[D], Interrupt& interrupt) {
  gather(keys, rows, interrupt);
  classify(partition, stripe);
}

template <int D>
void Lanes<D>::classify(const Partition<D>& partition, const int (&stripe)[D]) {
  for (int axis = 1; axis < D; ++axis) {
    if (stripe[axis] == 0) continue;
    const auto here = static_cast<float>(stripe[axis]);
    const std::uint32_t bit = axis == 1 ? 1 : 2;
    for (std::size_t i = 0; i < view_.size; ++i)
      classes_[i] |= partition.axis[axis].position(view_.lower[axis][i]) < here ? bit : 0;
  }
}

template class Lanes<1>;
template class Lanes<2>;
template class Lanes<3>;

}  // namespace foresee::gpcd
