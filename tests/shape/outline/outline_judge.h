// Reference implementation of outline validity: rational numbers, every edge against every other, no shared
// code.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <span>
#include <vector>

#include "shape/outline/outline.h"

namespace foresee {

using Rational = boost::multiprecision::cpp_rational;

struct RationalPoint {
  Rational x, y;
};
using RationalRing = std::vector<RationalPoint>;

RationalPoint exact(const Corner& corner);
RationalRing exact(std::span<const Corner> ring);

/// Which side of the line from a to b is c on: 1 left, -1 right.
int side_of(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c);

/// Positive counterclockwise.
Rational twice_area(const RationalRing& ring);
/// Of the region.
Rational twice_area(const Outline& outline);

enum class Where { outside, boundary, inside };
Where where(const RationalPoint& point, const RationalRing& ring);
Where where(const RationalPoint& point, const Outline& outline);

/// Whether the outline is valid by the rules of validity.h.
bool is_sound(const Outline& outline);

}  // namespace foresee
