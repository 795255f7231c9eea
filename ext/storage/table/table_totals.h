// What is known of the objects of a table as a whole: their number, the largest id, the origin that the first one has
// chosen.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "geography/geodesic.h"

namespace foresee {

// Number of objects of a table, as far as it is known without reading.
//
//   ObjectCount count{.stored = 1000};
//   ++count.added;                          // an unwritten insert
//   count.likely() == 1001
//
// For the query planner: it never causes a read, and no result depends on it. Small enough for a copy
// at every mark.
struct ObjectCount {
  /// The count in `_meta`; nothing if version 0.1 of foresee wrote the table, or if it is out of range.
  std::optional<std::int64_t> stored = std::nullopt;
  /// Added by this transaction and not in `stored` yet; negative if objects were removed.
  std::int64_t added = 0;
  /// Used without `stored`: at first what R*Tree assumes without statistics, then the number found by the
  /// last complete read.
  std::int64_t estimate = 1048576;

  std::int64_t likely() const noexcept {
    return std::max<std::int64_t>(0, stored.value_or(estimate) + added);
  }
  /// All objects were read, including the added ones.
  void note_all(std::size_t found) noexcept { estimate = static_cast<std::int64_t>(found) - added; }
  /// The count to store; nothing if the objects must be counted.
  std::optional<std::int64_t> sum() const noexcept {
    return stored && *stored + added >= 0 ? std::optional(*stored + added) : std::nullopt;
  }
};

/// The largest id, known within a write transaction only.
struct LargestId {
  bool known = false;
  bool exact = false;  ///< else an upper bound
  std::optional<std::int64_t> id = {};
};

/// The origin that the first position of a table in degrees has chosen, as far as it is known.
struct ChosenOrigin {
  bool known = false;
  bool unwritten = false;  ///< by this transaction, and not in `_meta` yet
  std::optional<LatLon> value = {};
};

struct Totals {
  ObjectCount count = {};
  LargestId largest = {};
};

}  // namespace foresee
