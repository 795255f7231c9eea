// Which boxes lie in which stripe? GPCD step 3: every box is entered into the stripes that it meets.
//
//   Stripes<2> stripes(source, frame, partition, rows, memory, helpers, interrupt);
//   for (Key key : stripes.entries(7)) …                 // the boxes that meet stripe 7, by row number
//
// Each thread reads its part of the objects: rows, entries, and how many entries each stripe gets; then each
// puts its entries behind those of the parts before. So stripes are the same for any number of threads. Boxes
// are replicated a handful of times at most, because giants are left out and listed apart. Memory: a float
// box and about 20 bytes an entry.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "index/gpcd_grid/float_rows.h"
#include "index/gpcd_grid/moving_source.h"
#include "index/gpcd_grid/sort_keys.h"

namespace foresee::gpcd {

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
  /// Enters all objects of the source: each box into every stripe that it meets, or among the giants; empty
  /// ones nowhere. Writes all rows. Requires: source.count() < 2^32; rows and memory outlive the stripes.
  /// Throws Error if there are more entries than 2^32.
  Stripes(const MovingSource<D>& source, const Frame<D>& frame, const Partition<D>& partition,
          FloatRows<D>& rows, GridSpace::Side& memory, std::size_t helpers, Interrupt& interrupt);

  const FloatRows<D>& rows() const { return rows_; }
  /// Row numbers of the boxes outside the grid.
  const std::vector<std::uint32_t>& giants() const { return giants_; }
  /// The boxes in one stripe.
  std::span<const Key> entries(std::size_t stripe) const {
    return {keys_ + begins_[stripe], begins_[stripe + 1] - begins_[stripe]};
  }
  std::size_t entry_count() const { return entry_count_; }

 private:
  /// What one thread has read.
  struct Part {
    Key* keys = nullptr;
    std::uint32_t *stripes = nullptr, *counts = nullptr;
    std::size_t size = 0;
    std::vector<std::uint32_t> giants;
  };

  /// Writes the rows from `begin` to before `end` and collects what they enter, in their order.
  void read(const MovingSource<D>& source, const Frame<D>& frame, std::size_t begin, std::size_t end,
            GridSpace::Part& memory, Part& part, Interrupt& interrupt);
  /// Appends what these lanes enter to the part: one entry for each stripe of a box, or a giant.
  void enter(const FloatLanes<D>& lanes, std::size_t first, std::size_t count, GridSpace::Part& memory,
             Part& part) const;
  /// Gives each stripe its place in keys_, and each part's entries theirs in it, part after part.
  void add_up(std::span<Part> parts);
  /// Puts a part's entries where add_up() says; several threads may do so side by side.
  void place(Part& part, Interrupt& interrupt);

  Partition<D> partition_;
  FloatRows<D>& rows_;
  std::vector<std::uint32_t> giants_;
  std::uint32_t* begins_;  // of each stripe in keys_; one more at the end
  Key* keys_ = nullptr;
  std::size_t entry_count_ = 0;
};

}  // namespace foresee::gpcd
