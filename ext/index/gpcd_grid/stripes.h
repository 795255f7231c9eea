// Which boxes lie in which stripe? GPCD step 3: every box is entered into the stripes that it meets.
//
//   Stripes<2> stripes(partition, rows, memory, interrupt);
//   for (Key key : stripes.entries(7)) …                 // the boxes that meet stripe 7, by lower end in x
//
// A counting sort over (stripe, bucket along x): one pass counts, one pass places. Boxes are replicated
// across stripes only, a handful of times at most, because giants are left out and listed apart. Memory: a
// float box, about 1.5 keys and two counters an object.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "index/gpcd_grid/cell_size.h"
#include "index/gpcd_grid/float_rows.h"

namespace foresee::gpcd {

/// Orders boxes by the lower end along x, then by row number; comparing keys is one integer comparison.
using Key = std::uint64_t;

Key key_of(float lower_x, std::uint32_t id);
inline std::uint32_t id_of(Key key) {
  return static_cast<std::uint32_t>(key);
}

/// Sorts keys that are nearly in order; falls back to a full sort where they are not.
void sort_keys(std::span<Key> keys, Interrupt& interrupt);

/// Stripe numbers of a box on one axis, both ends included.
struct StripeRange {
  int first, last;
};

template <int D>
StripeRange stripe_range(const Partition<D>& partition, const FloatBox<D>& box, int axis) {
  return {partition.axis[axis].index(box.lower[axis]), partition.axis[axis].index(box.upper[axis])};
}

template <int D>
class Stripes {
 public:
  /// Requires: rows.count() < 2^32; rows and memory outlive the stripes. Throws Error if there are more
  /// entries than 2^32.
  Stripes(const Partition<D>& partition, const FloatRows<D>& rows, GridSpace::Side& memory,
          Interrupt& interrupt);

  const FloatRows<D>& rows() const { return rows_; }
  /// Row numbers of the boxes outside the grid.
  const std::vector<std::uint32_t>& giants() const { return giants_; }
  /// The boxes in one stripe, in bucket order; the caller may sort them.
  std::span<Key> entries(std::size_t stripe);
  std::size_t entry_count() const { return entry_count_; }

 private:
  template <class Visit>
  void for_each_cell(const FloatBox<D>& box, Visit visit) const;
  void count(Interrupt& interrupt);
  void place(Interrupt& interrupt);

  Partition<D> partition_;
  const FloatRows<D>& rows_;
  std::vector<std::uint32_t> giants_;
  std::uint32_t* cells_;  // first counts, then where the cell begins in keys_; one more at the end
  Key* keys_ = nullptr;
  std::size_t entry_count_ = 0;
};

}  // namespace foresee::gpcd
