// Does one object lie within the other, a solid, without touching its surface? What the pieces of a mesh, its
// triangles, leave out.
//
//   Containment within(setup, row_a, row_b, a, b, relative, steps);
//   within.may_be() && within.at(Dyadic(12.5))              // 12.5 after now
//
// One corner stands for each part that hangs together (is_enclosed). Cost: that of a ray a part.
#pragma once

#include <optional>

#include "base/interrupt_steps.h"
#include "contact/certain/certain_motion.h"
#include "contact/mesh/space_condition.h"
#include "numbers/dyadic.h"

namespace foresee {

// Where is one object seen from the other at some moment, and where are its corners? Roughly, and exactly
// once that is asked for.
//
//   Displacement d(setup, row_a, row_b, relative, Dyadic(12.5));
//   SeenCorner corner(corner_of_b, 1, d);          // from a; sign -1 for those of a, seen from b
//   corner.near()[0].value, corner.exact()[0]

/// d at a moment.
class Displacement {
 public:
  /// What is given must outlive this; the moment is measured from now.
  Displacement(const Setup& setup, const double* row_a, const double* row_b, const CertainMotion<3>& relative,
               const Dyadic& instant);

  const Components<Bounded>& near() const { return near_; }
  const Components<Dyadic>& exact();

 private:
  const Setup& setup_;
  const double *row_a_, *row_b_;
  const Dyadic time_;
  Components<Bounded> near_;
  std::optional<Components<Dyadic>> exact_;
};

class SeenCorner {
 public:
  SeenCorner(const SpaceCorner& corner, int sign, Displacement& d);

  const Components<Bounded>& near() const { return near_; }
  const Components<Dyadic>& exact();

 private:
  const SpaceCorner& corner_;
  const int sign_;
  Displacement& d_;
  Components<Bounded> near_;
  std::optional<Components<Dyadic>> exact_;
};

// Does a ray along x cross the surface of a solid an odd number of times? Then it begins inside (J. O'Rourke,
// "Computational Geometry in C", 2nd edition, section 7.5).
//
//   is_enclosed(solid, corner, steps)
//
// The ray begins at the corner moved by (0, e, e^2) for an infinitesimal e, so that it meets no edge and no
// corner of the solid. Doubles with error bounds tell nearly always; where they do not, exact numbers. Cost:
// some nanoseconds outside of the solid's box; within it about a microsecond, and the logarithm of the
// triangles.

/// Each node looked at is a step. Requires: the corner is not on the surface; there it may say anything.
bool is_enclosed(const TriangleTree& solid, SeenCorner& corner, Steps& steps);

class Containment {
 public:
  /// What is given must outlive this.
  Containment(const Setup& setup, const double* row_a, const double* row_b, const SpacePieces& a,
              const SpacePieces& b, const CertainMotion<3>& relative, Steps& steps)
      : setup_(setup), row_a_(row_a), row_b_(row_b), a_(a), b_(b), relative_(relative), steps_(steps) {}

  /// Whether one of the two has an inside.
  bool may_be() const { return a_.solid() || b_.solid(); }
  /// When what is asked about begins. Where the surfaces touch then it may say anything.
  bool at_start();
  /// At a moment from now on. Requires: the surfaces do not touch then.
  bool at(const Dyadic& instant);

 private:
  bool any_part(const SpacePieces& parts, const TriangleTree& solid, int sign, Displacement& d);

  const Setup& setup_;
  const double *row_a_, *row_b_;
  const SpacePieces &a_, &b_;
  const CertainMotion<3>& relative_;
  Steps& steps_;
};

}  // namespace foresee
