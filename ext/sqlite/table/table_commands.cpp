#include "sqlite/table/table_commands.h"

#include <string_view>

#include "sqlite/callback.h"
#include "storage/rows/value_text.h"

namespace foresee {

void require_integrity(MovingObjectsTable& table) {
  constexpr std::size_t limit = 5;
  const std::vector<std::string> findings = table.store().integrity_check(table.connection->interrupt());
  if (findings.empty()) return;
  std::string text;
  for (std::size_t i = 0; i < findings.size() && i < limit; ++i) text += (i == 0 ? "" : "; ") + findings[i];
  if (findings.size() > limit) text += "; and " + std::to_string(findings.size() - limit) + " more";
  throw StoreError(SQLITE_CORRUPT_VTAB, table.name + ": " + text);
}

void run_command(MovingObjectsTable& table, sqlite3_value* command) {
  const std::string word = sqlite3_value_type(command) == SQLITE_TEXT ? text_of(command) : "";
  if (word == "rebuild") {
    table.store().rebuild(table.connection->interrupt());
  } else if (word == "optimize") {
    table.store().optimize(table.connection->interrupt());
  } else if (word == "integrity-check") {
    require_integrity(table);
  } else {
    throw Error(table.name + ": no command " + shown(command) +
                "; known are 'rebuild', 'optimize' and 'integrity-check'");
  }
}

}  // namespace foresee
