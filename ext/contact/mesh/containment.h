// Point-in-solid test for moving meshes: whether one object is inside the other without touching its surface.
//
//   within.may_be() && within.at(Dyadic(12.5))              // 12.5 after now
//
// The pieces of a mesh are its triangles, which leave out the inside. One corner represents each connected
// component of the surface: it is inside if a ray along x crosses the solid's surface an odd number of
// times (J. O'Rourke, "Computational Geometry in C", 2nd edition, section 7.5). The ray starts at the
// corner moved by (0, e, e^2) for an infinitesimal e, so that it meets no edge and no corner of the solid.
// Doubles with error bounds nearly always decide; exact numbers decide the rest. Cost per component: some
// nanoseconds outside of the solid's box; inside of it about a microsecond, growing with the logarithm of
// the number of triangles.
#pragma once

#include "base/interrupt_steps.h"
#include "contact/certified/certain_motion.h"
#include "contact/mesh/space_constraint.h"
#include "contact/setup.h"
#include "numbers/dyadic.h"

namespace foresee {

class Containment {
 public:
  /// `Context`: a PairContext, which must outlive this.
  template <class Context>
  explicit Containment(const Context& context)
      : setup_(context.setup),
        row_a_(context.row_a),
        row_b_(context.row_b),
        a_(context.a),
        b_(context.b),
        relative_(context.relative),
        steps_(context.steps) {}

  /// Whether one of the two is a solid.
  bool may_be() const { return a_.solid() || b_.solid(); }
  /// At the start of the queried time. The result is arbitrary if the surfaces touch then.
  bool at_start();
  /// At a time after now. Requires: the surfaces do not touch then.
  bool at(const Dyadic& time);

 private:
  const Setup& setup_;
  const double *row_a_, *row_b_;
  const SpacePieces &a_, &b_;
  const CertainMotion<3>& relative_;
  Steps& steps_;
};

}  // namespace foresee
