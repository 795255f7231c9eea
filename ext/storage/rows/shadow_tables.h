// The ordinary tables behind a virtual table, of whatever kind it is: made, renamed, dropped and named in
// SQL.
//
//   ShadowTables tables(db, {"main", "alerts"}, {{"pair", "(a, b, t, PRIMARY KEY(a, b)) WITHOUT ROWID"},
//                                                {"log", "(seq INTEGER PRIMARY KEY, op)"}});
//   tables.create();                                            // alerts_pair and alerts_log
//   Statement last = tables.statement("SELECT max(seq) FROM {log}");
//
// A kind of virtual table says which tables it has in one place (shadow_schema.h does for moving_objects) and
// what it asks of them in another (shadow_rows.h). meta_rows.h is for what a table says about itself,
// ascending_rows.h reads rows whose order must not be believed.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "storage/rows/sqlite_api.h"
#include "storage/rows/statement.h"

namespace foresee {

/// A table as SQL names it.
struct QualifiedName {
  std::string schema;
  std::string table;
};

/// `<name>_<suffix>`, and what CREATE TABLE says behind its name.
struct ShadowTable {
  std::string suffix;
  std::string definition;
};

/// True for one of `suffixes`, in upper or lower case: for xShadowName, which knows no more of the table.
bool is_one_of(std::string_view suffix, std::span<const char* const> suffixes);

class ShadowTables {
 public:
  ShadowTables(sqlite3* db, QualifiedName name, std::vector<ShadowTable> tables);

  sqlite3* db() const { return db_; }
  const QualifiedName& name() const { return name_; }

  void create() const;
  /// They are another virtual table's from now on; this object still goes by the old name.
  void rename(const std::string& new_table) const;
  /// Tables that are missing are no obstacle.
  void drop() const;

  /// Throws SQLITE_CORRUPT_VTAB if one of them is a view or a virtual table, which may have rows without end
  /// and run what they like. One that is missing says so where it is read. Cost: one statement is compiled,
  /// nothing read; only what is no table is looked for in sqlite_schema.
  void require_tables() const;

  /// A statement whose SQL names the tables by their suffixes: {pair}, {log}.
  Statement statement(const std::string& sql) const;

 private:
  std::string full_name(const std::string& suffix) const { return prefix_ + suffix + '"'; }
  bool are_tables() const;
  bool is_ours(const std::string& name) const;

  sqlite3* db_;
  QualifiedName name_;
  std::vector<ShadowTable> tables_;
  std::string prefix_;  ///< of their names in SQL: "main"."alerts_
};

}  // namespace foresee
