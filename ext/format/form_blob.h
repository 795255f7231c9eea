// Stored form, an outline, a zone or a mesh: the blob of a row of <name>_shape, with common header and checksum.
//
//   const std::vector<std::byte> blob = encode_form(form);
//   if (const char* fault = decode_form(blob, Shape::mesh, read)) …   // checks bytes of a file, which may be damaged
//
// Counts and the numbers in a form take 4 bytes each, a coordinate is a double; all are little-endian. The last four
// bytes are the CRC-32C of all bytes before them. Equal forms have equal blobs. Cost: a pass over the bytes, and the
// checks of a form that is read as text.
//
// Outline:
//
//     byte 0   1      2..3   4..7    8..11   12..15
//   +--------+------+------+-------+-------+---------+-----------------+------------------+----------+
//   | format | kind | 0    | rings | parts | corners | ring ends, part | x, y of each     | checksum |
//   |  1     | 1    |      |       |       |         | starts          | corner           |          |
//   +--------+------+------+-------+-------+---------+-----------------+------------------+----------+
//
// Mesh. Kind is 2 for TIN Z, 3 for POLYHEDRALSURFACE Z, 4 for MULTIPOLYGON Z. No corner is stored twice; corners are
// numbered from 0, in the order in which the triangles name them. Whether the mesh is closed is not stored.
//
//     byte 0   1      2..3   4..7        8..11     12..15
//   +--------+------+------+-----------+---------+--------+------------------+-----------------+----------+
//   | format | kind | 0    | triangles | corners | 0      | three corners of | x, y, z of each | checksum |
//   |  1     | 2..4 |      |           |         |        | each triangle    | corner          |          |
//   +--------+------+------+-----------+---------+--------+------------------+-----------------+----------+
//
// Zone (geography/zone.h): the blob of its corners in longitude and latitude as they were written, then that of its
// outline on the plane.
//
//     byte 0   1      2..3   4..7             8..15
//   +--------+------+------+----------------+-------+-----------------+-----------------+----------+
//   | format | kind | 0    | size of        | 0     | longitudes and  | outline on the  | checksum |
//   |  1     | 5    |      | the first blob |       | latitudes       | plane           |          |
//   +--------+------+------+----------------+-------+-----------------+-----------------+----------+
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "shape/mesh/mesh.h"
#include "shape/outline/outline.h"
#include "shape/shared_form.h"

namespace foresee {

enum class FormKind : std::uint8_t { outline = 1, surface = 2, solid = 3, parts = 4, zone = 5 };

constexpr std::size_t form_counts_at = 4, form_header_size = 16, form_checksum_size = 4;

/// Forms are numbered from 1 to this, because a record stores the number in a double.
constexpr std::int64_t largest_form_number = std::int64_t{1} << 53;

std::vector<std::byte> encode_form(const Form& form);

/// Reads a blob of a table whose objects have this shape. Returns what is wrong with it; null: nothing, and
/// `form` is set.
const char* decode_form(std::span<const std::byte> blob, Shape shape, std::shared_ptr<const Form>& form);

// --- each kind. encode: requires a valid form. decode: returns what is wrong with a blob; null: nothing, and the form
// is valid.

std::vector<std::byte> encode_outline(const Outline& outline);
const char* decode_outline(std::span<const std::byte> blob, Outline& outline);

std::vector<std::byte> encode_zone(const Outline& degrees, const Outline& plane);
const char* decode_zone(std::span<const std::byte> blob, Outline& degrees, Outline& plane);

std::vector<std::byte> encode_mesh(const Mesh& mesh);
const char* decode_mesh(std::span<const std::byte> blob, Mesh& mesh);

// --- what they share

/// Returns a blob of zeros with format and kind filled in.
std::vector<std::byte> form_blob_of(FormKind kind, std::size_t size);

/// Writes the checksum.
void seal_form(std::span<std::byte> blob);

/// The stored checksum: equal for equal blobs, rarely equal for others.
std::uint32_t checksum_of_form(std::span<const std::byte> blob);

/// Returns what is wrong with size, checksum or format; null: nothing. Accepts any kind.
const char* form_frame_fault(std::span<const std::byte> blob);

/// Requires: `form_frame_fault` returned null.
FormKind form_kind_of(std::span<const std::byte> blob);

}  // namespace foresee
