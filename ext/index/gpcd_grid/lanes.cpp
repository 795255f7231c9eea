#include "index/gpcd_grid/lanes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "index/gpcd_grid/scan.h"

namespace foresee::gpcd {

namespace {

constexpr std::size_t boxes_per_check = 8192;
constexpr std::size_t ahead = 12;  // rows are scattered in memory: prefetch them this many ahead

}  // namespace

template <int D>
void Lanes<D>::copy_kinds(const Kinds* kinds) {
  view_.categories = view_.masks = nullptr;
  if (!kinds) return;
  std::uint32_t* const categories = memory_.kinds.room(2 * room_);
  std::uint32_t* const masks = categories + room_;
  for (std::size_t i = 0; i < view_.size; ++i)
    categories[i] = kinds[ids_[i]].category, masks[i] = kinds[ids_[i]].mask;
  std::fill_n(categories + view_.size, room_ - view_.size, 0);
  std::fill_n(masks + view_.size, room_ - view_.size, 0);
  view_.categories = categories, view_.masks = masks;
}

// One block holds all columns, one column for each place in a row. A cache line of sentinels follows each
// column.
template <int D>
void Lanes<D>::lay_out(std::size_t count, Columns columns) {
  constexpr std::size_t line = 16;
  room_ = (count + lanes_max + line - 1) / line * line;
  const auto width = static_cast<std::size_t>(FloatRows<D>::width(columns));
  floats_ = memory_.floats.room(room_ * (width + (columns.travel ? 2 * D : 0)));
  centres_ = floats_ + room_ * width;
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
  for (int k = 0; k < D; ++k) {
    view_.centre[k] = columns.travel ? next() : nullptr;
    view_.extent[k] = columns.travel ? next() : nullptr;
  }
  view_.from = view_.to = nullptr;
}

// Transposes four rows by four columns at a time.
template <int D>
template <int width>
void Lanes<D>::copy_rows(const FloatRows<D>& rows, Interrupt& interrupt) {
  using Four = float __attribute__((vector_size(16)));
  const auto load = [](const float* from) {
    Four four;
    __builtin_memcpy(&four, from, sizeof four);
    return four;
  };
  const std::size_t whole = view_.size / 4 * 4;
  for (std::size_t i = 0; i < whole; i += 4) {
    if (i % boxes_per_check == boxes_per_check - 4) interrupt.check();
    for (std::size_t later = i + ahead; later < std::min(i + ahead + 4, view_.size); ++later)
      __builtin_prefetch(rows.row(ids_[later]));
    const float* row[4];
    for (std::size_t j = 0; j < 4; ++j) row[j] = rows.row(ids_[i + j]);
    float* place = floats_ + i;
    for (int k = 0; k + 4 <= width; k += 4) {
      const Four a = load(row[0] + k), b = load(row[1] + k), c = load(row[2] + k), d = load(row[3] + k);
      const Four ab = __builtin_shufflevector(a, b, 0, 4, 1, 5),
                 cd = __builtin_shufflevector(c, d, 0, 4, 1, 5);
      const Four ba = __builtin_shufflevector(a, b, 2, 6, 3, 7),
                 dc = __builtin_shufflevector(c, d, 2, 6, 3, 7);
      for (const Four& column :
           {__builtin_shufflevector(ab, cd, 0, 1, 4, 5), __builtin_shufflevector(ab, cd, 2, 3, 6, 7),
            __builtin_shufflevector(ba, dc, 0, 1, 4, 5), __builtin_shufflevector(ba, dc, 2, 3, 6, 7)}) {
        __builtin_memcpy(place, &column, sizeof column);
        place += room_;
      }
    }
    for (int k = width / 4 * 4; k < width; ++k, place += room_)
      for (std::size_t j = 0; j < 4; ++j) place[j] = row[j][k];
  }
  for (std::size_t i = whole; i < view_.size; ++i)
    for (int k = 0; k < width; ++k) floats_[i + static_cast<std::size_t>(k) * room_] = rows.row(ids_[i])[k];
}

template <int D>
void Lanes<D>::find_centres() {
  float* column = centres_;
  for (int k = 0; k < D; ++k, column += 2 * room_) {
    float *centre = column, *extent = column + room_;
    const float *lower = view_.lower[k], *upper = view_.upper[k], *travel = view_.travel[k];
    for (std::size_t i = 0; i < view_.size; ++i) {
      const float middle = view_.begin ? (view_.begin[i] + view_.end[i]) * 0.5f : 0;
      const float part = view_.begin ? (view_.end[i] - view_.begin[i]) * 0.5f : 1;
      centre[i] = lower[i] + upper[i] - travel[i] * middle;
      extent[i] = upper[i] - lower[i] - std::abs(travel[i]) * part;
    }
  }
}

template <int D>
void Lanes<D>::gather(std::span<const Key> keys, const FloatRows<D>& rows, Interrupt& interrupt) {
  lay_out(keys.size(), rows.columns());
  view_.objects = rows.objects();
  for (std::size_t i = 0; i < keys.size(); ++i) ids_[i] = id_of(keys[i]);
  std::fill_n(classes_, keys.size(), 0);
  std::fill_n(classes_ + keys.size(), room_ - keys.size(), sentinel);
  copy_kinds(rows.kinds());
  if (rows.columns().life)
    copy_rows<3 * D + 2>(rows, interrupt);
  else if (rows.columns().travel)
    copy_rows<3 * D>(rows, interrupt);
  else
    copy_rows<2 * D>(rows, interrupt);
  if (rows.columns().travel) find_centres();
  for (float* column : {floats_, floats_ + D * room_})  // lower and upper ends along x
    std::fill_n(column + keys.size(), room_ - keys.size(), std::numeric_limits<float>::infinity());
  // Four accumulators, so that no step waits for the previous one. A sentinel's length is NaN.
  float longest[4] = {};
  for (std::size_t i = 0; i < keys.size(); i += 4)
    for (std::size_t j = 0; j < 4; ++j)
      longest[j] = std::max(longest[j], view_.upper[0][i + j] - view_.lower[0][i + j]);
  view_.longest =
      static_cast<double>(*std::max_element(std::begin(longest), std::end(longest))) * (1 + 0x1p-20);
}

template <int D>
void Lanes<D>::gather_of_stripe(std::span<const Key> keys, const FloatRows<D>& rows,
                                const Partition<D>& partition, const int (&stripe)[D], Interrupt& interrupt) {
  gather(keys, rows, interrupt);
  classify(partition, stripe);
}

template <int D>
void Lanes<D>::sort_and_gather_of_stripe(std::span<const Key> keys, const FloatRows<D>& rows,
                                         const Partition<D>& partition, const int (&stripe)[D],
                                         Interrupt& interrupt) {
  gather_of_stripe(sorted_along_x(keys, partition.x, memory_, interrupt), rows, partition, stripe, interrupt);
}

template <int D>
void Lanes<D>::set_cores(const Cores<D>* cores) {
  for (int axis = 0; axis < D; ++axis) {
    view_.core_lower[axis] = cores ? cores->lower[axis].data() : nullptr;
    view_.core_upper[axis] = cores ? cores->upper[axis].data() : nullptr;
  }
}

template <int D>
void Lanes<D>::clip_to(const LaneView<D>& inside) {
  if (D == 1 || !view_.travel[0] || view_.begin || view_.size == 0) return;
  float* from = memory_.reach.room(2 * view_.size);
  float* to = from + view_.size;
  clip(view_, inside, from, to);
  view_.from = from, view_.to = to;
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
