// Do two outlines come near each other, few pieces of which the boxes around them leave, as plain doubles
// tell? What is surely apart all along, near when the time begins, or near all along needs nothing else.
//
//   const FilterAnswer plain = filter_outlines(path, a, b, pairs, radius, true);
//
// The distance between A and B + d is that of the convex A + (-B) from d; where d moves on a line, that from
// the stretch which it covers. It is enclosed by the algorithm of E. G. Gilbert, D. W. Johnson and S. S.
// Keerthi ("A fast procedure for computing the distance between complex objects in three-dimensional space",
// IEEE J. Robotics and Automation 4, 1988): every point found is one of the set, but for roundings, and every
// direction has the set on one side. The slack is far more than the roundings are. Cost: some hundred
// nanoseconds.
#pragma once

#include <array>

#include "contact/outline/object_pieces.h"
#include "contact/pieces/filter_answer.h"
#include "numbers/bounded.h"

namespace foresee {

/// The way of d.
struct LinearPath {
  Corner begin, end;
  double slack;  ///< bounds how far off these are
  double bend;   ///< and how far d may be from their chord
};

/// A pair of pieces, and whether it may be near when the time begins.
struct BoxedPair {
  std::size_t a, b;
  bool may_touch_at_start;
};

/// `pairs`: no others come near. `radius`: how near counts as touching. `times_wanted`: more is asked than
/// whether they touch.
FilterAnswer filter_outlines(const LinearPath& path, const ObjectPieces& a, const ObjectPieces& b,
                             std::span<const BoxedPair> pairs, const Bounded& radius, bool times_wanted);

}  // namespace foresee
