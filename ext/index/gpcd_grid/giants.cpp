#include "index/gpcd_grid/giants.h"

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
  const std::size_t rows = parts(1), across = parts(2);
  std::vector<std::size_t> counts(rows * across);
  const auto add = [&](int y, int z, std::size_t change) {
    const auto row = static_cast<std::size_t>(y), place = static_cast<std::size_t>(z);
    if (row < rows && place < across) counts[row * across + place] += change;
  };
  constexpr std::size_t less = -1;  // unsigned counts wrap around and back
  for (const Place& giant : waiting_) {
    add(giant.y.first, giant.z.first, 1), add(giant.y.last + 1, giant.z.last + 1, 1);
    add(giant.y.last + 1, giant.z.first, less), add(giant.y.first, giant.z.last + 1, less);
  }
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (i % across > 0) counts[i] += counts[i - 1];
  for (std::size_t i = across; i < counts.size(); ++i) counts[i] += counts[i - across];
  return counts;
}

template <int D>
void Giants<D>::advance(int row) {
  row_ = row;
  std::erase_if(active_, [row](const Place& giant) { return giant.y.last < row; });
  const auto old = static_cast<std::ptrdiff_t>(active_.size());
  for (; !waiting_.empty() && waiting_.back().y.first <= row; waiting_.pop_back())
    if (waiting_.back().y.last >= row) active_.push_back(waiting_.back());
  const auto along_x = [](const Place& a, const Place& b) { return a.key < b.key; };
  // Sorted, because a visit that starts at a later stripe adds several rows at once.
  std::sort(active_.begin() + old, active_.end(), along_x);
  std::inplace_merge(active_.begin(), active_.begin() + old, active_.end(), along_x);
}

template <int D>
std::span<const Key> Giants<D>::crossing(const int (&stripe)[D]) {
  const int y = D > 1 ? stripe[D > 1 ? 1 : 0] : 0;
  if (y != row_) advance(y);
  crossing_.clear();
  for (int axis = 0; axis < D; ++axis) cores_.lower[axis].clear(), cores_.upper[axis].clear();
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

template class Giants<1>;
template class Giants<2>;
template class Giants<3>;

}  // namespace foresee::gpcd
