// Where is one object seen from the other at some moment, and where are its corners? Roughly, and exactly
// once that is asked for.
//
//   Displacement d(setup, row_a, row_b, relative, Dyadic(12.5));
//   SeenCorner corner(corner_of_b, 1, d);          // from a; sign -1 for those of a, seen from b
//   corner.near()[0].value, corner.exact()[0]
#pragma once

#include <optional>

#include "contact/certain/certain_motion.h"
#include "contact/mesh/space_condition.h"
#include "numbers/dyadic.h"

namespace foresee {

/// d at a moment.
class Displacement {
 public:
  /// What is given must outlive this; the moment is measured from now.
  Displacement(const Setup& setup, const double* row_a, const double* row_b, const CertainMotion<3>& relative,
               const Dyadic& moment);

  const Components<Bounded>& near() const { return near_; }
  const Components<Dyadic>& exact();

 private:
  const Setup& setup_;
  const double *row_a_, *row_b_;
  const Dyadic moment_;
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

}  // namespace foresee
