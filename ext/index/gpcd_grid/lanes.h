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
  explicit Lanes(GridSpace::Visit::LaneMemory& memory) : memory_(memory) {}

  /// Replaces the lanes by the rows of these keys, in their order, and by the columns that a scan computes with.
  /// All classes are 0: the boxes belong to no stripe. Requires: the keys are sorted along x.
  void gather(std::span<const Key> keys, const FloatRows<D>& rows, Interrupt& interrupt);
  /// gather() for boxes of one stripe, given by its numbers along y and z: with their classes.
  void gather_of_stripe(std::span<const Key> keys, const FloatRows<D>& rows, const Partition<D>& partition,
                        const int (&stripe)[D], Interrupt& interrupt);
  /// gather_of_stripe() for keys in any order.
  void sort_and_gather_of_stripe(std::span<const Key> keys, const FloatRows<D>& rows,
                                 const Partition<D>& partition, const int (&stripe)[D], Interrupt& interrupt);

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
  void find_centres();
  /// Computes the classes of the boxes relative to this stripe.
  void classify(const Partition<D>& partition, const int (&stripe)[D]);

  GridSpace::Visit::LaneMemory& memory_;
  LaneView<D> view_;
  float* floats_ = nullptr;
  float* centres_ = nullptr;  // and extents; after the copied columns
  std::uint32_t* classes_ = nullptr;
  std::uint32_t* ids_ = nullptr;
  std::size_t room_ = 0;  // the number of lanes in a column
};

}  // namespace foresee::gpcd
