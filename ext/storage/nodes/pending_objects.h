// Objects that INSERT and UPDATE have written and that are not in the tree yet.
//
//   pending.add(42, record);
//   pending.find(42)                           // its record, or null
//   const auto position = pending.position();  // later: pending.rewind(position)
//
// Written objects wait here, so that objects of many statements go into the tree together; until then the
// tree has the old record of an updated object. Objects are only appended. An erased or replaced object
// leaves a hole, so a rollback truncates the end and fills holes again.
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

  // Each of these is atomic.
  /// Requires: the id is not pending. Cost: a copy of the record.
  void add(std::int64_t id, std::span<const double> record);
  /// Requires: the id is pending.
  void erase(std::int64_t id);
  void replace(std::int64_t id, std::span<const double> record);

  std::size_t position() const { return log_.size(); }
  void rewind(std::size_t position) noexcept;
  /// No rewind() to a position up to now follows: drops the log, and the holes if they are the larger part.
  void forget_past() noexcept;
  void clear() noexcept;

  /// All ids and records, in the order of arrival. Requires: no holes.
  bool has_holes() const { return count_ != ids_.size(); }
  std::span<const std::int64_t> all_ids() const { return ids_; }
  std::span<const double> all_records() const { return records_; }

  /// Calls each(id, record) for every object, in the order of arrival.
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

  /// Reserves memory for one object and `changes` log entries, by doubling: what follows cannot throw.
  void reserve(std::int64_t id, std::size_t changes);

  std::size_t record_size_;
  std::vector<std::int64_t> ids_;
  std::vector<double> records_;
  IdHashMap slots_;
  std::vector<Change> log_;
  std::size_t count_ = 0;
};

}  // namespace foresee
