// Filter in plain doubles for two outlines of few nearby pieces: surely apart, surely touching at the
// start of the time, or surely touching throughout.
//
//   const FilterAnswer plain = filter_outlines(path, a, b, pairs, radius, true);
//
// The distance between A and B + d is the distance of d from the convex set A + (-B). If d moves on a line,
// the filter takes the distance of the covered segment. GJK encloses that distance (E. G. Gilbert, D. W.
// Johnson and S. S. Keerthi, "A fast procedure for computing the distance between complex objects in
// three-dimensional space", IEEE J. Robotics and Automation 4, 1988). Up to rounding, each point found is a
// point of the set, and each direction has the set on one side. The slack is far larger than the rounding
// errors. Cost: some hundred nanoseconds.
#pragma once

#include <array>

#include "contact/certified/pair_context.h"
#include "contact/outline/object_pieces.h"
#include "numbers/bounded.h"

namespace foresee {

/// The path of d, near a line segment.
struct LinearPath {
  Corner begin, end;
  double slack;  ///< upper bound on the error of both
  double bend;   ///< upper bound on the distance of d from the segment
};

/// A pair of pieces, and whether it may touch when the time starts.
struct BoxedPair {
  std::size_t a, b;
  bool may_touch_at_start;
};

/// `pairs`: all pairs of pieces that may touch. `radius`: the contact distance. `times_wanted`: the query
/// wants more than whether they touch.
FilterAnswer filter_outlines(const LinearPath& path, const ObjectPieces& a, const ObjectPieces& b,
                             std::span<const BoxedPair> pairs, const Bounded& radius, bool times_wanted);

}  // namespace foresee
