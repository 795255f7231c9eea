// Inner node of the TPR-tree as stored bytes: for each child, moving bounds of everything below it.
//
//   lower(s) = lower + v_lower·d + a_lower·d²/2,  upper(s) = upper + v_upper·d + a_upper·d²/2
//
// hold for every s, where d = s - epoch; before the epoch (d < 0) v_lower and v_upper are exchanged. All
// bounds are rounded outward, and infinite where no double is large enough. The stored entry is the one of
// index/pages.h, without velocities or accelerations where the declaration of the table excludes them.
//
//   seal:  std::vector<std::byte> blob = encode_inner(format, number, node);
//   read:  if (const char* fault = inner_fault(format, blob, number)) …
//          Node node = decode_inner(format, blob);
#pragma once

#include <vector>

#include "format/node_format.h"
#include "index/pages.h"

namespace foresee {

/// Velocity bounds of objects at rest, as the tree computes them: not exactly 0, because every computed bound
/// is padded outward. Acceleration bounds are exact, so without accelerations they are 0.
inline constexpr double rest_velocity_pad = 0x1p-1000;

/// Requires: at least one entry. Throws BrokenTree if there are more than fit.
std::vector<std::byte> encode_inner(const NodeFormat& format, std::int64_t number, const Node& node);

/// Returns what is wrong with a blob that claims to be inner node `number`; null: nothing.
const char* inner_fault(const NodeFormat& format, std::span<const std::byte> blob, std::int64_t number);

/// True if the blob is node `number` with a correct checksum, and an inner node.
bool is_inner(const NodeFormat& format, std::span<const std::byte> blob, std::int64_t number);

/// Requires: `inner_fault` returned null.
Node decode_inner(const NodeFormat& format, std::span<const std::byte> blob);

}  // namespace foresee
