// Boxes far larger or faster than the rest: which of them cross the stripe at hand?
//
// Giants stay outside the grid, where they would be copied into many stripes. Instead the grid walks through
// its stripes in order and every giant that crosses one is compared with what lies there. Seen from a stripe
// a giant has classes like any box, so each of its pairs is still reported once.
//
// What is large touches most of its boxes already when the horizon begins. So a giant has a core: a box that
// it covers then, rounded inward. What lies in it touches, and nobody needs to ask when.
//
// Requires: stripes are visited along y first, from any of them on. Cost: one step for each stripe that a
// giant crosses; memory follows the number of giants only.
#pragma once

#include <vector>

#include "index/gpcd_grid/stripes.h"

namespace foresee::gpcd {

/// Boxes as columns.
template <int D>
struct Cores {
  std::vector<float> lower[D], upper[D];
};

template <int D>
class Giants {
 public:
  /// Those that did not enter the stripes, which are not needed afterwards.
  Giants(const Partition<D>& partition, const Stripes<D>& stripes, Interrupt& interrupt);

  /// Finds what each giant covers when the horizon begins, rounded inward. Before stripes are visited.
  /// Requires: all that the giants meet are there when the horizon begins.
  void find_cores(const MovingSource<D>& source, const Frame<D>& frame, const Partition<D>& partition);

  /// How many cross each stripe, by its number. Requires: none has been visited.
  std::vector<std::size_t> crossing_counts(const Partition<D>& partition) const;
  /// All giants, sorted along x.
  std::span<const Key> all() const { return sorted_; }
  /// Those that cross a stripe (its numbers along y and z), sorted along x. Valid until the next call.
  std::span<const Key> crossing(const int (&stripe)[D]);
  /// The cores of those, some of them empty; null where no giant has one.
  const Cores<D>* cores() const { return any_core_ ? &cores_ : nullptr; }

 private:
  void advance(int row);
  void add_core(const FloatBox<D>& core);

  struct Place {
    Key key;
    StripeRange y, z;
    FloatBox<D> core;
  };
  std::vector<Key> sorted_;
  std::vector<Place> waiting_;  // by the first stripe along y, the next to come last
  std::vector<Place> active_;   // those that cross the current stripes along y, sorted along x
  std::vector<Key> crossing_;
  Cores<D> cores_;
  bool any_core_ = false;
  int row_ = -1;
};

}  // namespace foresee::gpcd
