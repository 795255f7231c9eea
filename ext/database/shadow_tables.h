// Shadow tables of a virtual table of any kind: create, rename and drop them, and name them in SQL
// statements.
//
//   ShadowTables tables(db, {"main", "alerts"}, {{"pair", "(a, b, t, PRIMARY KEY(a, b)) WITHOUT ROWID"},
//                                                {"log", "(seq INTEGER PRIMARY KEY, op)"}});
//   tables.create();                                            // alerts_pair and alerts_log
//   Statement last = tables.statement("SELECT max(seq) FROM {log}");
//
// Each kind of virtual table declares its shadow tables in one place (shadow_schema.h for moving_objects) and
// its statements in another (shadow_rows.h). Values that a table stores about itself are in meta_rows.h;
// ascending_rows.h reads rows whose order must be checked.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "database/sqlite_api.h"
#include "database/statement.h"

namespace foresee {

/// Name of a table in SQL.
struct QualifiedName {
  std::string schema;
  std::string table;
};

/// SQLITE_CORRUPT_VTAB as StoreError: the rows of this table are damaged.
[[noreturn]] void throw_damaged(const QualifiedName& name, const std::string& what);
/// A message without the name in front that throw_damaged() writes.
std::string without_name(const QualifiedName& name, std::string_view message);

/// The table `<name>_<suffix>`, with the text of CREATE TABLE after its name.
struct ShadowTable {
  std::string suffix;
  std::string definition;
};

/// True for one of `suffixes`, in upper or lower case; used for xShadowName, which knows only the suffix.
bool is_one_of(std::string_view suffix, std::span<const char* const> suffixes);

class ShadowTables {
 public:
  ShadowTables(sqlite3* db, QualifiedName name, std::vector<ShadowTable> tables);

  sqlite3* db() const { return db_; }
  const QualifiedName& name() const { return name_; }

  void create() const;
  /// Renames the tables for a new name of the virtual table; this object keeps the old name.
  void rename(const std::string& new_table) const;
  /// Drops the tables that exist.
  void drop() const;

  /// Throws SQLITE_CORRUPT_VTAB if one of them is a view or a virtual table, which may have unlimited rows
  /// and run any code. A missing table is reported where it is read. Cost: one statement to compile, nothing
  /// read; only if a table is missing or not ordinary is sqlite_schema searched.
  void require_tables() const;

  /// A statement whose SQL names the tables by their suffixes: {pair}, {log}.
  Statement statement(const std::string& sql) const;

 private:
  std::string full_name(const std::string& suffix) const { return prefix_ + suffix + '"'; }
  bool are_tables() const;
  bool is_shadow_table(const std::string& name) const;

  sqlite3* db_;
  QualifiedName name_;
  std::vector<ShadowTable> tables_;
  std::string prefix_;  ///< prefix of their names in SQL: "main"."alerts_
};

}  // namespace foresee
