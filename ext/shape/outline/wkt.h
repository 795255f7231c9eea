// Reads outlines from well-known text (WKT; OGC Simple Features, part 1, section 7), strictly, and writes
// them.
//
//   Outline hull = read_outline("POLYGON((-8 -90, 8 -90, 0 90, -8 -90))");
//
// POLYGON and MULTIPOLYGON with two numbers per corner, in any case and with any white space. Rings run
// either way round and are closed: the first corner is repeated at the end. Each number is the nearest
// double; one beyond the largest double is refused, and so is one that underflows to 0. A prefix "SRID=n;" is
// dropped, but 4326 is refused: degrees are not lengths. For degrees only 4326 is accepted (geography/zone.h).
// Corners that repeat the one before them are dropped.
// At most `max_corners`: a larger outline is refused at the first corner beyond. Crossing rings are found by
// validity.h.
//
// Throws Error, which names the ring or the character (the first is 1) and quotes at most 40 characters.
// Cost: some 100 ns per corner; linear in the text, whatever it is.
#pragma once

#include <string>
#include <string_view>

#include "base/error.h"
#include "base/text/wkt_lexer.h"
#include "shape/outline/outline.h"

namespace foresee {

Outline read_outline(std::string_view text, WktUnit unit = WktUnit::metres);

// Writes an outline as POLYGON, or as MULTIPOLYGON if it has several parts.
//
//   write_outline(hull) == "POLYGON((-8 -90, 8 -90, 0 90, -8 -90))"
//
// Numbers have the fewest digits that read back to the same doubles, and rings are closed, so that
// read_outline(write_outline(outline)) == outline. Cost: some 100 ns per corner.

std::string write_outline(const Outline& outline);

/// "-8 -90", as in texts and messages.
std::string shown(const Corner& corner);

/// "ring 2", or "ring 2 of part 3" if there are several parts: counted from 1.
std::string name_of_ring(const Outline& outline, std::size_t ring);

}  // namespace foresee
