// An inner node of the tree: for each child, bounds that move and contain everything beneath it.
//
//   lower(s) = lower + v_lower·d + a_lower·d²/2,  upper(s) = upper + v_upper·d + a_upper·d²/2,   d = s -
//   epoch
//
// hold for every s from the child's `t_least` on; before the epoch (d < 0) with v_lower and v_upper
// exchanged. All bounds are rounded outward; infinite where no double is large enough. Velocities are stored
// where the table declares a motion, accelerations where it declares accelerations or forces; what is not
// stored is 0.
//
//   seal:  std::vector<std::byte> blob = encode_inner(format, number, node);
//   read:  if (const char* fault = inner_fault(format, blob, number)) …
//          InnerNode node = decode_inner(format, blob);
#pragma once

#include <array>
#include <vector>

#include "storage/node_format.h"

namespace foresee {

struct InnerEntry {
  std::int64_t child = 0;
  double t_least = 0;     ///< least reference time beneath
  double t_greatest = 0;  ///< greatest reference time beneath
  double until_greatest = 0;
  std::array<double, 3> lower{}, upper{};  ///< at the node's epoch; only the table's axes are used
  std::array<double, 3> v_lower{}, v_upper{};
  std::array<double, 3> a_lower{}, a_upper{};

  friend bool operator==(const InnerEntry&, const InnerEntry&) = default;
};

struct InnerNode {
  int level = 1;            ///< 1: the children are leaves
  std::int64_t parent = 0;  ///< 0: this is the root
  double epoch = 0;
  std::vector<InnerEntry> entries;

  friend bool operator==(const InnerNode&, const InnerNode&) = default;
};

/// Requires: 1 to inner_capacity entries.
std::vector<std::byte> encode_inner(const NodeFormat& format, std::int64_t number, const InnerNode& node);

/// What is wrong with a blob that claims to be inner node `number`; null: nothing.
const char* inner_fault(const NodeFormat& format, std::span<const std::byte> blob, std::int64_t number);

/// Requires: `inner_fault` found nothing.
InnerNode decode_inner(const NodeFormat& format, std::span<const std::byte> blob);

}  // namespace foresee
