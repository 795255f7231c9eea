// Cache of table look-ups: SQLite resolves a name once, and again only after a schema change.
//
//   const TableName name{.table = "ships", .schema = {}};
//   lookups.number_of(name)          // the table's number on this connection, or nothing
//   lookups.keep(name, 7, "main")    // with the schema that holds it: the next look-up is cached
//
// The look-up is SELECT "ships" FROM "ships" WHERE "ships" MATCH 'foresee-handle', which a
// moving_objects table answers with its number (Connection::announce). The cache keeps a witness per name: a
// statement that reads the schema in which the table was found. SQLite recompiles it when that schema has
// changed, and all statements when temp changes or a database is detached. Until then the name refers to the
// same table. A witness starts to read that database, as the table would, but keeps no table connected. After
// its database is detached, a table and its memory are released with the next statement of any kind.
//
// finalize() must be called when SQLite disconnects a table-valued function: sqlite3_close() disconnects all
// tables and then fails if a statement is left. Cost: about a microsecond.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "database/statement.h"

namespace foresee {

struct TableName {
  std::optional<std::string> table;
  std::optional<std::string> schema;

  friend bool operator==(const TableName&, const TableName&) = default;
};

class TableLookups {
 public:
  explicit TableLookups(sqlite3* db) : db_(db) {}

  /// The table's number from the cache, else from SQLite. Throws StoreError if SQLite finds no such table, or
  /// one of another kind. Requires: `name.table` has a value.
  std::optional<std::int64_t> number_of(const TableName& name);
  /// The cached number if the name certainly still refers to that table; else nothing. Runs the witness, so
  /// SQLite may disconnect tables meanwhile.
  std::optional<std::int64_t> kept_number(const TableName& name);
  /// Caches the number, so that the next number_of(name) needs no look-up by SQLite. Does nothing if an
  /// authorizer forbids reading the schema. Requires: number_of(name) has just returned it for a table in
  /// `schema`.
  void keep(const TableName& name, std::int64_t number, const std::string& schema);
  /// Removes the name from the cache: SQLite resolves it again next time.
  void forget(const TableName& name) noexcept;
  /// Finalizes all statements that are not running.
  void finalize() noexcept;

 private:
  struct Kept {
    TableName name;
    std::int64_t number;
    Statement witness;
  };
  static constexpr std::size_t max_kept = 8;

  /// The number from SQLite's look-up; nothing if the table that it finds answers without one. Throws as
  /// number_of() does.
  std::optional<std::int64_t> query_sqlite(const TableName& name);

  sqlite3* db_;
  std::vector<Kept> kept_;  ///< the most recent last
};

}  // namespace foresee
