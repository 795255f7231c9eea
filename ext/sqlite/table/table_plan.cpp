#include "sqlite/table/table_plan.h"

#include <span>

namespace foresee::sqlite {
namespace {

using Constraint = sqlite3_index_info::sqlite3_index_constraint;

void use(sqlite3_index_info* info, std::size_t constraint, TablePlan plan, bool sqlite_need_not_check) {
  info->aConstraintUsage[constraint].argvIndex = 1;
  info->aConstraintUsage[constraint].omit = sqlite_need_not_check ? 1 : 0;
  info->idxNum = static_cast<int>(plan);
  info->estimatedRows = 1;
  info->estimatedCost = 30;
  info->idxFlags = SQLITE_INDEX_SCAN_UNIQUE;
}

}  // namespace

int plan_table(const MovingObjectsTable& table, sqlite3_index_info* info) {
  const std::span<const Constraint> constraints(info->aConstraint,
                                                static_cast<std::size_t>(info->nConstraint));
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    if (constraints[i].op != SQLITE_INDEX_CONSTRAINT_MATCH) continue;
    // A MATCH that no plan takes would fail in SQLite with less of an explanation.
    if (!constraints[i].usable) return SQLITE_CONSTRAINT;
    if (constraints[i].iColumn == table.command_column()) {
      use(info, i, TablePlan::handle, true);
      return SQLITE_OK;
    }
  }
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    const Constraint& constraint = constraints[i];
    const bool on_id = constraint.iColumn < 0 || constraint.iColumn == MovingObjectsTable::id_column;
    if (constraint.usable && on_id && constraint.op == SQLITE_INDEX_CONSTRAINT_EQ) {
      use(info, i, TablePlan::one_object, false);
      return SQLITE_OK;
    }
  }
  // As R*Tree without statistics: large enough that every other plan looks better.
  constexpr double rows = 1048576;
  info->idxNum = static_cast<int>(TablePlan::scan);
  info->estimatedRows = static_cast<sqlite3_int64>(rows);
  info->estimatedCost = 2 * rows;
  return SQLITE_OK;
}

}  // namespace foresee::sqlite
