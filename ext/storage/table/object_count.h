// How many objects does a table have, as far as is known without reading?
//
//   ObjectCount count{.stored = 1000};
//   ++count.added;                          // an insert, not written yet
//   count.likely() == 1001
//
// For who plans: never a reason to read or to leave something out. Small enough that savepoints keep copies.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

namespace foresee {

struct ObjectCount {
  /// What `_meta` says; none: nothing, since version 0.1 of foresee wrote the table, or nothing that can be.
  std::optional<std::int64_t> stored = std::nullopt;
  /// By this transaction and not yet part of what is stored; negative where it took objects away.
  std::int64_t added = 0;
  /// In place of what is not stored: at first what R*Tree assumes without statistics, then as many as were
  /// found when all were read last.
  std::int64_t estimate = 1048576;

  std::int64_t likely() const noexcept {
    return std::max<std::int64_t>(0, stored.value_or(estimate) + added);
  }
  /// All have been read, those that were added among them.
  void note_all(std::size_t found) noexcept { estimate = static_cast<std::int64_t>(found) - added; }
  /// What is to be stored; nothing if only counting tells.
  std::optional<std::int64_t> sum() const noexcept {
    return stored && *stored + added >= 0 ? std::optional(*stored + added) : std::nullopt;
  }
};

}  // namespace foresee
