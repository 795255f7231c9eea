// The judge of outlines in uniform motion: boundary by boundary in rational numbers, winding between.
//
// It knows nothing of pieces, normals or sums of shapes: for every edge of one boundary and every edge of the
// other, the moments at which the two segments meet, from the parameters along both (Cramer's rule); in the
// gaps that are left nothing on the boundaries meets, so one corner of each ring says whether something lies
// within the other. All moments together, in order of time, are the contacts.
#pragma once

#include <optional>
#include <vector>

#include "contact/rational_judge.h"
#include "shape/outline/outline.h"

namespace foresee::oracle {

/// A place in the plane, exactly.
struct Place {
  Rational x, y;
};

/// Rings of one region: a point is within if it is inside of an odd number of them. A point is a ring of one.
using Region = std::vector<std::vector<Corner>>;

/// The first stretch of contact within `queried` of `a` at rest and `b`, which is at place + s velocity.
std::optional<RationalInterval> first_contact(const Region& a, const Region& b, const Place& place,
                                       const Place& velocity, const RationalInterval& queried);

/// Does b, moved by `place`, come within `radius` of a, or lie in it? At one moment, whatever the motion.
bool touch_at(const Region& a, const Region& b, const Place& place, const Rational& radius);

}  // namespace foresee::oracle
