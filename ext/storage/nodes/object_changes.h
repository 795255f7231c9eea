// Log of the objects that a transaction changes, each with its record from before the transaction.
//
//   changes.start_keeping();                             // for the rest of the transaction
//   if (!changes.knows(42)) changes.add(42, record);     // before the first change; {}: a new object
//   changes.for_each([&](std::int64_t id, std::span<const double> before) { … });
//
// The first change of an object keeps its record, later changes keep nothing: the store has the current
// record. The old record only decides whether the object differs; a watch has the old pairs as its rows. A rollback
// to a savepoint forgets the objects that had not been changed before it. Cost: a look-up per change, and about
// 40 bytes and the record per changed object.
#pragma once

#include <span>

#include "storage/journal/journal.h"
#include "storage/rows/id_hash_map.h"

namespace foresee {

class ObjectChanges final : public Journal::Participant {
 public:
  explicit ObjectChanges(Journal& journal) : Participant(journal, Scope::marks) {}

  /// For the rest of the transaction.
  void start_keeping() noexcept { kept_ = true; }
  bool are_kept() const noexcept { return kept_; }
  /// True if the object's state from before the transaction is known.
  bool knows(std::int64_t id) const noexcept { return known_.find(id) != IdHashMap::unknown; }
  /// Requires: not known. `before`: the object's record, empty for a new object. Atomic.
  void add(std::int64_t id, std::span<const double> before);
  /// Objects that are not in this log may have changed too.
  void note_others() noexcept { complete_ = false; }
  bool are_complete() const noexcept { return complete_; }

  std::size_t count() const { return firsts_.size(); }
  std::size_t memory() const;
  /// Calls each(id, before) for every object, in the order of their first changes.
  template <class Each>
  void for_each(Each each) const {
    std::size_t start = 0;
    for (const First& first : firsts_) {
      each(first.id, std::span<const double>(records_.data() + start, first.end - start));
      start = first.end;
    }
  }

 private:
  struct First {
    std::int64_t id;
    std::size_t end;  ///< end of its record in records_; it starts where the previous one ends
  };

  std::size_t keep() override { return firsts_.size(); }
  void rewind(std::size_t position) noexcept override;
  void end(Journal::Ended how) noexcept override;

  std::vector<First> firsts_;
  std::vector<double> records_;
  IdHashMap known_;
  bool kept_ = false;
  bool complete_ = true;
};

inline void ObjectChanges::add(std::int64_t id, std::span<const double> before) {
  join();
  known_.prepare(id);
  firsts_.push_back({id, records_.size() + before.size()});
  try {
    records_.insert(records_.end(), before.begin(), before.end());
  } catch (...) {
    firsts_.pop_back();
    throw;
  }
  known_.set(id, 1);
}

inline std::size_t ObjectChanges::memory() const {
  return firsts_.capacity() * sizeof(First) + records_.capacity() * sizeof(double) + known_.memory();
}

inline void ObjectChanges::rewind(std::size_t position) noexcept {
  for (; firsts_.size() > position; firsts_.pop_back()) known_.set(firsts_.back().id, IdHashMap::unknown);
  records_.resize(firsts_.empty() ? 0 : firsts_.back().end);
}

// Also releases the memory that a large transaction took.
inline void ObjectChanges::end(Journal::Ended) noexcept {
  firsts_ = std::vector<First>();
  records_ = std::vector<double>();
  known_.clear();
  kept_ = false;
  complete_ = true;
}

}  // namespace foresee
