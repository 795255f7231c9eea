// What does SQLite find under a table's name? The statements that ask it, kept for the next time.
//
//   lookups.number_of({.table = "ships", .schema = {}})     // what the table announced itself as, or nothing
//
// Each is SELECT "ships" FROM "ships" WHERE "ships" MATCH 'foresee-handle', which a moving_objects table
// answers with its number. SQLite compiles it anew whenever a schema that it reads has changed, and all
// statements when temp changes or a database is detached. A compiled statement keeps its table connected, so
// finalize() must be called when SQLite disconnects a table-valued function: a connection that is being
// closed disconnects all tables and then refuses while a statement is left. Cost: about a microsecond.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sqlite/select.h"

namespace foresee {

struct AskedTable {
  std::optional<std::string> table;
  std::optional<std::string> schema;

  friend bool operator==(const AskedTable&, const AskedTable&) = default;
};

class TableLookups {
 public:
  explicit TableLookups(sqlite3* db) : db_(db) {}

  /// Throws StoreError where SQLite finds no such table, or one of another kind. Requires: a table is named.
  std::optional<std::int64_t> number_of(const AskedTable& name);
  /// The next time SQLite resolves the name from the start.
  void forget(const AskedTable& name) noexcept;
  /// Lets go of all statements that are not running.
  void finalize() noexcept;

 private:
  struct Kept {
    AskedTable name;
    std::unique_ptr<Select> select;
  };
  static constexpr std::size_t most_kept = 8;

  Kept take(const AskedTable& name);

  sqlite3* db_;
  std::vector<Kept> kept_;  ///< the latest last
};

}  // namespace foresee
