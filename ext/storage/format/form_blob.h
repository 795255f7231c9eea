// Stored form of an outline or a mesh: the blob of a row of <name>_shape, with common header and checksum.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "shape/shared_form.h"

namespace foresee {

// Blobs of all kinds of forms start with a byte for the format and one for the kind, and end with a checksum
// (outline_blob.h, mesh_blob.h).
//
//     byte 0   1      2..3   4..15                        last four
//   +--------+------+------+---------+-- … ------------+----------+
//   | format | kind | 0    | counts  |  the form       | checksum |
//   |  1     |      |      |         |                 |          |
//   +--------+------+------+---------+-- … ------------+----------+
//
// The last four bytes are the CRC-32C of all bytes before them. Equal forms have equal blobs.

enum class FormKind : std::uint8_t { outline = 1, surface = 2, solid = 3, parts = 4, zone = 5 };

constexpr std::size_t form_counts_at = 4, form_header_size = 16, form_checksum_size = 4;

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

/// Forms are numbered from 1 to this, because a record stores the number in a double.
constexpr std::int64_t largest_form_number = std::int64_t{1} << 53;

std::vector<std::byte> encode_form(const Form& form);

/// Reads a blob of a table whose objects have this shape. Returns what is wrong with it; null: nothing, and
/// `form` is set.
const char* decode_form(std::span<const std::byte> blob, Shape shape, std::shared_ptr<const Form>& form);

}  // namespace foresee
