// Where is d when two pieces in space are at most R from each other and do not overlap? The parts of their
// Minkowski sum grown by R: what is near a face as seen from a corner, near an edge as seen from an edge or a
// corner, and near a corner as seen from a corner.
//
//   RoundParts(a, b).for_each([](const RoundPart& part) { …; return true; });    // false: no more
//
// Two pieces that do not overlap are nearest to each other at two of these (C. Ericson, "Real-Time Collision
// Detection", 2005, section 5.1.10), and each part lies within R of where they touch: so all parts and the
// sum itself are all of it. What triangles share is asked of one of them (shape/mesh/triangle_tree.h).
#pragma once

#include "contact/mesh/space_condition.h"

namespace foresee {

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

/// Both planes that touch the sum and are square to an axis.
struct SpacePlanes {
  SpaceCondition before, beyond;  ///< the axis points from the first to the second
  Components<Bounded> direction;  ///< of the axis
  bool is_flat;                   ///< they are one: all of the sum lies in it
};

/// Whether the runs are parallel, exactly.
bool are_parallel(const EdgeVector& u, const EdgeVector& v);

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
    for (const EdgeVector& u : a_.edge_vectors())
      for (const EdgeVector& v : b_.edge_vectors())
        if (is_wanted() && !across({.factors = 2, .u = u, .v = v}, take)) return;
    if (is_flat && !a_.is_box() && !b_.is_box()) along(a_, take);
  }

 private:
  static SpaceAxis normal_of(const SpacePiece& triangle) {
    return {.factors = 2, .u = triangle.edge_vectors()[0], .v = triangle.edge_vectors()[1]};
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
    for (const EdgeVector& run : box.edge_vectors())
      if (!across({.factors = 1, .u = run}, take)) return false;
    return true;
  }
  /// Square to the plane of a triangle, along each edge that lies in it.
  template <class Take>
  void along(const SpacePiece& triangle, Take&& take) const {
    const SpaceAxis normal = normal_of(triangle);
    for (const SpacePiece* piece : {&a_, &b_}) {
      if (piece->is_box()) continue;
      for (const EdgeVector& run : piece->edge_vectors())
        if (!across({.factors = 3, .u = normal.u, .v = normal.v, .w = run}, take)) return;
    }
  }

  /// Whether there are such planes: not where the axis is 0.
  bool make(const SpaceAxis& axis, SpacePlanes& planes) const;

  const SpacePiece &a_, &b_;
};

struct RoundPart {
  SpaceCondition round;                    ///< a slab, tube or ball
  std::array<SpaceCondition, 4> beside{};  ///< and within these planes
  int count = 0;
};

class RoundParts {
 public:
  RoundParts(const SpacePiece& a, const SpacePiece& b) : a_(a), b_(b) {}

  template <class Take>
  void for_each(Take&& take) const {
    for (const bool of_a : {true, false})
      for (int i = 0; i < other(of_a).corner_count(); ++i)
        if (other(of_a).owns_corner(i) && !at_corner(of_a, other(of_a).corner(i), take)) return;
    for (int i = 0; i < a_.edge_count(); ++i)
      for (int k = 0; a_.owns_edge(i) && k < b_.edge_count(); ++k)
        if (b_.owns_edge(k) && !are_parallel(a_.vector_of_edge(i), b_.vector_of_edge(k)) &&
            !take(edges(i, k)))
          return;
  }

 private:
  using Kind = SpaceCondition::Kind;

  const SpacePiece& one(bool of_a) const { return of_a ? a_ : b_; }
  const SpacePiece& other(bool of_a) const { return of_a ? b_ : a_; }

  /// Faces, edges and corners of one piece as seen from a corner of the other. (Corners once, from B.)
  template <class Take>
  bool at_corner(bool of_a, const SpaceCorner& seen_from, Take&& take) const {
    const SpacePiece& piece = one(of_a);
    const int faces = piece.is_box() ? 6 : 1;
    for (int i = 0; i < faces; ++i)
      if (!piece.is_box() || is_face(piece, i))
        if (!take(piece.is_box() ? face_of_box(of_a, i, seen_from) : face_of_triangle(of_a, seen_from)))
          return false;
    for (int i = 0; i < piece.edge_count(); ++i)
      if (piece.owns_edge(i) && !take(edge(of_a, i, seen_from))) return false;
    for (int i = 0; of_a && i < piece.corner_count(); ++i)
      if (piece.owns_corner(i) &&
          !take({.round = condition(of_a, Kind::ball, 1, {.factors = 0}, piece.corner(i), seen_from)}))
        return false;
    return true;
  }

  /// What holds of a place seen from one piece, which is the other's corner: for d.
  static SpaceCondition condition(bool of_a, Kind kind, int sign, const SpaceAxis& axis,
                                  const SpaceCorner& at, const SpaceCorner& seen_from) {
    return of_a ? SpaceCondition{kind, sign, axis, &at, &seen_from}
                : SpaceCondition{kind, -sign, axis, &seen_from, &at};
  }
  static void add(RoundPart& part, const SpaceCondition& plane) {
    part.beside[static_cast<std::size_t>(part.count++)] = plane;
  }

  RoundPart face_of_triangle(bool of_a, const SpaceCorner& seen_from) const;
  RoundPart face_of_box(bool of_a, int i, const SpaceCorner& seen_from) const;
  RoundPart edge(bool of_a, int i, const SpaceCorner& seen_from) const;
  RoundPart edges(int i, int k) const;

  /// Faces 0 to 2 are the lower ones across each axis, 3 to 5 the upper: if they are there, and once.
  static bool is_face(const SpacePiece& box, int i) {
    const int bit = 1 << i % 3;
    return (box.flat() & ~bit) == 0 && (i < 3 || box.flat() == 0);
  }

  const SpacePiece &a_, &b_;
};

}  // namespace foresee
