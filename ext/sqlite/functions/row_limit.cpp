#include "sqlite/functions/row_limit.h"

#include "sqlite/functions/table_function.h"

namespace foresee {
namespace {

constexpr char no_column = 'A' - 1;

/// The second letter; 0 for other constraints.
char limit_letter(int op) {
  if (op == SQLITE_INDEX_CONSTRAINT_LIMIT) return 'n';
  return op == SQLITE_INDEX_CONSTRAINT_OFFSET ? 'o' : 0;
}

/// Whether the call itself leaves out what does not meet a constraint.
bool is_heeded(const TableFunction& function, const sqlite3_index_info& info, int i) {
  const auto& constraint = info.aConstraint[i];
  if (info.aConstraintUsage[i].argvIndex == 0) return false;
  if (constraint.iColumn >= static_cast<int>(function.outputs.size())) return true;
  const bool probed = function.probed >> constraint.iColumn & 1;  // of these only equality is used
  return !probed || constraint.op == SQLITE_INDEX_CONSTRAINT_EQ;
}

}  // namespace

void take_row_limit(const TableFunction& function, sqlite3_index_info& info, std::string& arguments) {
  for (int i = 0; i < info.nConstraint; ++i)
    if (!limit_letter(info.aConstraint[i].op) && !is_heeded(function, info, i)) return;
  for (int i = 0; i < info.nConstraint; ++i) {
    const char letter = limit_letter(info.aConstraint[i].op);
    if (!letter || !info.aConstraint[i].usable) continue;
    arguments += {no_column, letter};
    info.aConstraintUsage[i].argvIndex = static_cast<int>(arguments.size() / 2);
  }
}

bool read_row_limit(const char* letters, sqlite3_value* value, RowLimit& limit) {
  if (letters[0] != no_column) return false;
  (letters[1] == 'n' ? limit.rows : limit.skipped) = sqlite3_value_int64(value);
  return true;
}

}  // namespace foresee
