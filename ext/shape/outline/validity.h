// Is an outline one, and is it still one after it was turned?
//
//   check_outline(outline);               // throws Error: "edges (0 0, 2 2) and (2 0, 0 2) cross"
//   const Outline rotated = turned(outline, 37.5);
//   check_turned(outline, rotated, 37.5);
//
// Every ring has three corners or more, crosses and touches no edge of its own, and so encloses an area. Two
// rings may touch in single points, but neither cross nor lie on each other. Holes lie within the ring of
// their part and not within each other; parts lie apart, or within a hole. Decided by exact signs, in one
// sweep (sweep.h), so that it is the same on every machine, and no outline takes longer than n log n. Cost:
// some 200 ns a corner; 10 ns where the outline is convex.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "shape/outline/outline.h"

namespace foresee {

// Why is an outline none? What messages say of it.
//
//   shown(flaw, outline) == "edges (0 0, 2 2) and (2 0, 0 2) cross"

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

/// The first flaw from the left, or none.
std::optional<Flaw> flaw_of(const Outline& outline);

/// Throws Error, which says what is wrong and where: for whoever wrote the outline.
void check_outline(const Outline& outline);

/// The same for `turned`, which is the valid `outline` turned by `heading` degrees: rounding may close a gap
/// of an ulp. Rings may then touch only at corners of both, unless the turn is by right angles: rounding
/// would part a corner from an edge.
void check_turned(const Outline& outline, const Outline& turned, double heading);

/// Where rings of the valid outline touch at a corner of only one of them, which forbids those turns; the
/// first from the left, or none.
std::optional<Flaw> edge_touch_of(const Outline& outline);

/// The same as above where that is known already: it costs as much as to check the outline, and one outline
/// may be turned for many rows.
void check_turned(const Outline& outline, const std::optional<Flaw>& edge_touch, const Outline& turned,
                  double heading);

}  // namespace foresee
