// An outline or a mesh as it is stored: a row's blob of <name>_shape, which outline_blob.h and mesh_blob.h
// draw.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "shape/form.h"

namespace foresee {

// What do the blobs of all forms have in common? A byte of format, one of kind, and at the end a checksum.
//
//     byte 0   1      2..3   4..15                        last four
//   +--------+------+------+---------+-- … ------------+----------+
//   | format | kind | 0    | counts  |  the form       | checksum |
//   |  1     |      |      |         |                 |          |
//   +--------+------+------+---------+-- … ------------+----------+
//
// The last four bytes are the CRC-32C of all before. Equal forms have equal blobs.

enum class FormKind : std::uint8_t { outline = 1, surface = 2, solid = 3, parts = 4 };

constexpr std::size_t form_counts_at = 4, form_header_size = 16, form_checksum_size = 4;

/// All 0 but for format and kind.
std::vector<std::byte> form_blob_of(FormKind kind, std::size_t size);

/// Fills the checksum in.
void seal_form(std::span<std::byte> blob);

/// What a blob says of itself: equal blobs have equal ones, others seldom.
std::uint32_t checksum_of_form(std::span<const std::byte> blob);

/// What is wrong with size, checksum or format; null: nothing. Its kind may be any.
const char* form_frame_fault(std::span<const std::byte> blob);

/// Requires: no fault.
FormKind form_kind_of(std::span<const std::byte> blob);

/// Forms are numbered from 1 to this: a record holds the number in a double.
constexpr std::int64_t largest_form_number = std::int64_t{1} << 53;

std::vector<std::byte> encode_form(const Form& form);

/// What is wrong with a blob of a table whose rows have forms of this shape; null: nothing, and `form` is it.
const char* decode_form(std::span<const std::byte> blob, Shape shape, std::shared_ptr<const Form>& form);

}  // namespace foresee
