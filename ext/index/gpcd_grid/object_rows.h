// The location of the full objects, which a scan prefetches for the exact test of its pairs and never reads.
#pragma once

#include <cstddef>

namespace foresee::gpcd {

struct ObjectRows {
  const char* first = nullptr;  ///< null: no object is prefetched
  std::size_t bytes = 0;        ///< the distance from one object to the next
};

}  // namespace foresee::gpcd
