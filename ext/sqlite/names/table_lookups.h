// Cache of table look-ups: SQLite resolves a name once, and again only after a schema change.
//
//   const QueriedTable name{.table = "ships", .schema = {}};
//   lookups.number_of(name)          // what the table announced itself as, or nothing
//   lookups.keep(name, 7, "main")    // and where it was: next time its number is known
//
// The look-up is SELECT "ships" FROM "ships" WHERE "ships" MATCH 'foresee-handle', which a
// moving_objects table answers with its number. What is kept is a witness: a statement that reads the schema
// in which the table was found. SQLite recompiles it whenever that schema has changed, and all statements when
// temp changes or a database is detached. Until then the name means the same table. A witness starts to read
// that database, as the table would, but keeps no table connected. A table whose database is detached goes
// with the next statement of any kind, and its memory with it.
//
// finalize() must be called when SQLite disconnects a table-valued function: a connection that is being
// closed disconnects all tables and then refuses while a statement is left. Cost: about a microsecond.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "storage/rows/statement.h"

namespace foresee {

struct QueriedTable {
  std::optional<std::string> table;
  std::optional<std::string> schema;

  friend bool operator==(const QueriedTable&, const QueriedTable&) = default;
};

class TableLookups {
 public:
  explicit TableLookups(sqlite3* db) : db_(db) {}

  /// What is kept, else what SQLite says. Throws StoreError where SQLite finds no such table, or one of
  /// another kind. Requires: a table is named.
  std::optional<std::int64_t> number_of(const QueriedTable& name);
  /// The number that is kept, if it is certain that the name still means that table; else nothing. Runs its
  /// witness, so SQLite may disconnect tables meanwhile.
  std::optional<std::int64_t> kept_number(const QueriedTable& name);
  /// The next number_of(name) needs no look-up by SQLite, except where nothing can be kept. Requires:
  /// number_of(name) has just said so of a table in `schema`.
  void keep(const QueriedTable& name, std::int64_t number, const std::string& schema);
  /// The next time SQLite resolves the name from the start.
  void forget(const QueriedTable& name) noexcept;
  /// Finalizes all statements that are not running.
  void finalize() noexcept;

 private:
  struct Kept {
    QueriedTable name;
    std::int64_t number;
    Statement witness;
  };
  static constexpr std::size_t max_kept = 8;

  /// What the table that SQLite finds under the name answers; nothing if it gives no number. Throws as
  /// number_of() does.
  std::optional<std::int64_t> query_sqlite(const QueriedTable& name);

  sqlite3* db_;
  std::vector<Kept> kept_;  ///< the latest last
};

}  // namespace foresee
