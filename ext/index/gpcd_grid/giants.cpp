#include "index/gpcd_grid/giants.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace foresee::gpcd {
namespace {

/// True if boxes of the usual size fit into a core.
template <int D>
bool has_room(const FloatBox<D>& core, const Partition<D>& partition) {
  constexpr float usual = 0.25f;  // about twice the mean extent
  for (int axis = 0; axis < D; ++axis)
    if (!(core.extent(axis) > partition.largest_inside[axis] * usual)) return false;
  return true;
}

}  // namespace

template <int D>
Giants<D>::Giants(const Partition<D>& partition, const Stripes<D>& stripes, Interrupt& interrupt) {
  for (std::uint32_t id : stripes.giants()) {
    const FloatBox<D> box = stripes.rows().box(id);
    Place place{key_of(box.lower[0], id), {0, 0}, {0, 0}, FloatBox<D>::empty()};
    if constexpr (D > 1) place.y = stripe_range(partition, box, 1);
    if constexpr (D > 2) place.z = stripe_range(partition, box, 2);
    waiting_.push_back(place);
    sorted_.push_back(place.key);
  }
  sort_keys(sorted_, interrupt);
  std::sort(waiting_.begin(), waiting_.end(), [](const Place& a, const Place& b) {
    return a.y.first != b.y.first ? a.y.first > b.y.first : a.key > b.key;
  });
}

template <int D>
void Giants<D>::find_cores(const MovingSource<D>& source, const FloatFrame<D>& frame,
                           const Partition<D>& partition) {
  for (Place& place : waiting_) {
    const FloatBox<D> core = round_inward(source.core(id_of(place.key)), frame);
    if (!has_room(core, partition)) continue;
    place.core = core;
    any_core_ = true;
  }
}

/// Two-dimensional prefix sums: each giant adds 1 at its first stripe and subtracts it behind its last one,
/// along both axes.
template <int D>
std::vector<std::size_t> Giants<D>::crossing_counts(const Partition<D>& partition) const {
  const auto parts = [&partition](int axis) {
    return D > axis ? static_cast<std::size_t>(partition.axis[std::min(axis, D - 1)].count) : 1;
  };
  const std::size_t along = parts(1), across = parts(2);
  std::vector<std::size_t> counts(along * across);
  const auto add = [&](int y, int z, std::size_t change) {
    const auto at_y = static_cast<std::size_t>(y), at_z = static_cast<std::size_t>(z);
    if (at_y < along && at_z < across) counts[at_y * across + at_z] += change;
  };
  constexpr std::size_t less = -1;  // unsigned counts wrap around and back
  for (const Place& giant : waiting_) {
    add(giant.y.first, giant.z.first, 1);
    add(giant.y.last + 1, giant.z.last + 1, 1);
    add(giant.y.last + 1, giant.z.first, less);
    add(giant.y.first, giant.z.last + 1, less);
  }
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (i % across > 0) counts[i] += counts[i - 1];
  for (std::size_t i = across; i < counts.size(); ++i) counts[i] += counts[i - across];
  return counts;
}

template <int D>
void Giants<D>::advance(int y) {
  stripe_y_ = y;
  std::erase_if(active_, [y](const Place& giant) { return giant.y.last < y; });
  const auto old = static_cast<std::ptrdiff_t>(active_.size());
  for (; !waiting_.empty() && waiting_.back().y.first <= y; waiting_.pop_back())
    if (waiting_.back().y.last >= y) active_.push_back(waiting_.back());
  const auto by_x = [](const Place& a, const Place& b) { return a.key < b.key; };
  // Sorted, because a visit that starts at a later stripe adds those of several stripes at once.
  std::sort(active_.begin() + old, active_.end(), by_x);
  std::inplace_merge(active_.begin(), active_.begin() + old, active_.end(), by_x);
}

template <int D>
std::span<const Key> Giants<D>::crossing(const int (&stripe)[D]) {
  const int y = D > 1 ? stripe[D > 1 ? 1 : 0] : 0;
  if (y != stripe_y_) advance(y);
  crossing_.clear();
  for (int axis = 0; axis < D; ++axis) {
    cores_.lower[axis].clear();
    cores_.upper[axis].clear();
  }
  for (const Place& giant : active_) {
    if (D == 3 && (stripe[D - 1] < giant.z.first || giant.z.last < stripe[D - 1])) continue;
    crossing_.push_back(giant.key);
    if (any_core_) add_core(giant.core);
  }
  return crossing_;
}

template <int D>
void Giants<D>::add_core(const FloatBox<D>& core) {
  for (int axis = 0; axis < D; ++axis) {
    cores_.lower[axis].push_back(core.lower[axis]);
    cores_.upper[axis].push_back(core.upper[axis]);
  }
}

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

template class Giants<1>;
template class Giants<2>;
template class Giants<3>;

}  // namespace foresee::gpcd
