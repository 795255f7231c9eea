// Why is an outline none? What messages say of it.
//
//   shown(flaw, outline) == "edges (0 0, 2 2) and (2 0, 0 2) cross"
#pragma once

#include <cstdint>
#include <string>

#include "shape/outline/outline.h"

namespace foresee {

/// Between which edges something is wrong: each goes by the place of the corner at which it begins.
struct Flaw {
  enum class Kind : std::uint8_t {
    few_corners,   ///< the ring of `a` has fewer than three
    no_area,       ///< the corners of the ring of `a` lie on one line
    cross,         ///< a and b
    overlap,       ///< a and b
    self_touch,    ///< a and b, of one ring, touch in `place`
    edge_touch,    ///< a and b, of two rings, touch in `place`, no corner of both: sound unless turned
    hole_outside,  ///< the ring of `a` is a hole and lies outside the ring of its part
    hole_inside,   ///< the ring of `a` is a hole and lies within the ring of `b`, not that of its part
    part_inside,   ///< the ring of `a` encloses a part and lies within that of `b`, another part's
  };
  Kind kind;
  std::uint32_t a, b;
  Corner place;
};

/// For whoever wrote the outline.
std::string shown(const Flaw& flaw, const Outline& outline);

/// The same where the flaw is that of the outline turned by `heading` degrees.
std::string shown_turned(const Flaw& flaw, const Outline& outline, double heading);

}  // namespace foresee
