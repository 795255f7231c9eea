// Validity of an outline: rings, holes and parts that do not cross; also after a rotation with its rounding.
//
//   check_outline(outline);               // throws Error: "edges (0 0, 2 2) and (2 0, 0 2) cross"
//   const Outline rotated = turned(outline, 37.5);
//   check_turned(outline, edge_touch_of(outline), rotated, 37.5);
//
// Every ring has at least three corners, neither crosses nor touches itself, and so encloses an area. Two
// rings may touch in single points, but neither cross nor overlap. Holes lie within the outer ring of their
// part and not within each other. Parts are disjoint, or lie within a hole. Exact signs decide, in one sweep
// (sweep.h): the same result on every machine, and no outline takes longer than n log n. Cost: some 200 ns
// per corner; 10 ns if the outline is convex.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "shape/outline/outline.h"

namespace foresee {

// The flaw of an invalid outline, and its text in messages.
//
//   shown(flaw, outline) == "edges (0 0, 2 2) and (2 0, 0 2) cross"

/// A flaw and its edges; the number of an edge is the index of its first corner.
struct Flaw {
  enum class Kind : std::uint8_t {
    few_corners,   ///< the ring of `a` has fewer than three
    no_area,       ///< the corners of the ring of `a` lie on one line
    cross,         ///< a and b
    overlap,       ///< a and b
    self_touch,    ///< a and b, of one ring, touch in `place`
    edge_touch,    ///< a and b, of two rings, touch in `place`, not a corner of both: invalid if rotated
    hole_outside,  ///< the ring of `a` is a hole and lies outside the ring of its part
    hole_inside,   ///< the ring of `a` is a hole and lies within the ring of `b`, not that of its part
    part_inside,   ///< the ring of `a` encloses a part and lies within that of `b`, another part's
  };
  Kind kind;
  std::uint32_t a, b;
  Corner place;
};

/// The text for the author of the outline.
std::string shown(const Flaw& flaw, const Outline& outline);

/// The leftmost flaw; empty if the outline is valid.
std::optional<Flaw> flaw_of(const Outline& outline);

/// Throws Error, which says what is wrong and where, for the author of the outline.
void check_outline(const Outline& outline);

/// The leftmost place at which rings of the valid outline touch at a corner of only one of them; empty if there is
/// no such place. It costs as much as a check, and one outline may be rotated for many rows.
std::optional<Flaw> edge_touch_of(const Outline& outline);

/// As check_outline() for `turned`, the valid `outline` rotated by `heading` degrees: rounding may close a gap of
/// an ulp. Rings may then touch only at corners of both, unless the rotation is by right angles: rounding would
/// separate a corner from an edge. `edge_touch`: edge_touch_of(outline).
void check_turned(const Outline& outline, const std::optional<Flaw>& edge_touch, const Outline& turned,
                  double heading);

}  // namespace foresee
