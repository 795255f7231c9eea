// Boxes of one stripe, gathered for a scan: one contiguous array per coordinate, sorted by the lower end
// along x.
//
// `classes` removes duplicates without a set (two-layer partitioning). Bit 0 is set if a box starts in an
// earlier stripe along y, bit 1 along z. A pair is reported in a stripe if no bit is set in both boxes. That
// holds in exactly one of the stripes that both meet: the one that holds the larger of the lower ends.
// Sentinels that start at infinity follow the last box, so a scan needs no bounds check.
#pragma once

#include <cstdint>
#include <span>

#include "index/gpcd_grid/giants.h"
#include "index/gpcd_grid/scan.h"
#include "index/gpcd_grid/stripes.h"

namespace foresee::gpcd {

template <int D>
class Lanes {
 public:
  explicit Lanes(GridSpace::Visit::Lanes& memory) : memory_(memory) {}

  /// Sorts the boxes of one stripe (its numbers along y and z), then gathers and classifies them.
  void sort_and_gather(std::span<const Key> keys, const FloatRows<D>& rows, const Partition<D>& partition,
                       const int (&stripe)[D], Interrupt& interrupt);
  /// The same for boxes that are already sorted.
  void gather(std::span<const Key> keys, const FloatRows<D>& rows, const Partition<D>& partition,
              const int (&stripe)[D], Interrupt& interrupt);
  /// The same without a stripe: all classes are 0.
  void gather(std::span<const Key> keys, const FloatRows<D>& rows, Interrupt& interrupt);

  /// Sets the core of each box; null: no cores.
  void set_cores(const Cores<D>* cores);

  /// Limits each box to the part along x in which it can meet the boxes `inside` (clip() in giants.h).
  void clip_to(const LaneView<D>& inside);

  /// Valid until the next gather().
  const LaneView<D>& view() const { return view_; }

 private:
  /// Fills the columns of category and mask, if the rows have kinds.
  void copy_kinds(const Kinds* kinds);
  /// Fills the columns from the rows of `ids_`, of `width` floats each.
  template <int width>
  void copy_rows(const FloatRows<D>& rows, Interrupt& interrupt);
  /// Allocates the columns for `count` boxes and points the view to them.
  void lay_out(std::size_t count, Columns columns);
  /// Computes the centres and extents that the time test needs, once and not in every step.
  void find_movers();
  /// Computes the classes of the boxes relative to this stripe.
  void classify(const Partition<D>& partition, const int (&stripe)[D]);

  GridSpace::Visit::Lanes& memory_;
  LaneView<D> view_;
  float* floats_ = nullptr;
  float* movers_ = nullptr;  // after the copied columns
  std::uint32_t* classes_ = nullptr;
  std::uint32_t* ids_ = nullptr;
  std::size_t room_ = 0;  // the number of lanes in a column
};

}  // namespace foresee::gpcd
