// Helpers of the tests of leaves and inner nodes.
#pragma once

#include <limits>

#include "format/node_format.h"

namespace foresee::node_cases {

inline constexpr double inf = std::numeric_limits<double>::infinity();
inline constexpr std::int64_t number = 3;  ///< of the node that is tested

inline NodeFormat format_of(const Layout& layout) {
  return NodeFormat(layout, NodeFormat::node_size_for(layout, 4096));
}

}  // namespace foresee::node_cases
