// Which objects were written and are not in the tree yet?
//
//   pending.add(42, record);
//   pending.find(42)                           // its record, or null
//   const auto position = pending.position();  // … and back to it: pending.rewind(position)
//
// What INSERT and UPDATE write waits here, so that many objects, of however many statements, go into the tree
// together; of an object that was updated the tree still has what it was. Objects are only ever appended; one
// that is erased or replaced leaves a hole, so that going back is cutting off the end and filling holes
// again.
#pragma once

#include <span>

#include "storage/rows/id_hash_map.h"

namespace foresee {

class PendingObjects {
 public:
  explicit PendingObjects(std::size_t record_size) : record_size_(record_size) {}

  std::size_t count() const { return count_; }
  std::size_t memory() const;
  /// Valid until the next add() or replace().
  const double* find(std::int64_t id) const noexcept;

  // Each all or nothing.
  /// Requires: not here. Cost: a copy of the record.
  void add(std::int64_t id, std::span<const double> record);
  /// Requires: here.
  void erase(std::int64_t id);
  void replace(std::int64_t id, std::span<const double> record);

  std::size_t position() const { return log_.size(); }
  void rewind(std::size_t position) noexcept;
  /// Nobody goes back to now or before: drops the log, and holes where they are the most of it.
  void forget_past() noexcept;
  void clear() noexcept;

  /// All of them side by side, in the order of their arrival, where none has left a hole.
  bool has_holes() const { return count_ != ids_.size(); }
  std::span<const std::int64_t> all_ids() const { return ids_; }
  std::span<const double> all_records() const { return records_; }

  /// Calls each(id, record) for every object in the order of their arrival.
  template <class Each>
  void for_each(Each each) const {
    for (std::size_t slot = 0; slot < ids_.size(); ++slot)
      if (!has_holes() || slots_.find(ids_[slot]) == static_cast<std::int64_t>(slot))
        each(ids_[slot], std::span<const double>(records_.data() + slot * record_size_, record_size_));
  }

 private:
  struct Change {
    std::uint32_t slot;
    bool added;  ///< else erased
  };

  /// Room for one object and so many entries of the log, by doubling: what follows cannot throw.
  void reserve(std::int64_t id, std::size_t changes);

  std::size_t record_size_;
  std::vector<std::int64_t> ids_;
  std::vector<double> records_;
  IdHashMap slots_;
  std::vector<Change> log_;
  std::size_t count_ = 0;
};

}  // namespace foresee
