// Is an outline one, and is it still one after it was turned?
//
//   check_outline(outline);               // throws Error: "edges (0 0, 2 2) and (2 0, 0 2) cross"
//   const Outline as_it_lies = turned(outline, 37.5);
//   check_turned(outline, as_it_lies, 37.5);
//
// Every ring has three corners or more, crosses and touches no edge of its own, and so encloses an area. Two
// rings may touch in single points, but neither cross nor lie on each other. Holes lie within the ring of
// their part and not within each other; parts lie apart, or within a hole. Decided by exact signs, in one
// sweep (sweep.h), so that it is the same on every machine, and no outline takes longer than n log n. Cost:
// some 200 ns a corner; 10 ns where the outline is convex.
#pragma once

#include <optional>

#include "shape/outline/flaw.h"

namespace foresee {

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
