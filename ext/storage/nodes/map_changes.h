// Changes of the id map since it was last written: the new leaf of each id, with a log for rollbacks.
//
//   changes.set(42, leaf);                     // or MapChanges::erased
//   changes.find(42) == leaf
//
// Every change after a mark is logged, so that a savepoint or one failed change can be rolled back. A write of
// the map is logged too: when SQLite restores the rows, the changes are unwritten again.
#pragma once

#include <algorithm>
#include <vector>

#include "storage/journal/journal.h"
#include "storage/rows/id_hash_map.h"

namespace foresee {

class MapChanges final : public Journal::Participant {
 public:
  explicit MapChanges(Journal& journal) : Participant(journal, Scope::marks) {}

  static constexpr std::int64_t erased = 0;  ///< the id is gone
  static constexpr std::int64_t unknown = IdHashMap::unknown;

  /// A leaf's number; erased; or unknown: look it up in the stored map.
  std::int64_t find(std::int64_t id) const noexcept {
    const std::int64_t leaf = leaves_.find(id);
    return leaf == unknown && stored_is_void_ ? erased : leaf;
  }
  /// Sets the leaf of an id. Atomic.
  void set(std::int64_t id, std::int64_t leaf);
  /// The stored map is no longer valid, for any id.
  void void_stored();

  bool stored_is_void() const { return stored_is_void_; }
  bool has_unwritten() const { return !leaves_.none_known() || stored_is_void_; }
  /// Bytes in use beyond those left by the last write: what another write would release.
  std::size_t memory() const { return held() - held_after_writing_; }
  /// All unwritten changes, in no order.
  std::vector<IdHashMap::Entry> unwritten() const { return leaves_.known(); }
  /// All changes are in the stored map now.
  void written();
  /// Drops all changes, with the log.
  void clear() noexcept;

 private:
  std::size_t keep() override { return log_.size(); }
  void rewind(std::size_t position) noexcept override;
  void forget() noexcept override;
  void end(Journal::Ended) noexcept override { clear(); }

  void log_all(bool voids);
  std::size_t held() const { return leaves_.memory() + log_.size() * sizeof(IdHashMap::Entry); }

  IdHashMap leaves_;
  bool stored_is_void_ = false;
  std::vector<IdHashMap::Entry> log_;  // old values, oldest first
  bool started_empty_ = true;          // nothing was unwritten when the log was empty
  std::size_t held_after_writing_ = 0;
};

}  // namespace foresee
