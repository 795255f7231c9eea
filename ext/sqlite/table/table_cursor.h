// Cursor over one moving_objects table: a full scan, a range of ids in order, one id, or the table's handle.
//
// A scan reads objects leaf by leaf; after a write during the scan, one by one (see moving_objects_table.h).
// Memory: one leaf or some thousand ids, and after such a write the ids not yet visited.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sqlite/table/moving_objects_table.h"
#include "sqlite/table/rising_ids.h"
#include "sqlite/table/table_plan.h"

namespace foresee {

class TableCursor : public sqlite3_vtab_cursor {
 public:
  explicit TableCursor(MovingObjectsTable& table);
  ~TableCursor();
  TableCursor(const TableCursor&) = delete;
  TableCursor& operator=(const TableCursor&) = delete;

  /// xFilter: moves to the first row of the plan, if it has any.
  void filter(const TablePlan& plan, sqlite3_value** arguments);
  void next();
  bool at_end() const { return position_ >= ids_.size(); }
  std::int64_t rowid() const { return ids_[position_]; }
  void column(sqlite3_context* context, int column) const;

  /// Before a change: makes the rest of the scan independent of leaves and of the order of ids.
  void keep_ids();
  /// After a rollback: the table may have older contents than the scan has read, so it cannot continue.
  void abort() { aborted_ = source_ != Source::list; }

 private:
  /// Where rows come from after those of ids_.
  enum class Source : std::uint8_t { list, leaves, walk };

  void clear();
  void advance();
  void skip_plans();
  void seek_object(sqlite3_value* id);
  void seek_range(const TablePlan& plan, sqlite3_value** arguments);
  void require_handle_word(sqlite3_value* word) const;
  void start_scan();
  void next_leaf();
  void keep_leaves();
  void keep_walk();
  void seek_in_walk();
  [[noreturn]] void throw_aborted() const;
  void seek_existing();
  void read_record() const;
  /// The record of the current row. A walk reads it when it is needed.
  const double* record() const {
    if (records_.empty()) read_record();
    return records_.data() + (source_ == Source::leaves ? position_ * (records_.size() / ids_.size()) : 0);
  }
  void result_degrees(sqlite3_context* context, GeoColumn column) const;
  void result_form(sqlite3_context* context, double number) const;
  void result_plan_of_row(sqlite3_context* context) const;
  void result_motion(sqlite3_context* context, const MotionColumn& motion) const;

  MovingObjectsTable& table_;
  std::vector<std::int64_t> ids_;
  mutable std::vector<double> records_;  ///< of the id at position_; of leaves: of all ids_
  std::size_t position_ = 0;
  Source source_ = Source::list;
  std::int64_t leaf_ = 0;
  std::size_t found_ = 0;  ///< objects in all leaves so far
  std::optional<IdWalk> walk_;
  mutable StatementReadState statement_state_;
  mutable Flight report_ = {};                 ///< of the current row, in a table in degrees
  mutable const double* report_of_ = nullptr;  ///< … if this is its record
  mutable RisingIds rising_;
  bool handle_ = false;        ///< the only row has the table's number
  bool without_plan_ = false;  ///< as in TablePlan
  bool aborted_ = false;
};

inline TableCursor& cursor_of(sqlite3_vtab_cursor* base) {
  return *static_cast<TableCursor*>(base);
}

}  // namespace foresee
