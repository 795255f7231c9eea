// Which outline does a text mean? Well-known text (OGC Simple Features, part 1, section 7), read strictly.
//
//   Outline hull = read_outline("POLYGON((-8 -90, 8 -90, 0 90, -8 -90))");
//
// POLYGON and MULTIPOLYGON with two numbers a corner, in any case and with any white space; rings run either
// way round and are closed: the first corner comes again at the end. Each number is the double nearest to
// what is written; one beyond the largest double is refused, and one that is not 0 but nearest to it.
// "SRID=n;" before them is dropped, but 4326 is refused: degrees are no lengths. Corners that repeat the one
// before them are dropped. At most `max_corners`: what has more is refused when the first too many is read.
// Whether rings cross is not asked here (validity.h).
//
// Throws Error, which names the ring or the character (the first is 1) and quotes at most 40 characters.
// Cost: some 100 ns a corner; linear in the text, whatever it is.
#pragma once

#include <string>
#include <string_view>

#include "shape/outline/outline.h"

namespace foresee {

Outline read_outline(std::string_view text);

// What is an outline as well-known text? POLYGON, or MULTIPOLYGON where it has several parts.
//
//   write_outline(hull) == "POLYGON((-8 -90, 8 -90, 0 90, -8 -90))"
//
// Numbers have as few digits as read back to the same doubles, and rings are closed, so that
// read_outline(write_outline(outline)) == outline. Cost: some 100 ns a corner.

std::string write_outline(const Outline& outline);

/// "-8 -90", as in texts and messages.
std::string shown(const Corner& corner);

/// "ring 2", or "ring 2 of part 3" where there are several parts: counted from 1.
std::string name_of_ring(const Outline& outline, std::size_t ring);

}  // namespace foresee
