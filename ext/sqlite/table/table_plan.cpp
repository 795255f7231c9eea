#include "sqlite/table/table_plan.h"

#include <algorithm>
#include <span>

#include "sqlite/host_sqlite.h"

namespace foresee {
namespace {

using IndexConstraint = sqlite3_index_info::sqlite3_index_constraint;

void use(sqlite3_index_info* info, std::size_t constraint, TablePlan::Kind plan, bool omits_check) {
  info->aConstraintUsage[constraint].argvIndex = 1;
  info->aConstraintUsage[constraint].omit = omits_check ? 1 : 0;
  info->idxNum = plan;
  info->estimatedRows = 1;
  info->estimatedCost = 20;  // SQLite's assumption for an ordinary table
  info->idxFlags = SQLITE_INDEX_SCAN_UNIQUE;
}

bool is_id(const IndexConstraint& constraint) {
  return constraint.iColumn < 0 || constraint.iColumn == MovingObjectsTable::id_column;
}

bool is_lower_bound(unsigned char op) {
  return op == SQLITE_INDEX_CONSTRAINT_GT || op == SQLITE_INDEX_CONSTRAINT_GE;
}

bool is_upper_bound(unsigned char op) {
  return op == SQLITE_INDEX_CONSTRAINT_LT || op == SQLITE_INDEX_CONSTRAINT_LE;
}

bool is_bound(unsigned char op) {
  return is_lower_bound(op) || is_upper_bound(op);
}

bool is_limit(unsigned char op) {
  return op == SQLITE_INDEX_CONSTRAINT_LIMIT || op == SQLITE_INDEX_CONSTRAINT_OFFSET;
}

/// No other column than the id is read.
bool reads_only_ids(const sqlite3_index_info& info) {
  return (info.colUsed & ~(sqlite3_uint64{1} << MovingObjectsTable::id_column)) == 0;
}

/// Whether few rows are wanted, whatever they contain: with LIMIT, and no condition but bounds of the id.
bool wants_first_rows(const sqlite3_index_info& info) {
  const std::span constraints(info.aConstraint, static_cast<std::size_t>(info.nConstraint));
  return std::any_of(constraints.begin(), constraints.end(),
                     [](const auto& one) { return is_limit(one.op); }) &&
         std::all_of(constraints.begin(), constraints.end(),
                     [](const auto& one) { return is_limit(one.op) || (is_id(one) && is_bound(one.op)); });
}

/// The order of ids, if the query wants it and a look-up of each row costs less than a scan and a sort.
std::optional<IdOrder> order_of_ids(const sqlite3_index_info& info) {
  if (info.nOrderBy == 0) return std::nullopt;
  const int column = info.aOrderBy[0].iColumn;
  if (column >= 0 && column != MovingObjectsTable::id_column) return std::nullopt;
  if (!reads_only_ids(info) && !wants_first_rows(info)) return std::nullopt;
  return info.aOrderBy[0].desc ? IdOrder::descending : IdOrder::ascending;
}

/// The first bounds of the id become the first arguments.
TablePlan plan_of_ids(sqlite3_index_info& info) {
  TablePlan plan;
  int arguments = 0;
  const auto find = [&](bool (*is_wanted)(unsigned char)) {
    for (int i = 0; i < info.nConstraint; ++i) {
      const IndexConstraint& constraint = info.aConstraint[i];
      if (!constraint.usable || !is_id(constraint) || !is_wanted(constraint.op)) continue;
      info.aConstraintUsage[i].argvIndex = ++arguments;
      return true;
    }
    return false;
  };
  plan.has_first = find(is_lower_bound);
  plan.has_last = find(is_upper_bound);
  plan.order = order_of_ids(info);
  if (plan.has_first || plan.has_last || plan.order) plan.kind = TablePlan::ids;
  return plan;
}

/// False for the rowid and the hidden columns too.
bool is_plan(const MovingObjectsTable& table, int column) {
  const auto& columns = table.declaration().columns;
  const auto motion = static_cast<std::size_t>(column - MovingObjectsTable::first_motion_column);
  return column >= MovingObjectsTable::first_motion_column && motion < columns.size() &&
         columns[motion].is_plan;
}

int count_arguments(const sqlite3_index_info& info) {
  const std::span usages(info.aConstraintUsage, static_cast<std::size_t>(info.nConstraint));
  return static_cast<int>(
      std::count_if(usages.begin(), usages.end(), [](const auto& usage) { return usage.argvIndex != 0; }));
}

/// For plan IS NULL: the scan tests it, and SQLite need not. IS NOT NULL is left to SQLite: as a condition of ON, 3.40
/// offers it to the left table of a LEFT JOIN too, whose rows it must not remove.
bool wants_no_plan(const MovingObjectsTable& table, sqlite3_index_info& info) {
  for (int i = 0; i < info.nConstraint; ++i) {
    const IndexConstraint& constraint = info.aConstraint[i];
    if (!constraint.usable || constraint.op != SQLITE_INDEX_CONSTRAINT_ISNULL) continue;
    if (!is_plan(table, constraint.iColumn)) continue;
    info.aConstraintUsage[i].argvIndex = count_arguments(info) + 1;
    info.aConstraintUsage[i].omit = 1;
    return true;
  }
  return false;
}

/// Number of ids between the literal bounds of the statement, if ids count from 1; `objects` if the bounds
/// exclude every id.
double ids_between_bounds(sqlite3_index_info& info, double objects) {
  double lower = 1, upper = objects;
  for (int i = 0; i < info.nConstraint; ++i) {
    const IndexConstraint& constraint = info.aConstraint[i];
    if (!constraint.usable || !is_id(constraint) || !is_bound(constraint.op)) continue;
    sqlite3_value* written = written_value(info, i);
    if (!written || sqlite3_value_type(written) != SQLITE_INTEGER) continue;
    const double id = sqlite3_value_double(written);
    (is_lower_bound(constraint.op) ? lower : upper) = id;
  }
  return lower <= upper ? upper - lower + 1 : objects;
}

/// Whether the constraint compares with one value that is not written in the statement: perhaps one of another table.
bool may_need_another_table(sqlite3_index_info& info, int i) {
  constexpr int reported_lists = 31;  // SQLite does not report `column IN (…)` of later constraints
  const bool may_be_in =
      info.aConstraint[i].op == SQLITE_INDEX_CONSTRAINT_EQ && (i >= reported_lists || may_be_list(info, i));
  return !may_be_in && !written_value(info, i);
}

/// Estimated number of objects that satisfy all constraints. SQLite estimates ordinary tables like this, but
/// not virtual ones: a bound keeps a quarter of the rows, an equality a hundredth. If it depends on another table,
/// SQLite must know: such constraints become arguments of the scan, which ignores them. SQLite would else take
/// the estimate as that of this table alone, and could read it first.
double likely_rows(sqlite3_index_info& info, double objects) {
  double rows = objects;
  int arguments = count_arguments(info);  // of bounds of the id, and of a test for NULL
  for (int i = 0; i < info.nConstraint; ++i) {
    const IndexConstraint& constraint = info.aConstraint[i];
    if (!constraint.usable) continue;
    const bool equal =
        constraint.op == SQLITE_INDEX_CONSTRAINT_EQ || constraint.op == SQLITE_INDEX_CONSTRAINT_IS;
    if (!equal && !is_bound(constraint.op)) continue;
    rows /= equal ? 100 : 4;
    if (info.aConstraintUsage[i].argvIndex == 0 && may_need_another_table(info, i))
      info.aConstraintUsage[i].argvIndex = ++arguments;
  }
  return std::max(1.0, std::min(rows, ids_between_bounds(info, objects)));
}

/// The part of a scan's work that the plan takes. A look-up by id costs as much as three objects of a scan or more
/// (walk_ids() compares them when it runs); an id alone costs less.
double share_to_read(sqlite3_index_info& info, const TablePlan& plan, double objects) {
  if (plan.kind != TablePlan::ids) return 1;
  const double by_id = reads_only_ids(info) ? 0.5 : 3,
               bounds = (plan.has_first ? 0.25 : 1) * (plan.has_last ? 0.25 : 1);
  const double share = by_id * std::min(bounds, ids_between_bounds(info, objects) / std::max(objects, 1.0));
  return plan.order ? share : std::min(share, 1.0);
}

}  // namespace

int plan_table(const MovingObjectsTable& table, sqlite3_index_info* info) {
  const std::span<const IndexConstraint> constraints(info->aConstraint,
                                                     static_cast<std::size_t>(info->nConstraint));
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    if (constraints[i].op != SQLITE_INDEX_CONSTRAINT_MATCH) continue;
    // A MATCH that no plan uses would fail in SQLite with a less helpful message.
    if (!constraints[i].usable) return SQLITE_CONSTRAINT;
    if (constraints[i].iColumn == table.command_column()) {
      use(info, i, TablePlan::handle, true);
      return SQLITE_OK;
    }
  }
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    const IndexConstraint& constraint = constraints[i];
    if (constraint.usable && is_id(constraint) && constraint.op == SQLITE_INDEX_CONSTRAINT_EQ) {
      use(info, i, TablePlan::one_object, false);
      return SQLITE_OK;
    }
  }
  constexpr double start = 50, object = 4;  // so that a look-up costs less than any scan
  const auto objects = static_cast<double>(table.likely_objects());
  TablePlan plan = plan_of_ids(*info);
  plan.without_plan = wants_no_plan(table, *info);
  info->idxNum = plan.number();
  info->orderByConsumed = plan.order ? 1 : 0;
  info->estimatedRows = static_cast<sqlite3_int64>(likely_rows(*info, objects));
  info->estimatedCost = start + object * objects * share_to_read(*info, plan, objects);
  return SQLITE_OK;
}

}  // namespace foresee
