// Log of the objects that a transaction changes, for the watches of their table.
//
//   changes.start_keeping();                             // for the rest of the transaction
//   if (changes.lacks(42)) changes.add(42);              // before the first change of the object
//   for (const std::int64_t id : changes.ids()) …        // if changes.are_complete()
//
// A watch has the old pairs as its rows, and the store has the records, so ids suffice. A rollback to a savepoint
// forgets the objects that had not been changed before it. A transaction that changes more than max_logged objects is
// not logged any more: its watches join the table again. Cost: a look-up per change, some 50 bytes per changed object.
#pragma once

#include <span>

#include "database/id_hash_map.h"
#include "database/journal.h"

namespace foresee {

class ObjectChanges final : public Journal::Participant {
 public:
  static constexpr std::size_t max_logged = 1 << 18;

  explicit ObjectChanges(Journal& journal) : Participant(journal, Scope::marks) {}

  /// For the rest of the transaction.
  void start_keeping() noexcept { kept_ = true; }
  /// True if a change of this object is to be logged.
  bool lacks(std::int64_t id) const noexcept {
    return kept_ && complete_ && known_.find(id) == IdHashMap::unknown;
  }
  /// Requires: lacks(id). Atomic.
  void add(std::int64_t id) {
    if (ids_.size() == max_logged) return note_others();
    join();
    known_.prepare(id);
    ids_.push_back(id);
    known_.set(id, 1);
  }
  /// Objects that are not in this log may have changed too.
  void note_others() noexcept {
    complete_ = false;
    release_memory();
  }
  bool are_complete() const noexcept { return complete_; }

  /// In the order of their first changes.
  std::span<const std::int64_t> ids() const { return ids_; }
  /// True if nothing has changed since the transaction started to keep changes.
  bool are_none() const noexcept { return ids_.empty() && (complete_ || !kept_); }
  std::size_t memory() const { return ids_.capacity() * sizeof(std::int64_t) + known_.memory(); }

 private:
  std::size_t keep() override { return ids_.size(); }
  void rewind(std::size_t position) noexcept override {
    for (; ids_.size() > position; ids_.pop_back()) known_.set(ids_.back(), IdHashMap::unknown);
  }
  void end(Journal::Ended) noexcept override {
    release_memory();
    kept_ = false;
    complete_ = true;
  }
  void release_memory() noexcept {
    ids_ = std::vector<std::int64_t>();
    known_.clear();
  }

  std::vector<std::int64_t> ids_;
  IdHashMap known_;
  bool kept_ = false;
  bool complete_ = true;
};

}  // namespace foresee
