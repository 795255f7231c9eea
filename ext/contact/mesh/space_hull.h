// Which planes bound the places of d at which two pieces in space touch? These places are the Minkowski sum
// A + (-B) of two convex pieces.
//
//   SpaceHull hull;
//   for (const SpacePlanes& planes : hull.of(a, b)) keep(planes.before), keep(planes.beyond);
//
// Each plane is square to an axis that is a normal of one piece or square to an edge of each (S. Gottschalk,
// M. C. Lin, D. Manocha, "OBBTree", SIGGRAPH 1996, section 5); where all of the sum lies in one plane, it is
// bounded there by planes square to that along the edges. Which corners a plane goes through is decided by
// exact signs, so that all number types mean the same planes. Cost: some hundred nanoseconds.
#pragma once

#include <span>
#include <vector>

#include "contact/mesh/space_condition.h"

namespace foresee::contact {

/// Both planes that touch the sum and are square to an axis.
struct SpacePlanes {
  SpaceCondition before, beyond;  ///< the axis points from the first to the second
  Components<Bounded> direction;  ///< of the axis
  bool is_flat;                   ///< they are one: all of the sum lies in it
};

/// For one pair of pieces after another.
class SpaceHull {
 public:
  std::span<const SpacePlanes> of(const SpacePiece& a, const SpacePiece& b);

 private:
  void add(const SpaceAxis& axis);
  void add_along(const SpaceAxis& normal, const SpacePiece& piece);

  const SpacePiece *a_ = nullptr, *b_ = nullptr;
  std::vector<SpacePlanes> planes_;
};

/// Whether the runs are parallel, exactly.
bool are_parallel(const Run& u, const Run& v);

}  // namespace foresee::contact
