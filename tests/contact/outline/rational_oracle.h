// Test oracle for contact of outlines in uniform motion, in rational numbers: edge against edge, and winding.
//
// It uses no convex pieces, normals or Minkowski sums. For every edge of one boundary and every edge of the
// other it computes the times at which the two segments meet, from the parameters along both (Cramer's rule).
// In the remaining gaps the boundaries do not meet, so one corner of each ring decides whether something is
// inside the other. All these times, sorted, are the contacts.
#pragma once

#include <optional>
#include <vector>

#include "contact/rational_judge.h"
#include "shape/outline/outline.h"

namespace foresee::oracle {

/// An exact position in the plane.
struct Place {
  Rational x, y;
};

/// Rings of one region: a point is within if it is inside of an odd number of them. A point is a ring of one.
using Region = std::vector<std::vector<Corner>>;

/// The first interval of contact within `queried`, of `a` at rest and `b` at place + s velocity.
std::optional<RationalInterval> first_contact(const Region& a, const Region& b, const Place& place,
                                              const Place& velocity, const RationalInterval& queried);

/// Whether b, moved by `place`, is within `radius` of a or inside of it, at one instant.
bool touch_at(const Region& a, const Region& b, const Place& place, const Rational& radius);

}  // namespace foresee::oracle
