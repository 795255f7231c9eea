// Objects that INSERT and UPDATE have written and that are not in the tree yet.
//
//   pending.add(42, record);
//   pending.find(42)                           // its record, or null
//   pending.remove_all();                      // the tree has them now
//
// Written objects wait here, so that objects of many statements go into the tree together; until then the
// tree has the old record of an updated object. Objects are only appended. An erased or replaced object
// leaves a hole, so a rollback truncates the end and fills holes again.
#pragma once

#include <span>

#include "storage/journal/journal.h"
#include "storage/rows/id_hash_map.h"

namespace foresee {

class PendingObjects final : public Journal::Participant {
 public:
  PendingObjects(Journal& journal, std::size_t record_size)
      : Participant(journal, Scope::marks), record_size_(record_size) {}

  std::size_t count() const { return now_.count; }
  std::size_t memory() const;
  /// The number of changes that a rewind may undo.
  std::size_t kept() const { return log_.size(); }
  /// Valid until the next add() or replace().
  const double* find(std::int64_t id) const noexcept;

  // Each of these is atomic.
  /// Requires: the id is not pending. Cost: a copy of the record.
  void add(std::int64_t id, std::span<const double> record);
  /// Requires: the id is pending.
  void erase(std::int64_t id);
  void replace(std::int64_t id, std::span<const double> record);
  /// Removes all objects; a rewind brings them back.
  void remove_all();

  /// All ids and records, in the order of arrival. Requires: no holes.
  bool has_holes() const { return now_.count != now_.ids.size(); }
  std::span<const std::int64_t> all_ids() const { return now_.ids; }
  std::span<const double> all_records() const { return now_.records; }

  /// Calls each(id, record) for every object, in the order of arrival.
  template <class Each>
  void for_each(Each each) const {
    for (std::size_t slot = 0; slot < now_.ids.size(); ++slot)
      if (!has_holes() || now_.slots.find(now_.ids[slot]) == static_cast<std::int64_t>(slot))
        each(now_.ids[slot], record_at(slot));
  }

 private:
  struct Objects {
    std::vector<std::int64_t> ids = {};
    std::vector<double> records = {};
    IdHashMap slots = {};
    std::size_t count = 0;
  };
  struct Change {
    enum class Kind : std::uint8_t { added, erased, all_removed } kind;
    std::uint32_t slot = 0;
  };

  std::size_t keep() override { return log_.size(); }
  void rewind(std::size_t position) noexcept override;
  void undo(const Change& change) noexcept;
  void merge(std::size_t newer) noexcept override;
  void forget() noexcept override;
  void end(Journal::Ended how) noexcept override;

  /// Reserves memory for one object and `changes` log entries, by doubling: what follows cannot throw.
  void reserve(std::int64_t id, std::size_t changes);
  std::span<const double> record_at(std::size_t slot) const {
    return {now_.records.data() + slot * record_size_, record_size_};
  }

  std::size_t record_size_;
  Objects now_;
  std::vector<Change> log_;
  std::vector<Objects> removed_;  ///< what remove_all() has removed, oldest first
};

}  // namespace foresee
