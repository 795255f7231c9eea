// Giants, the boxes far larger or faster than the rest, and the stripes that each of them crosses.
//
// Giants are not entered into the grid, which would copy them into many stripes. Instead the grid visits its
// stripes in order and compares every giant that crosses a stripe with the boxes in it. A giant has classes
// relative to a stripe, like any box, so each of its pairs is still reported once.
//
// A large box touches most of its neighbours already at the start of the horizon. So a giant has a core: a
// box, rounded inward, that it covers at that time. Every box inside the core touches the giant, without an
// exact test.
//
// Requires: stripes are visited along y first, from any stripe on. Cost: one step per stripe and giant that
// crosses it; memory is linear in the number of giants.
#pragma once

#include <vector>

#include "index/gpcd_grid/scan.h"
#include "index/gpcd_grid/stripes.h"

namespace foresee::gpcd {

/// Boxes in columns.
template <int D>
struct Cores {
  std::vector<float> lower[D], upper[D];
};

template <int D>
class Giants {
 public:
  /// Collects the boxes that did not enter the stripes. `stripes` is not needed afterwards.
  Giants(const Partition<D>& partition, const Stripes<D>& stripes, Interrupt& interrupt);

  /// Computes the core of each giant, before the first stripe is visited. Requires: all objects that the
  /// giants meet exist at the start of the horizon.
  void find_cores(const MovingSource<D>& source, const FloatFrame<D>& frame, const Partition<D>& partition);

  /// The number of giants that cross each stripe, by stripe number. Requires: no stripe has been visited.
  std::vector<std::size_t> crossing_counts(const Partition<D>& partition) const;
  /// All giants, sorted along x.
  std::span<const Key> all() const { return sorted_; }
  /// The giants that cross a stripe (its numbers along y and z), sorted along x. Valid until the next call.
  std::span<const Key> crossing(const int (&stripe)[D]);
  /// The cores of those giants, some of them empty; null if no giant has a core.
  const Cores<D>* cores() const { return any_core_ ? &cores_ : nullptr; }

 private:
  /// Moves to the stripes with this number along y.
  void advance(int y);
  void add_core(const FloatBox<D>& core);

  struct Place {
    Key key;
    StripeRange y, z;
    FloatBox<D> core;
  };
  std::vector<Key> sorted_;
  std::vector<Place> waiting_;  // in descending order of the first stripe along y
  std::vector<Place> active_;   // those that cross the current stripes along y, sorted along x
  std::vector<Key> crossing_;
  Cores<D> cores_;
  bool any_core_ = false;
  int stripe_y_ = -1;
};

/// The part of the x axis in which each giant can meet the boxes of a stripe; `from` and `to` get giants.size numbers.
///
/// A fast object sweeps a box over half of the scene, but it is in one stripe for a short time only, and
/// therefore in a short part along x. The boxes of the stripe have heights; the giant's beam (shape/beam.h)
/// has those heights for a part of the horizon only. A scan compares the giant only with boxes near its x
/// during that part. Boxes that a giant can meet start before `to` and end after `from`; if there are
/// no such boxes, from > to.
///
/// Rounding: y is padded by 2^-30 of all numbers in it, the part of the horizon by 2^-30, and x by 2^-22
/// before it becomes float. All is computed in double from the beams' floats, which are padded for their own
/// rounding (float_lanes.kernel.cpp). Requires: columns of travel, but not of life. Cost: some ten nanoseconds
/// per giant and axis.
template <int D>
void clip(const LaneView<D>& giants, const LaneView<D>& inside, float* from, float* to);

}  // namespace foresee::gpcd
