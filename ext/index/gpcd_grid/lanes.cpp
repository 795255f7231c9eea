#include "index/gpcd_grid/lanes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "index/gpcd_grid/scan.h"

namespace foresee::gpcd {

// The part of the x axis in which a giant can meet the boxes of a stripe.
//
//   clip(giants, inside, from, to);        // giants.size numbers each
//
// A fast object sweeps a box over half of the scene, but it is in one stripe for a short time only, and
// therefore in a short part along x. The boxes of the stripe have heights; the giant's beam (shape/beam.h)
// has those heights for a part of the horizon only. A scan compares the giant only with boxes near its x
// during that part. Boxes that a giant can meet start before `to` and end after `from`; if there are
// no such boxes, from > to.
//
// Rounding: y is padded by 2^-30 of all numbers in it, the part of the horizon by 2^-30, and x by 2^-22
// before it becomes float. All is computed in double from the beams' floats, which are padded for their own
// rounding (float_lanes.kernel.cpp). Requires: columns of travel, but not of life. Cost: some ten nanoseconds
// per giant and axis.

template <int D>
void clip(const LaneView<D>& giants, const LaneView<D>& inside, float* from, float* to);

namespace {

constexpr float inf = std::numeric_limits<float>::infinity();

struct Heights {
  float lower = inf, upper = -inf;
};

/// The interval that the boxes cover along one axis, without the boxes whose class has a bit of `without`.
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

/// A beam on one axis: its centre at half the horizon, the distance that this moves, and its half extent.
struct Beam1 {
  double centre, travel, half;

  template <int D>
  Beam1(const LaneView<D>& view, std::size_t i, int axis)
      : centre((static_cast<double>(view.lower[axis][i]) + static_cast<double>(view.upper[axis][i])) / 2),
        travel(static_cast<double>(view.travel[axis][i])),
        half((static_cast<double>(view.upper[axis][i]) - static_cast<double>(view.lower[axis][i]) -
              std::abs(travel)) /
             2) {}

  /// Limits `part` to the time during which the beam overlaps the heights. If travel is NaN (too large), all
  /// of it remains.
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
  // A giant whose class has a bit is reported only with boxes without that bit.
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
  movers_ = floats_ + room_ * width;
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
void Lanes<D>::find_movers() {
  float* column = movers_;
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
  if (rows.columns().travel) find_movers();
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
