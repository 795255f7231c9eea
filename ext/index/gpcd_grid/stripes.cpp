#include "index/gpcd_grid/stripes.h"

#include <bit>

namespace foresee::gpcd {
namespace {

constexpr std::size_t objects_per_check = 8192;

/// The bits of x as an integer that grows with x.
std::uint32_t ordered_bits(float x) {
  const auto bits = std::bit_cast<std::uint32_t>(x);
  return bits ^ (static_cast<std::uint32_t>(-static_cast<std::int32_t>(bits >> 31)) | 0x80000000u);
}

/// std::sort that can be stopped; used for keys without order only, so the price of counting is small.
void full_sort(std::span<Key> keys, Interrupt& interrupt) {
  std::size_t comparisons = 0;
  std::sort(keys.begin(), keys.end(), [&](Key a, Key b) {
    if (++comparisons % (std::size_t{1} << 18) == 0) interrupt.check();
    return a < b;
  });
}

}  // namespace

Key key_of(float lower_x, std::uint32_t id) {
  return static_cast<Key>(ordered_bits(lower_x)) << 32 | id;
}

void sort_keys(std::span<Key> keys, Interrupt& interrupt) {
  std::size_t moves_left = 16 * keys.size();
  for (std::size_t i = 1; i < keys.size(); ++i) {
    const Key key = keys[i];
    std::size_t place = i;
    for (; place > 0 && keys[place - 1] > key; --place) keys[place] = keys[place - 1];
    keys[place] = key;
    if (i - place > moves_left) return full_sort(keys, interrupt);
    moves_left -= i - place;
  }
}

template <int D>
Stripes<D>::Stripes(const Partition<D>& partition, const FloatRows<D>& rows, GridSpace::Side& memory,
                    Interrupt& interrupt)
    : partition_(partition), rows_(rows) {
  const std::size_t cells = partition.stripes() * partition.buckets() + 1;
  cells_ = memory.cells.room(cells);
  std::fill_n(cells_, cells, 0);
  count(interrupt);
  keys_ = memory.keys.room(entry_count_);
  place(interrupt);
}

template <int D>
template <class Visit>
void Stripes<D>::for_each_cell(const FloatBox<D>& box, Visit visit) const {
  const auto buckets = partition_.buckets();
  const auto bucket = static_cast<std::size_t>(partition_.axis[0].index(box.lower[0]));
  if constexpr (D == 1) {
    visit(bucket);
  } else if constexpr (D == 2) {
    const StripeRange y = stripe_range(partition_, box, 1);
    for (int j = y.first; j <= y.last; ++j) visit(static_cast<std::size_t>(j) * buckets + bucket);
  } else {
    const StripeRange y = stripe_range(partition_, box, 1), z = stripe_range(partition_, box, 2);
    const auto across = static_cast<std::size_t>(partition_.axis[2].count);
    for (int j = y.first; j <= y.last; ++j)
      for (int k = z.first; k <= z.last; ++k)
        visit((static_cast<std::size_t>(j) * across + static_cast<std::size_t>(k)) * buckets + bucket);
  }
}

template <int D>
void Stripes<D>::count(Interrupt& interrupt) {
  for (std::size_t i = 0; i < rows_.count(); ++i) {
    if (i % objects_per_check == 0) interrupt.check();
    const FloatBox<D> box = rows_.box(i);
    if (box.is_empty()) continue;
    if (partition_.is_giant(box)) {
      giants_.push_back(static_cast<std::uint32_t>(i));
      continue;
    }
    for_each_cell(box, [this](std::size_t cell) { ++cells_[cell]; });
  }
  const std::size_t cells = partition_.stripes() * partition_.buckets() + 1;
  for (std::size_t i = 0; i < cells; ++i) cells_[i] = static_cast<std::uint32_t>(entry_count_ += cells_[i]);
  if (entry_count_ > std::numeric_limits<std::uint32_t>::max()) throw Error("too many objects for one grid");
}

template <int D>
void Stripes<D>::place(Interrupt& interrupt) {
  for (std::size_t i = rows_.count(); i-- > 0;) {
    if (i % objects_per_check == 0) interrupt.check();
    const FloatBox<D> box = rows_.box(i);
    if (box.is_empty() || partition_.is_giant(box)) continue;
    const Key key = key_of(box.lower[0], static_cast<std::uint32_t>(i));
    for_each_cell(box, [this, key](std::size_t cell) { keys_[--cells_[cell]] = key; });
  }
}

template <int D>
std::span<Key> Stripes<D>::entries(std::size_t stripe) {
  const std::size_t begin = cells_[stripe * partition_.buckets()];
  const std::size_t end = cells_[(stripe + 1) * partition_.buckets()];
  return {keys_ + begin, end - begin};
}

template class Stripes<1>;
template class Stripes<2>;
template class Stripes<3>;

}  // namespace foresee::gpcd
