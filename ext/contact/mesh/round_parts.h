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

#include "contact/mesh/space_hull.h"

namespace foresee {

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
        if (b_.owns_edge(k) && !are_parallel(a_.run_of_edge(i), b_.run_of_edge(k)) && !take(edges(i, k)))
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
