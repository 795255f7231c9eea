// An inner node of the tree: for each child, bounds that move and contain everything beneath it.
//
//   lower(s) = lower + v_lower·d + a_lower·d²/2,  upper(s) = upper + v_upper·d + a_upper·d²/2
//
// hold for every s, d being s - epoch; before the epoch (d < 0) with v_lower and v_upper exchanged. All
// bounds are rounded outward; infinite where no double is large enough. An entry is stored as index/pages.h
// draws it, less what can be said without: velocities where the table declares no motion, accelerations where
// it declares none.
//
//   seal:  std::vector<std::byte> blob = encode_inner(format, number, node);
//   read:  if (const char* fault = inner_fault(format, blob, number)) …
//          Node node = decode_inner(format, blob);
#pragma once

#include <vector>

#include "index/pages.h"
#include "storage/format/node_format.h"

namespace foresee {

/// Velocity bounds of what is at rest, as a tree has them: not quite 0, because every computed bound is
/// padded outward. Accelerations are bounded exactly, so where there are none their bounds are 0.
inline constexpr double rest_velocity_pad = 0x1p-1000;

/// Requires: at least one entry. Throws BrokenTree if there are more than fit.
std::vector<std::byte> encode_inner(const NodeFormat& format, std::int64_t number, const Node& node);

/// What is wrong with a blob that claims to be inner node `number`; null: nothing.
const char* inner_fault(const NodeFormat& format, std::span<const std::byte> blob, std::int64_t number);

/// Whether the bytes are those that were stored as node `number`, and an inner one at that.
bool is_inner(const NodeFormat& format, std::span<const std::byte> blob, std::int64_t number);

/// Requires: `inner_fault` found nothing.
Node decode_inner(const NodeFormat& format, std::span<const std::byte> blob);

}  // namespace foresee
