// An outline or a mesh as it is stored: a row's blob of <name>_shape, which outline_blob.h and mesh_blob.h
// draw.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "shape/form.h"
#include "storage/format/form_frame.h"

namespace foresee {

/// Forms are numbered from 1 to this: a record holds the number in a double.
constexpr std::int64_t largest_form_number = std::int64_t{1} << 53;

std::vector<std::byte> encode_form(const Form& form);

/// What is wrong with a blob of a table whose rows have forms of this shape; null: nothing, and `form` is it.
const char* decode_form(std::span<const std::byte> blob, Shape shape, std::shared_ptr<const Form>& form);

}  // namespace foresee
