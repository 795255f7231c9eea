// One other object, as an object sees it that is about to change its motion: from the moment and the place of
// the change.
//
//   const Encounter<2> encounter = encounter_of<2>(base, {now, h}, others, row,
//                                           rule.pair<2>(own_row, row, base.t));
//   if (encounter.begin > encounter.end) …                             // never there together
//
// At tau seconds after the change the other is at x + v tau + a tau^2 / 2, each number within its error.
// Positions are differenced in double-double before anything is rounded, so that neither old reports nor
// places far from the origin cost digits. Cost: some tens of nanoseconds.
#pragma once

#include "contact/clearance/pair_extents.h"
#include "motion/manoeuvre.h"
#include "shape/bodies.h"

namespace foresee {

template <int D>
struct Encounter {
  Vec<D> x, v, a;
  Vec<D> ex, ev;              ///< errors; a is exact
  GrowingExtents<D> extents;  ///< as of the change
  double begin, end;          ///< both exist within the horizon, in seconds after the change, rounded outward
  double inflation = 0;       ///< of some changes the set reaches so much farther, or less far …
  double rotation_chord = 0;  ///< … as it is turned by this, in lengths of what turns
  double square_gap = 0;  ///< of discs and balls beside: their distance squared less reach squared, at least
  bool beside = false;    ///< apart at the change by exact contact, so near that doubles may not tell

  bool bends() const { return (a != 0).any(); }
};

/// `base`: the motion that is changed, as of the change. Of what doubles do not hold, numbers are not finite.
template <int D>
Encounter<D> encounter_of(const OwnMotion& base, const Horizon& horizon, const Bodies& others,
                          const double* row, const GrowingExtents<D>& extents);

}  // namespace foresee
