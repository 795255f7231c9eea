// One stripe, ready to be scanned: its boxes as contiguous arrays, one per coordinate, sorted by the lower
// end along x.
//
// `classes` removes duplicates without a set (two-layer rule): bit 0 says that a box begins in an earlier
// stripe along y, bit 1 along z. A pair is reported where neither bit is set in both, which is exactly one of
// the stripes that both meet: the one that holds the larger of the lower ends. Behind the last box stand
// sentinels that begin at infinity, so a scan needs no bound but its own.
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

  /// Sorts the boxes of one stripe (its numbers along y and z), then takes them as they are seen from it.
  void sort_and_gather(std::span<const Key> keys, const FloatRows<D>& rows, const Partition<D>& partition,
                       const int (&stripe)[D], Interrupt& interrupt);
  /// The same for boxes that are in order.
  void gather(std::span<const Key> keys, const FloatRows<D>& rows, const Partition<D>& partition,
              const int (&stripe)[D], Interrupt& interrupt);
  /// The same without a stripe: every pair counts.
  void gather(std::span<const Key> keys, const FloatRows<D>& rows, Interrupt& interrupt);

  /// Tells of each box what it covers; null: nothing.
  void take(const Cores<D>* cores);

  /// Leaves to each box only that part along x where it can meet those `inside` (lanes.cpp).
  void clip_to(const LaneView<D>& inside);

  /// Valid until the next gather().
  const LaneView<D>& view() const { return view_; }

 private:
  /// Fills the columns from the rows of `ids_`, each of so many floats.
  template <int width>
  void copy_rows(const FloatRows<D>& rows, Interrupt& interrupt);
  /// Makes room for so many boxes; the view has their number and its columns.
  void lay_out(std::size_t count, Columns columns);
  /// Fills in centre and extent, which the test of time needs, once and not in every step.
  void find_movers();
  /// Fills in the classes of boxes that are seen from this stripe.
  void classify(const Partition<D>& partition, const int (&stripe)[D]);

  GridSpace::Visit::Lanes& memory_;
  LaneView<D> view_;
  float* floats_ = nullptr;
  float* movers_ = nullptr;  // behind the columns that are copied
  std::uint32_t* classes_ = nullptr;
  std::uint32_t* ids_ = nullptr;
  std::size_t room_ = 0;  // lanes in a column
};

}  // namespace foresee::gpcd
