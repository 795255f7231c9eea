// Changes of objects that the tree does not have yet: records that INSERT and UPDATE have written, and the ids of
// objects that DELETE has erased.
//
//   pending.add(42, record, leaf);
//   pending.find(42)                           // its record, or null
//   pending.erase_stored(7);                   // of an object that the tree has
//   pending.remove_all();                      // the tree has all changes now
//
// Changes wait here, so that those of many statements go into the tree together. Until then the tree has the old
// record of an updated object, and the objects that are erased. The leaf in which the tree has the old record, if it
// was looked up, waits with the new one. Objects are only appended. One that is erased or replaced while it is
// pending leaves a hole, so a rollback truncates the end and fills holes again.
#pragma once

#include <span>

#include "database/id_hash_map.h"
#include "database/journal.h"

namespace foresee {

class PendingObjects final : public Journal::Participant {
 public:
  PendingObjects(Journal& journal, std::size_t record_size)
      : Participant(journal, Scope::marks), record_size_(record_size) {}

  /// Of the records.
  std::size_t count() const { return now_.count; }
  bool is_empty() const { return now_.count == 0 && now_.erased.empty(); }
  std::size_t memory() const;
  /// The number of changes that a rewind may undo.
  std::size_t kept() const { return log_.size(); }
  /// Valid until the next add() or replace().
  const double* find(std::int64_t id) const noexcept;
  /// The leaf that was added with the record; 0: not known.
  std::int64_t leaf_of(std::int64_t id) const noexcept {
    const std::int64_t slot = now_.leaves.empty() ? -1 : now_.slots.find(id);
    return slot < 0 ? 0 : now_.leaves[static_cast<std::size_t>(slot)];
  }
  /// Whether the tree has the object, but should not.
  bool is_erased(std::int64_t id) const noexcept {
    return !now_.erased.empty() && now_.slots.find(id) == erased;
  }
  /// At least the number of those objects.
  std::size_t erased_count() const { return now_.erased.size(); }
  /// Of the objects in the tree, ascending.
  std::vector<std::int64_t> erased_ids() const;

  // Each of these is atomic.
  /// `leaf`: of the object in the tree; 0: not known, or it is new. Requires: no record of the id is pending. Cost: a
  /// copy of the record.
  void add(std::int64_t id, std::span<const double> record, std::int64_t leaf = 0);
  /// Requires: a record of the id is pending.
  void erase(std::int64_t id);
  /// Requires: the tree has the object, and nothing of it is pending.
  void erase_stored(std::int64_t id);
  void replace(std::int64_t id, std::span<const double> record);
  /// Removes all objects; a rewind brings them back.
  void remove_all();

  /// A record that has been pending since the last remove_all(). Requires: count() > 0.
  std::span<const double> first_record() const { return record_at(0); }
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
  static constexpr std::int64_t erased = -2;  ///< in place of a slot
  struct Objects {
    std::vector<std::int64_t> erased = {};  ///< of the tree, with some that are pending again
    std::vector<std::int64_t> ids = {};
    std::vector<double> records = {};
    std::vector<std::int64_t> leaves = {};  ///< empty if none is known
    IdHashMap slots = {};
    std::size_t count = 0;
  };
  struct Change {
    enum class Kind : std::uint8_t { added, added_again, erased, stored_erased, all_removed } kind;
    std::uint32_t slot = 0;
  };

  std::size_t keep() override { return log_.size(); }
  void rewind(std::size_t position) noexcept override;
  void undo(const Change& change) noexcept;
  void merge(std::size_t newer) noexcept override;
  void forget() noexcept override;
  void end(Journal::Ended how) noexcept override;

  /// Reserves memory for one object and `changes` log entries, by doubling: what follows cannot throw.
  void reserve(std::int64_t id, std::int64_t leaf, std::size_t changes);
  std::span<const double> record_at(std::size_t slot) const {
    return {now_.records.data() + slot * record_size_, record_size_};
  }

  std::size_t record_size_;
  Objects now_;
  std::vector<Change> log_;
  std::vector<Objects> removed_;  ///< what remove_all() has removed, oldest first
};

}  // namespace foresee
