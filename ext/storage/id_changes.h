// Which ids moved to which leaf since the map was last written?
//
//   changes.prepare(42);             // may throw; nothing changes
//   changes.set(42, leaf);           // cannot fail: the second half of a change that is all or nothing
//   changes.find(42) == leaf
//
// Ascending ids, the common case, cost an append each and a binary search to find; others are hashed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace foresee {

struct IdChange {
  std::int64_t id;
  std::int64_t leaf;  ///< a leaf's number, or one of the two below
};

class IdChanges {
 public:
  static constexpr std::int64_t erased = 0;    ///< the id is gone
  static constexpr std::int64_t unknown = -1;  ///< nothing changed: the stored map knows

  std::int64_t find(std::int64_t id) const noexcept;
  /// Makes room for a change of `id`.
  void prepare(std::int64_t id);
  /// Requires: prepared since the last clear().
  void set(std::int64_t id, std::int64_t leaf) noexcept;

  std::size_t size() const noexcept { return ascending_.size() + others_.size(); }
  void clear() noexcept;
  /// All changes by ascending id.
  std::vector<IdChange> sorted() const;

 private:
  const std::int64_t* slot(std::int64_t id) const noexcept;

  std::vector<IdChange> ascending_;  // ids that arrived in ascending order
  std::unordered_map<std::int64_t, std::int64_t> others_;
};

}  // namespace foresee
