// Does one object lie within the other, a solid, without touching its surface? What the pieces of a mesh, its
// triangles, leave out.
//
//   Within within(setup, row_a, row_b, a, b, relative, steps);
//   within.may_be() && within.at(Dyadic(12.5))              // 12.5 after now
//
// One corner stands for each part that hangs together (ray.h). Cost: that of a ray a part.
#pragma once

#include "contact/mesh/ray.h"

namespace foresee {

class Within {
 public:
  /// What is given must outlive this.
  Within(const Setup& setup, const double* row_a, const double* row_b, const SpacePieces& a,
         const SpacePieces& b, const CertainMotion<3>& relative, Steps& steps)
      : setup_(setup), row_a_(row_a), row_b_(row_b), a_(a), b_(b), relative_(relative), steps_(steps) {}

  /// Whether one of the two has an inside.
  bool may_be() const { return a_.solid() || b_.solid(); }
  /// When what is asked about begins. Where the surfaces touch then it may say anything.
  bool at_begin();
  /// At a moment from now on. Requires: the surfaces do not touch then.
  bool at(const Dyadic& moment);

 private:
  bool any_part(const SpacePieces& parts, const TriangleTree& solid, int sign, Displacement& d);

  const Setup& setup_;
  const double *row_a_, *row_b_;
  const SpacePieces &a_, &b_;
  const CertainMotion<3>& relative_;
  Steps& steps_;
};

}  // namespace foresee
