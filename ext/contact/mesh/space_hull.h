// Which planes bound the places of d at which two pieces in space touch? These places are the Minkowski sum
// A + (-B) of two convex pieces.
//
//   SpaceHull hull(a, b);
//   hull.for_each([&](const SpacePlanes& planes) { return keep(planes); });       // false: no more
//
// Each plane is square to an axis that is a normal of one piece or square to an edge of each (S. Gottschalk,
// M. C. Lin, D. Manocha, "OBBTree", SIGGRAPH 1996, section 5); where all of the sum lies in one plane, it is
// bounded there by planes square to that along the edges. Which corners a plane goes through is decided by
// exact signs, so that all number types mean the same planes. Cost: some hundred nanoseconds.
#pragma once

#include "contact/mesh/space_condition.h"

namespace foresee {

/// Both planes that touch the sum and are square to an axis.
struct SpacePlanes {
  SpaceCondition before, beyond;  ///< the axis points from the first to the second
  Components<Bounded> direction;  ///< of the axis
  bool is_flat;                   ///< they are one: all of the sum lies in it
};

/// Whether the runs are parallel, exactly.
bool are_parallel(const Run& u, const Run& v);

/// The pieces must outlive it.
class SpaceHull {
 public:
  SpaceHull(const SpacePiece& a, const SpacePiece& b) : a_(a), b_(b) {}

  /// Each is made when it comes, as few are needed where the two pass each other. Of two triangles only those
  /// across the axes wanted: normals, then edges of A with edges of B, and all that lie in one plane.
  template <class Take>
  void for_each(Take&& take, unsigned axes = ~0U) const {
    if (a_.is_box() && b_.is_box()) return static_cast<void>(across_box(a_, take));
    bool is_flat = false;
    int axis = 0;
    const auto is_wanted = [&] { return (axes >> axis++ & 1) != 0; };
    for (const SpacePiece* piece : {&a_, &b_}) {
      if (!is_wanted()) continue;
      if (piece->is_box() ? !piece->is_point() && !across_box(*piece, take)
                          : !across(normal_of(*piece), take, &is_flat))
        return;
    }
    if (a_.is_point() || b_.is_point()) return along(a_.is_point() ? b_ : a_, take);
    for (const Run& u : a_.runs())
      for (const Run& v : b_.runs())
        if (is_wanted() && !across({.factors = 2, .u = u, .v = v}, take)) return;
    if (is_flat && !a_.is_box() && !b_.is_box()) along(a_, take);
  }

 private:
  static SpaceAxis normal_of(const SpacePiece& triangle) {
    return {.factors = 2, .u = triangle.runs()[0], .v = triangle.runs()[1]};
  }

  /// The planes square to an axis. Whether more are wanted, as from all of these.
  template <class Take>
  bool across(const SpaceAxis& axis, Take&& take, bool* is_flat = nullptr) const {
    SpacePlanes planes;
    if (!make(axis, planes)) return true;
    if (is_flat) *is_flat |= planes.is_flat;
    return take(planes);
  }
  template <class Take>
  bool across_box(const SpacePiece& box, Take&& take) const {
    for (const Run& run : box.runs())
      if (!across({.factors = 1, .u = run}, take)) return false;
    return true;
  }
  /// Square to the plane of a triangle, along each edge that lies in it.
  template <class Take>
  void along(const SpacePiece& triangle, Take&& take) const {
    const SpaceAxis normal = normal_of(triangle);
    for (const SpacePiece* piece : {&a_, &b_}) {
      if (piece->is_box()) continue;
      for (const Run& run : piece->runs())
        if (!across({.factors = 3, .u = normal.u, .v = normal.v, .w = run}, take)) return;
    }
  }

  /// Whether there are such planes: not where the axis is 0.
  bool make(const SpaceAxis& axis, SpacePlanes& planes) const;

  const SpacePiece &a_, &b_;
};

}  // namespace foresee
