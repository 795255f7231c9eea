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
#include <vector>

#include "index/gpcd_grid/stripes.h"

namespace foresee::gpcd {

/// How many boxes one step of a scan looks at.
inline constexpr std::size_t lanes_per_step = 8;

template <int D>
struct Lanes {
  std::vector<float> lower[D], upper[D];
  std::vector<std::uint32_t> classes, ids;
  std::size_t size = 0;
  double longest = 0;  ///< no box is longer along x; rounded up

  /// Takes the boxes of `keys`, in that order, as they are seen from one stripe (its numbers along y and z).
  void gather(std::span<const Key> keys, const std::vector<FloatBox<D>>& boxes, const Partition<D>& partition,
              const int (&stripe)[D], Interrupt& interrupt);
  /// The same without stripes: every pair counts.
  void gather(std::span<const Key> keys, const std::vector<FloatBox<D>>& boxes, Interrupt& interrupt);

 private:
  void classify(const Partition<D>& partition, const int (&stripe)[D]);
};

}  // namespace foresee::gpcd
