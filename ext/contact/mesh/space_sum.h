// Minkowski sum A + (-B) of two convex pieces in space: the planes that bound it (SpaceHull), and the
// parts of the sum grown by R (RoundParts).
//
//   SpaceHull hull(a, b);
//   hull.for_each([&](const SpacePlanes& planes) { return keep(planes); });       // false: no more
//   RoundParts(a, b).for_each([](const RoundPart& part) { …; return true; });    // false: no more
//
// Two pieces touch while d is in the sum. Each plane is perpendicular to an axis: a normal of one piece,
// or the cross product of an edge of each (S. Gottschalk, M. C. Lin, D. Manocha, "OBBTree", SIGGRAPH 1996,
// section 5). A sum that lies in one plane is also bounded by planes perpendicular to that one, along the
// edges. Exact signs decide which corners a plane goes through, so all number types have the same planes.
// Cost: some hundred nanoseconds.
//
// Two pieces that do not overlap are nearest to each other at two features (C. Ericson, "Real-Time Collision
// Detection", 2005, section 5.1.10). So there is a part for each face and corner, edge and edge, edge and
// corner, and corner and corner. All points of a part are within R of contact, so the sum and all parts
// together are exactly the grown sum. A feature that triangles share belongs to one of them
// (shape/mesh/triangle_tree.h).
#pragma once

#include "contact/mesh/space_constraint.h"

namespace foresee {

/// Both planes that touch the sum and are perpendicular to an axis.
struct SpacePlanes {
  SpaceConstraint before, beyond;  ///< the axis points from the first to the second
  Components<Bounded> direction;   ///< of the axis
  bool is_flat;                    ///< both are the same plane: the sum lies in it
};

/// Whether two edge vectors are exactly parallel.
bool are_parallel(const EdgeVector& u, const EdgeVector& v);

/// The planes that bound the Minkowski sum. The pieces must outlive it.
class SpaceHull {
 public:
  SpaceHull(const SpacePiece& a, const SpacePiece& b) : a_(a), b_(b) {}

  /// Calls `take` for each pair of planes until it returns false. Planes are made one by one, as pieces
  /// that pass each other need few of them. For two triangles, `axes` has a bit for each axis wanted: both
  /// normals, then edges of A with edges of B. The planes of a flat sum always follow.
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

  /// Takes the planes perpendicular to an axis. Like the functions below, it returns whether more are wanted.
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
  /// Takes the planes perpendicular to the plane of a triangle, along each edge in that plane.
  template <class Take>
  void along(const SpacePiece& triangle, Take&& take) const {
    const SpaceAxis normal = normal_of(triangle);
    for (const SpacePiece* piece : {&a_, &b_}) {
      if (piece->is_box()) continue;
      for (const EdgeVector& run : piece->edge_vectors())
        if (!across({.factors = 3, .u = normal.u, .v = normal.v, .w = run}, take)) return;
    }
  }

  /// Makes the planes perpendicular to an axis. False if the axis is 0.
  bool make(const SpaceAxis& axis, SpacePlanes& planes) const;

  const SpacePiece &a_, &b_;
};

/// A part of the grown sum: within one round set, and within some planes.
struct RoundPart {
  SpaceConstraint round;                    ///< a slab, tube or ball
  std::array<SpaceConstraint, 4> beside{};  ///< d is within these planes too
  int count = 0;
};

/// The parts that, together with the sum itself, make up the grown sum. The pieces must outlive it.
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
  using Kind = ConstraintKind;

  const SpacePiece& one(bool of_a) const { return of_a ? a_ : b_; }
  const SpacePiece& other(bool of_a) const { return of_a ? b_ : a_; }

  /// Takes the parts of faces, edges and corners of one piece with a corner of the other. Pairs of corners
  /// are taken once, for a corner of B.
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
          !take({.round = constraint(of_a, Kind::ball, 1, {.factors = 0}, piece.corner(i), seen_from)}))
        return false;
    return true;
  }

  /// The constraint for d, from one on the position of a corner relative to the other piece.
  static SpaceConstraint constraint(bool of_a, Kind kind, int sign, const SpaceAxis& axis,
                                    const SpaceCorner& at, const SpaceCorner& seen_from) {
    return of_a ? SpaceConstraint{kind, sign, {axis, &at, &seen_from}}
                : SpaceConstraint{kind, -sign, {axis, &seen_from, &at}};
  }
  static void add(RoundPart& part, const SpaceConstraint& plane) {
    part.beside[static_cast<std::size_t>(part.count++)] = plane;
  }

  RoundPart face_of_triangle(bool of_a, const SpaceCorner& seen_from) const;
  RoundPart face_of_box(bool of_a, int i, const SpaceCorner& seen_from) const;
  RoundPart edge(bool of_a, int i, const SpaceCorner& seen_from) const;
  RoundPart edges(int i, int k) const;

  /// Faces 0 to 2 are the lower ones across each axis, 3 to 5 the upper. In a box without width some do
  /// not exist or coincide with another.
  static bool is_face(const SpacePiece& box, int i) {
    const int bit = 1 << i % 3;
    return (box.flat() & ~bit) == 0 && (i < 3 || box.flat() == 0);
  }

  const SpacePiece &a_, &b_;
};

}  // namespace foresee
