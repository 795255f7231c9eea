#include "sqlite/table/table_plan.h"

#include <algorithm>
#include <span>

#include "sqlite/host_sqlite.h"

namespace foresee {
namespace {

using IndexConstraint = sqlite3_index_info::sqlite3_index_constraint;

void use(sqlite3_index_info* info, std::size_t constraint, TablePlan plan, bool omits_check) {
  info->aConstraintUsage[constraint].argvIndex = 1;
  info->aConstraintUsage[constraint].omit = omits_check ? 1 : 0;
  info->idxNum = static_cast<int>(plan);
  info->estimatedRows = 1;
  info->estimatedCost = 20;  // SQLite's assumption for an ordinary table
  info->idxFlags = SQLITE_INDEX_SCAN_UNIQUE;
}

bool is_id(const IndexConstraint& constraint) {
  return constraint.iColumn < 0 || constraint.iColumn == MovingObjectsTable::id_column;
}

bool is_bound(unsigned char op) {
  return op == SQLITE_INDEX_CONSTRAINT_LT || op == SQLITE_INDEX_CONSTRAINT_LE ||
         op == SQLITE_INDEX_CONSTRAINT_GT || op == SQLITE_INDEX_CONSTRAINT_GE;
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
    const bool from_below =
        constraint.op == SQLITE_INDEX_CONSTRAINT_GT || constraint.op == SQLITE_INDEX_CONSTRAINT_GE;
    (from_below ? lower : upper) = id;
  }
  return lower <= upper ? upper - lower + 1 : objects;
}

/// Estimated number of objects that satisfy all constraints. SQLite estimates ordinary tables like this, but
/// not virtual ones: a bound keeps a quarter of the rows, an equality a hundredth.
double likely_rows(sqlite3_index_info& info, double objects) {
  double rows = objects;
  for (const IndexConstraint& constraint :
       std::span(info.aConstraint, static_cast<std::size_t>(info.nConstraint))) {
    if (!constraint.usable) continue;
    if (is_bound(constraint.op)) rows /= 4;
    if (constraint.op == SQLITE_INDEX_CONSTRAINT_EQ || constraint.op == SQLITE_INDEX_CONSTRAINT_IS)
      rows /= 100;
  }
  return std::max(1.0, std::min(rows, ids_between_bounds(info, objects)));
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
  info->idxNum = static_cast<int>(TablePlan::scan);
  info->estimatedRows = static_cast<sqlite3_int64>(likely_rows(*info, objects));
  info->estimatedCost = start + object * objects;
  return SQLITE_OK;
}

}  // namespace foresee
