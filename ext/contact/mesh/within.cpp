#include "contact/mesh/within.h"

#include "contact/exact/exact_contact.h"

namespace foresee {

bool Within::at_begin() {
  return may_be() && at(exact_moments_of(setup_, row_a_, row_b_).begin);
}

bool Within::at(const Dyadic& moment) {
  if (!may_be()) return false;
  Displacement d(setup_, row_a_, row_b_, relative_, moment);
  return (a_.solid() && any_part(b_, *a_.solid(), 1, d)) || (b_.solid() && any_part(a_, *b_.solid(), -1, d));
}

bool Within::any_part(const SpacePieces& parts, const TriangleTree& solid, int sign, Displacement& d) {
  for (std::size_t i = 0; i < parts.parts(); ++i) {
    SeenCorner corner(parts.part_corner(i), sign, d);
    if (is_enclosed(solid, corner, steps_)) return true;
  }
  return false;
}

}  // namespace foresee
