// Log of the objects that a transaction changes, each with its record from before the transaction.
//
//   if (!changes.knows(42)) changes.add(42, record);     // before the first change; {}: a new object
//   changes.for_each([&](std::int64_t id, std::span<const double> before) { … });
//   const auto position = changes.position();            // later: changes.rewind(position)
//
// The first change of an object keeps its record, later changes keep nothing: the store has the current
// record. A rollback to a savepoint forgets the objects that had not been changed before it. Cost: a look-up
// per change, and about 40 bytes and the record per changed object.
#pragma once

#include <span>

#include "storage/rows/id_hash_map.h"

namespace foresee {

class ObjectChanges {
 public:
  bool knows(std::int64_t id) const noexcept { return known_.find(id) != IdHashMap::unknown; }
  /// Requires: not known. `before`: the object's record, empty for a new object. Atomic.
  void add(std::int64_t id, std::span<const double> before);

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

  std::size_t position() const { return firsts_.size(); }
  void rewind(std::size_t position) noexcept;
  void clear() noexcept;

 private:
  struct First {
    std::int64_t id;
    std::size_t end;  ///< end of its record in records_; it starts where the previous one ends
  };

  std::vector<First> firsts_;
  std::vector<double> records_;
  IdHashMap known_;
};

}  // namespace foresee
