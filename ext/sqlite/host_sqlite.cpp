#include "sqlite/host_sqlite.h"

#include <cstdint>
#include <utility>

#include "base/error.h"
#include "database/statement.h"
#include "sqlite/version.h"

namespace foresee {
namespace {

// Versions as sqlite3_libversion_number() returns them.
constexpr int oldest_supported = 3031000;
constexpr int reports_constraints = 3038000;  // sqlite3_vtab_in, sqlite3_vtab_rhs_value
constexpr int reports_schemas = 3039000;      // sqlite3_db_name

bool host_has(int since) {
  return sqlite3_libversion_number() >= since;
}

}  // namespace

void require_version(int number, const char* host) {
  if (number >= oldest_supported) return;
  throw Error(std::string("foresee ") + version() + " needs SQLite 3.31 or newer, and this program has " +
              host);
}

bool may_be_list(sqlite3_index_info& info, int i) {
  return !host_has(reports_constraints) || sqlite3_vtab_in(&info, i, -1) != 0;
}

bool is_spare_list(sqlite3_index_info& info, int i, int other) {
  return may_be_list(info, i) && (other < i || !may_be_list(info, other));
}

sqlite3_stmt* statement_in_preparation(sqlite3* db) {
  // SQLite lists the newest statement first, and stores the text at the end of the preparation.
  sqlite3_stmt* statement = sqlite3_next_stmt(db, nullptr);
  while (statement && sqlite3_sql(statement)) statement = sqlite3_next_stmt(db, statement);
  return statement;
}

sqlite3_value* written_value(sqlite3_index_info& info, int i) {
  sqlite3_value* value = nullptr;
  if (!host_has(reports_constraints) || sqlite3_vtab_rhs_value(&info, i, &value) != SQLITE_OK) return nullptr;
  return value;
}

std::vector<std::string> schema_names(sqlite3* db) {
  std::vector<std::string> names;
  // SQLite numbers main 0 and temp 1, and searches temp first.
  const auto add = [&](std::int64_t place, std::string name) {
    names.insert(place == 1 ? names.begin() : names.end(), std::move(name));
  };
  if (host_has(reports_schemas)) {
    for (int place = 0; const char* name = sqlite3_db_name(db, place); ++place) add(place, name);
  } else {
    Statement schemas(db, "PRAGMA database_list");
    for (Statement::Run run(schemas); run.step();) add(run.integer(0), run.text(1));
  }
  return names;
}

}  // namespace foresee
