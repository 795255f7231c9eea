// Stored outline: the blob of a row of <name>_shape (form_blob.h).
//
//     byte 0   1      2..3   4..7    8..11   12..15
//   +--------+------+------+-------+-------+---------+-----------------+------------------+----------+
//   | format | kind | 0    | rings | parts | corners | ring ends, part | x, y of each     | checksum |
//   |  1     | 1    |      |       |       |         | starts          | corner           |          |
//   +--------+------+------+-------+-------+---------+-----------------+------------------+----------+
//
// Counts, ring ends and part starts take 4 bytes each, a corner is two doubles; all are little-endian. The
// last four bytes are the CRC-32C of all bytes before them. Equal outlines have equal blobs.
//
// Stored zone (geography/zone.h): the blob of its corners in longitude and latitude as they were written, then
// that of its outline on the plane.
//
//     byte 0   1      2..3   4..7             8..15
//   +--------+------+------+----------------+-------+-----------------+-----------------+----------+
//   | format | kind | 0    | size of        | 0     | longitudes and  | outline on the  | checksum |
//   |  1     | 5    |      | the first blob |       | latitudes       | plane           |          |
//   +--------+------+------+----------------+-------+-----------------+-----------------+----------+
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "shape/outline/outline.h"

namespace foresee {

/// Requires: a valid outline.
std::vector<std::byte> encode_outline(const Outline& outline);

/// Returns what is wrong with a blob; null: nothing, and `outline` is a valid outline.
const char* decode_outline(std::span<const std::byte> blob, Outline& outline);

std::vector<std::byte> encode_zone(const Outline& degrees, const Outline& plane);

/// Returns what is wrong with a blob; null: nothing, and `plane` is a valid outline.
const char* decode_zone(std::span<const std::byte> blob, Outline& degrees, Outline& plane);

}  // namespace foresee
