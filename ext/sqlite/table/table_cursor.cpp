#include "sqlite/table/table_cursor.h"

#include <algorithm>
#include <cmath>

#include "database/value_text.h"
#include "sqlite/table/degrees_columns.h"

namespace foresee {

TableCursor::TableCursor(MovingObjectsTable& table) : sqlite3_vtab_cursor{}, table_(table) {
  table_.scan_opened(*this);
}

TableCursor::~TableCursor() {
  table_.scan_closed(*this);
}

void TableCursor::clear() {
  ids_.clear();
  records_.clear();
  position_ = 0;
  leaf_ = 0;
  found_ = 0;
  report_of_ = nullptr;
  source_ = Source::list;
  walk_.reset();
  handle_ = aborted_ = without_plan_ = false;
}

void TableCursor::filter(const TablePlan& plan, sqlite3_value** arguments) {
  clear();
  table_.start_statement();
  switch (plan.kind) {
    case TablePlan::scan:
      start_scan();
      break;
    case TablePlan::one_object:
      return seek_object(arguments[0]);
    case TablePlan::ids:
      seek_range(plan, arguments);
      break;
    case TablePlan::handle:
      require_handle_word(arguments[0]);
      table_.store();  // throws for a table that cannot be read
      handle_ = true;
      ids_.push_back(0);
      return;
  }
  without_plan_ = plan.without_plan;
  skip_plans();
}

void TableCursor::seek_object(sqlite3_value* value) {
  // SQLite compares again with the column's affinity; here a superset of the equal ids suffices.
  const int type = sqlite3_value_numeric_type(value);
  if (type != SQLITE_INTEGER && type != SQLITE_FLOAT) return;
  const std::int64_t id = sqlite3_value_int64(value);
  if (type == SQLITE_FLOAT && static_cast<double>(id) != sqlite3_value_double(value)) return;
  Store& store = table_.store();
  if (const auto first = rising_.next(id)) store.fetch_ahead(*first, RisingIds::batch);
  const std::span<const double> record = store.find(id, statement_state_);
  if (record.empty()) return;
  ids_.push_back(id);
  records_.assign(record.begin(), record.end());
}

namespace {

/// At least the ids that satisfy the bounds of a plan; SQLite compares again.
IdRange range_of(const TablePlan& plan, sqlite3_value** arguments) {
  constexpr double beyond = 0x1p63;
  IdRange range;
  if (plan.has_first) {
    sqlite3_value* const value = *arguments++;
    const double number = sqlite3_value_double(value);
    const int type = sqlite3_value_type(value);
    if (type == SQLITE_NULL || (type == SQLITE_FLOAT && number >= beyond)) return {1, 0};
    if (type == SQLITE_INTEGER || (type == SQLITE_FLOAT && number > -beyond))
      range.first = sqlite3_value_int64(value);
  }
  if (plan.has_last) {
    sqlite3_value* const value = *arguments;
    const double number = std::ceil(sqlite3_value_double(value));
    const int type = sqlite3_value_type(value);
    if (type == SQLITE_NULL || (type == SQLITE_FLOAT && number < -beyond)) return {1, 0};
    if (type == SQLITE_INTEGER) range.last = sqlite3_value_int64(value);
    if (type == SQLITE_FLOAT && number < beyond) range.last = static_cast<std::int64_t>(number);
  }
  return range;
}

}  // namespace

void TableCursor::seek_range(const TablePlan& plan, sqlite3_value** arguments) {
  const IdRange range = range_of(plan, arguments);
  if (range.is_empty()) return;
  walk_ = table_.store().walk_ids(range, plan.order);
  if (!walk_) return start_scan();
  source_ = Source::walk;
  seek_in_walk();
}

void TableCursor::require_handle_word(sqlite3_value* word) const {
  if (text_of(word) != handle_word)
    throw Error(table_.name +
                " MATCH: a table of moving objects has no text to search; query predictive_join or "
                "another of foresee's functions");
}

void TableCursor::start_scan() {
  source_ = Source::leaves;
  next_leaf();
}

void TableCursor::next_leaf() {
  position_ = 0;
  Node leaf;  // in the memory of the last one
  leaf.keys.swap(ids_);
  leaf.values.swap(records_);
  leaf_ = table_.store().next_leaf(leaf_, leaf);
  if (leaf_ != 0) {
    found_ += leaf.size();
    leaf.keys.swap(ids_);
    leaf.values.swap(records_);
    return;
  }
  source_ = Source::list;
  table_.store().expect_objects(found_);
}

void TableCursor::throw_aborted() const {
  throw StoreError(SQLITE_ABORT, table_.name + ": a rollback ended the scan");
}

void TableCursor::next() {
  advance();
  skip_plans();
}

void TableCursor::skip_plans() {
  if (!without_plan_) return;
  const Offsets& at = table_.store().format().at;
  for (unsigned skipped = 0; !at_end() && has_plan(at, record()); advance())
    if (++skipped % 1024 == 0) table_.connection->interrupt().check();
}

void TableCursor::advance() {
  if (aborted_) throw_aborted();
  ++position_;
  report_of_ = nullptr;
  switch (source_) {
    case Source::leaves:
      if (position_ == ids_.size()) next_leaf();
      return;
    case Source::walk:
      return seek_in_walk();
    case Source::list:
      return seek_existing();
  }
}

void TableCursor::seek_in_walk() {
  records_.clear();
  if (position_ < ids_.size()) return;
  position_ = 0;
  if (!table_.store().next_ids(*walk_, ids_)) source_ = Source::list;
}

void TableCursor::read_record() const {
  if (aborted_) throw_aborted();
  Store& store = table_.store();
  if (const auto first = rising_.next(rowid())) store.fetch_ahead(*first, RisingIds::batch);
  const std::span<const double> record = store.find(rowid(), statement_state_);
  if (record.empty()) store.damaged("object " + std::to_string(rowid()) + " is in no leaf");
  records_.assign(record.begin(), record.end());
}

/// Moves to the first id at or after the position whose object still exists, and reads it.
void TableCursor::seek_existing() try {
  for (; position_ < ids_.size(); ++position_) {
    if (auto record = table_.store().read(ids_[position_])) {
      records_ = std::move(*record);
      return;
    }
  }
} catch (const StoreError& error) {
  if (error.code != SQLITE_ERROR) throw;
  throw_aborted();  // no shadow table has this name: SQLite has rolled back a RENAME, and makes no callback for that
}

void TableCursor::keep_ids() {
  if (aborted_) return;
  if (source_ == Source::leaves) keep_leaves();
  if (source_ == Source::walk) keep_walk();
}

void TableCursor::keep_walk() {
  record();  // of the current row as it is before the change
  std::vector<std::int64_t> rest(ids_.begin() + static_cast<std::ptrdiff_t>(position_), ids_.end());
  IdWalk walk = *walk_;  // a copy: if the map cannot be read, the scan keeps its state
  for (std::vector<std::int64_t> ids; table_.store().next_ids(walk, ids);)
    rest.insert(rest.end(), ids.begin(), ids.end());
  ids_ = std::move(rest);
  position_ = 0;
  source_ = Source::list;
}

void TableCursor::keep_leaves() {
  std::vector<std::int64_t> rest(ids_.begin() + static_cast<std::ptrdiff_t>(position_), ids_.end());
  Node leaf;
  std::size_t found = found_;  // a copy: if a leaf cannot be read, the scan keeps its state
  for (NodeNumber number = leaf_; (number = table_.store().next_leaf(number, leaf)) != 0;) {
    rest.insert(rest.end(), leaf.keys.begin(), leaf.keys.end());
    found += leaf.size();
  }
  table_.store().expect_objects(found);
  const std::size_t size = records_.size() / ids_.size();
  const auto record = records_.begin() + static_cast<std::ptrdiff_t>(position_ * size);
  records_ = std::vector<double>(record, record + static_cast<std::ptrdiff_t>(size));
  ids_ = std::move(rest);
  position_ = 0;
  report_of_ = nullptr;
  source_ = Source::list;
}

/// Well-known text, NULL for an object without a shape; no result if an UPDATE does not change the column.
void TableCursor::result_form(sqlite3_context* context, double number) const {
  if (number == 0 || sqlite3_vtab_nochange(context)) return;
  const std::string text = table_.store().form(static_cast<std::int64_t>(number), statement_state_)->text();
  sqlite3_result_text(context, text.data(), static_cast<int>(text.size()), SQLITE_TRANSIENT);
}

/// The plan that the row has now: during a scan it may have got another one. No result for a row without a plan, and
/// where an UPDATE does not change the column, so that it is neither printed nor parsed.
void TableCursor::result_plan_of_row(sqlite3_context* context) const {
  if (sqlite3_vtab_nochange(context)) return;
  Store& store = table_.store();
  const std::span<const double> record = store.find(rowid(), statement_state_);
  if (record.empty() || !has_plan(store.format().at, record.data())) return;
  Interrupt& interrupt = table_.connection->interrupt();
  const PlanValues plans(table_.declaration(), interrupt);
  const Plan plan = store.read_plan(rowid(), record);
  result_plan(context,
              table_.declaration().frame.in_degrees()
                  ? plans.shown(plan, store.frame_of_objects(&statement_state_))
                  : plan,
              interrupt);
}

void TableCursor::result_motion(sqlite3_context* context, const MotionColumn& motion) const {
  if (motion.geo != GeoColumn::none) return result_degrees(context, motion.geo);
  if (motion.is_plan) return result_plan_of_row(context);
  const Layout& layout = table_.declaration().layout;
  const bool follows_plan = layout.has_plan && static_cast<std::size_t>(motion.place) < leg_doubles(layout);
  if (follows_plan && sqlite3_vtab_nochange(context)) return;
  const double number = record()[motion.place];
  if (motion.is_form) return result_form(context, number);
  if (motion.is_kind) return sqlite3_result_int64(context, static_cast<sqlite3_int64>(number));
  if (std::isfinite(number)) sqlite3_result_double(context, number);  // an infinite until reads as NULL
}

/// An UPDATE that does not change the column gets no value.
void TableCursor::result_degrees(sqlite3_context* context, GeoColumn column) const {
  if (sqlite3_vtab_nochange(context)) return;
  if (report_of_ != record()) {
    report_ = shown_report(table_.store(), rowid(), record(), &statement_state_);
    report_of_ = record();
  }
  if (const auto number = shown_number(column, report_)) sqlite3_result_double(context, *number);
}

void TableCursor::column(sqlite3_context* context, int column) const {
  if (handle_) {
    if (column == table_.command_column()) sqlite3_result_int64(context, table_.number);
    return;
  }
  const int auxiliary = column - table_.first_auxiliary_column();
  if (column == MovingObjectsTable::id_column) {
    sqlite3_result_int64(context, rowid());
  } else if (auxiliary < 0) {
    const auto motion = static_cast<std::size_t>(column - MovingObjectsTable::first_motion_column);
    const Declaration& declaration = table_.declaration();
    const MotionColumn& written = declaration.columns[motion];
    if (declaration.layout.has_plan || written.geo != GeoColumn::none || written.is_form || written.is_kind)
      return result_motion(context, written);
    const double number = record()[written.place];
    if (std::isfinite(number)) sqlite3_result_double(context, number);  // an infinite until reads as NULL
  } else if (column > table_.command_column()) {
    const auto hidden = static_cast<std::size_t>(column - table_.command_column() - 1);
    if (!sqlite3_vtab_nochange(context))
      sqlite3_result_double(context, record()[table_.hidden_place(hidden)]);
  } else if (column < table_.command_column() && !sqlite3_vtab_nochange(context)) {
    table_.store().result_auxiliary(context, rowid(), auxiliary);
  }
}

}  // namespace foresee
