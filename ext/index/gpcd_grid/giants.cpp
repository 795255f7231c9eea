#include "index/gpcd_grid/giants.h"

namespace foresee::gpcd {

template <int D>
Giants<D>::Giants(const Partition<D>& partition, const Stripes<D>& stripes, Interrupt& interrupt) {
  for (std::uint32_t id : stripes.giants()) {
    const FloatBox<D> box = stripes.rows().box(id);
    Place place{key_of(box.lower[0], id), {0, 0}, {0, 0}};
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
void Giants<D>::advance(int row) {
  row_ = row;
  std::erase_if(active_, [row](const Place& giant) { return giant.y.last < row; });
  const auto old = static_cast<std::ptrdiff_t>(active_.size());
  for (; !waiting_.empty() && waiting_.back().y.first <= row; waiting_.pop_back())
    if (waiting_.back().y.last >= row) active_.push_back(waiting_.back());
  const auto along_x = [](const Place& a, const Place& b) { return a.key < b.key; };
  std::sort(active_.begin() + old, active_.end(), along_x);  // a visit that begins later adds several rows'
  std::inplace_merge(active_.begin(), active_.begin() + old, active_.end(), along_x);
}

template <int D>
std::span<const Key> Giants<D>::crossing(const int (&stripe)[D]) {
  const int y = D > 1 ? stripe[D > 1 ? 1 : 0] : 0;
  if (y != row_) advance(y);
  crossing_.clear();
  for (const Place& giant : active_)
    if (D < 3 || (giant.z.first <= stripe[D - 1] && stripe[D - 1] <= giant.z.last))
      crossing_.push_back(giant.key);
  return crossing_;
}

template class Giants<1>;
template class Giants<2>;
template class Giants<3>;

}  // namespace foresee::gpcd
