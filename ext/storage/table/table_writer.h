// Changing the objects of a moving_objects table: insert, update and erase, each atomic, and the log that watches read.
//
//   store.insert(42, record, auxiliaries);                // record: record_offsets(layout).size doubles
//   store.update(42, 42, record, auxiliaries);
//   store.erase(42);
//
// A change waits in memory (table_contents.h); auxiliary values, chunks of plans and forms are written at once. If a
// change throws, everything is as before. Memory is freed before a change, so that it stays atomic.
#pragma once

#include <functional>

#include "storage/nodes/object_changes.h"
#include "storage/table/table_reader.h"

namespace foresee {

class TableWriter : public TableReader {
 public:
  /// The id that SQLite gives to a row without one: the largest plus one.
  std::int64_t find_next_id();
  /// Finds or stores the outline or mesh of a well-known text (stored_forms.h), for a record to refer to by
  /// number. Throws Error for an invalid text. Requires: a layout with `shape`.
  StoredForms::Known find_or_add_form(std::string_view text, const StoredForms::Reader& read = {});
  /// Requires: no object has this id. `auxiliaries`: one value per auxiliary column. `origin`: from now on
  /// that of a table whose frame() has none. With a plan the motion of `record` becomes that of its first leg, and the
  /// table sets its numbers `plan` and `chunks`.
  void insert(std::int64_t id, std::span<const double> record, std::span<sqlite3_value*> auxiliaries,
              const std::optional<LatLon>& origin = {}, const Plan* plan = nullptr);
  /// Requires: `id` exists. Auxiliary values that are sqlite3_value_nochange stay. Another object with
  /// `new_id` is replaced, so INSERT OR REPLACE of an existing id is update(id, id, …). Without `plan` the object keeps
  /// its plan if `record` has the number of that, and its motion; 0: it has no plan any more.
  void update(std::int64_t id, std::int64_t new_id, std::span<const double> record,
              std::span<sqlite3_value*> auxiliaries, const Plan* plan = nullptr);
  void erase(std::int64_t id);  ///< requires: `id` exists

  /// Calls each(id, record) for every object that this transaction has changed, bit for bit, in the order of first
  /// changes; also if it has changed it back. An empty record: no such object. Rolled-back changes are left out. Only a
  /// transaction whose first change finds the name of a watch knows its changes. Cost: a read() per object.
  void for_each_change(const std::function<void(std::int64_t id, std::span<const double> record)>& each);
  /// The stamp before all changes of for_each_change(); nothing if these are unknown (after 'rebuild', or if they are
  /// too many for ObjectChanges).
  std::optional<std::int64_t> stamp_before_changes();
  /// The stamp before all changes of this transaction, known or not.
  std::optional<std::int64_t> stamp_at_begin();

 protected:
  using TableReader::TableReader;
  ~TableWriter() = default;

  /// Checks the record, starts the transaction, writes its stamp, frees memory. Throws before any change.
  void start_change(std::span<const double> record);
  /// Reads the names of the watches unless they are known.
  void load_watch_names();
  /// Objects that are not logged may have changed.
  void note_unknown_changes() { changes_.note_others(); }

 private:
  bool has_unwritten_changes() const override { return has_unwritten() || !changes_.are_none(); }
  /// Throws Error for a record that would be damage in a leaf.
  void require_sound(std::span<const double> record) const;
  /// For watches: logs a change of `id`. Does nothing in a table without watches.
  void log_change(std::int64_t id);
  /// The same, unless the stored record is this one. Call it before the change.
  void log_update(std::int64_t id, std::span<const double> record);
  [[noreturn]] void throw_missing(std::int64_t id) const;
  /// The plans of an update(); returns the record to store.
  std::span<const double> change_plans(StoredPlans::Change& plans, std::int64_t id, std::int64_t new_id,
                                       std::span<const double> record, const Plan* plan);
  void add(std::int64_t id, std::span<const double> record);
  void remove(std::int64_t id);
  const LargestId& read_largest();

  ObjectChanges changes_{transaction_.journal()};
};

}  // namespace foresee
