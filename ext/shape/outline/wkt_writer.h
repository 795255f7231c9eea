// What is an outline as well-known text? POLYGON, or MULTIPOLYGON where it has several parts.
//
//   write_outline(hull) == "POLYGON((-8 -90, 8 -90, 0 90, -8 -90))"
//
// Numbers have as few digits as read back to the same doubles, and rings are closed, so that
// read_outline(write_outline(outline)) == outline. Cost: some 100 ns a corner.
#pragma once

#include <string>

#include "shape/outline/outline.h"

namespace foresee {

std::string write_outline(const Outline& outline);

/// "-8 -90", as in texts and messages.
std::string shown(const Corner& corner);

/// "ring 2", or "ring 2 of part 3" where there are several parts: counted from 1.
std::string name_of_ring(const Outline& outline, std::size_t ring);

}  // namespace foresee
