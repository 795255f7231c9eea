// Changes of the id map since it was last written: the new leaf of each id, with a log for rollbacks.
//
//   changes.set(42, leaf);                     // or MapChanges::erased
//   changes.find(42) == leaf
//   const auto position = changes.position();  // later: changes.rewind(position)
//
// Every change is logged, so that a savepoint or one failed change can be rolled back; forget_log() drops the
// log once no rollback can follow. A write of the map is logged too: when SQLite restores the rows, the
// changes are unwritten again.
#pragma once

#include <algorithm>
#include <vector>

#include "storage/rows/id_hash_map.h"

namespace foresee {

class MapChanges {
 public:
  static constexpr std::int64_t erased = 0;  ///< the id is gone
  static constexpr std::int64_t unknown = IdHashMap::unknown;

  /// A leaf's number; erased; or unknown: look it up in the stored map.
  std::int64_t find(std::int64_t id) const noexcept {
    const std::int64_t leaf = leaves_.find(id);
    return leaf == unknown && stored_is_void_ ? erased : leaf;
  }
  /// Sets the leaf of an id and logs the old one. Atomic.
  void set(std::int64_t id, std::int64_t leaf);
  /// The stored map is no longer valid, for any id.
  void void_stored();

  bool stored_is_void() const { return stored_is_void_; }
  bool has_unwritten() const { return leaves_.size() != 0 || stored_is_void_; }
  /// Bytes in use beyond those left by the last write: what another write would release.
  std::size_t memory() const { return held() - held_after_writing_; }
  /// All unwritten changes, in no order.
  std::vector<IdHashMap::Entry> unwritten() const { return leaves_.known(); }
  /// All changes are in the stored map now. `may_rewind`: a rewind() to before may follow.
  void written(bool may_rewind);

  std::size_t position() const { return log_.size(); }
  void rewind(std::size_t position) noexcept;
  void forget_log() noexcept {
    log_.clear();
    started_empty_ = !has_unwritten();
    held_after_writing_ = std::min(held_after_writing_, held());
  }
  /// After a commit, or after a rollback of everything.
  void clear() noexcept;

 private:
  void log_change_of_void(bool before);
  std::size_t held() const { return leaves_.memory() + log_.size() * sizeof(IdHashMap::Entry); }

  IdHashMap leaves_;
  bool stored_is_void_ = false;
  std::vector<IdHashMap::Entry> log_;  // old values, oldest first
  bool started_empty_ = true;          // nothing was unwritten when the log was empty
  std::size_t held_after_writing_ = 0;
};

}  // namespace foresee
