// Which ids moved to which leaf since the stored map was last written?
//
//   changes.set(42, leaf);                     // or erased
//   changes.find(42) == leaf
//   const auto position = changes.position();  // … and back to it: changes.rewind(position)
//
// Everything is logged so that a savepoint, or one change that fails, can be taken back; forget_log() drops
// what nobody can go back to any more. A write to the map is logged too: SQLite takes the rows back, and
// what they said waits again.
#pragma once

#include <algorithm>
#include <vector>

#include "storage/rows/id_hash_map.h"

namespace foresee {

class MapChanges {
 public:
  static constexpr std::int64_t erased = 0;  ///< the id is gone
  static constexpr std::int64_t unknown = IdHashMap::unknown;

  /// A leaf's number, erased, or unknown: the stored map knows.
  std::int64_t find(std::int64_t id) const noexcept {
    const std::int64_t leaf = leaves_.find(id);
    return leaf == unknown && stored_is_void_ ? erased : leaf;
  }
  /// The id is in this leaf from now on; what was known before is logged. All or nothing.
  void set(std::int64_t id, std::int64_t leaf);
  /// What the stored map says counts no longer, for any id.
  void void_stored();

  bool stored_is_void() const { return stored_is_void_; }
  bool waits() const { return leaves_.size() != 0 || stored_is_void_; }
  /// Bytes more than after the last write: what writing again would make worth its while.
  std::size_t memory() const { return held() - held_after_writing_; }
  /// All that waits, in no order.
  std::vector<IdHashMap::Entry> waiting() const { return leaves_.known(); }
  /// All that waited is in the stored map now. `may_rewind`: somebody may go back to before.
  void written(bool may_rewind);

  std::size_t position() const { return log_.size(); }
  void rewind(std::size_t position) noexcept;
  void forget_log() noexcept {
    log_.clear();
    began_with_nothing_ = !waits();
    held_after_writing_ = std::min(held_after_writing_, held());
  }
  /// After a commit, or after a rollback of everything.
  void clear() noexcept;

 private:
  void log_change_of_void(bool before);
  std::size_t held() const { return leaves_.memory() + log_.size() * sizeof(IdHashMap::Entry); }

  IdHashMap leaves_;
  bool stored_is_void_ = false;
  std::vector<IdHashMap::Entry> log_;  // what was known before, oldest first
  bool began_with_nothing_ = true;     // when the log was empty nothing waited
  std::size_t held_after_writing_ = 0;
};

}  // namespace foresee
