// Gives a watch the tables of format 2: indexes in place of key tables, and waiting pairs that are due at their start.
//
//   make_format_2(db, "alerts");               // right after CREATE or 'rebuild': the times of all rows are exact
#pragma once

#include "sqlite/database.h"

namespace foresee::testing {

inline void make_format_2(Database& db, const std::string& watch) {
  std::string sql =
      "CREATE TABLE kept AS SELECT * FROM %_pair; DROP TABLE %_pair; DROP TABLE %_back; DROP TABLE %_due;"
      "CREATE TABLE %_pair(a INTEGER, b INTEGER, t REAL, due REAL, state INTEGER, told REAL, PRIMARY KEY(a, "
      "b), "
      "UNIQUE(b, a), UNIQUE(state, due, a, b)) WITHOUT ROWID;"
      "INSERT INTO %_pair SELECT a, b, t, iif(state = 0, t, due), state, told FROM kept; DROP TABLE kept;"
      "DELETE FROM %_meta WHERE key = 'key_tables'; UPDATE %_meta SET value = 2 WHERE key = 'format'";
  for (std::size_t at; (at = sql.find('%')) != std::string::npos;) sql.replace(at, 1, watch);
  db.exec(sql);
}

}  // namespace foresee::testing
