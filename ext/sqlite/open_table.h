// Which table is meant, and what does it hold right now?
//
//   OpenScene ships = open_scene(connection, {.table = call.text(input_tbl), .schema = {}});
//
// A name resolves as SQLite resolves it (temp, main, attached) unless a schema is given; without a name the
// connection must see exactly one moving_objects table. SQLite itself looks the name up, connects the table
// and begins to read that database: open_scene runs
//
//   SELECT "ships" FROM "ships" WHERE "ships" MATCH 'foresee-handle'
//
// which the table answers with the number under which it announced itself. The scene is a snapshot and that
// statement is closed before open_scene returns, so the table can be written under a running call;
// against other connections SQLite keeps its read lock until the statement that calls ends, as for any
// reader.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "query/scene.h"
#include "sqlite/connection.h"

namespace foresee {

struct AskedTable {
  std::optional<std::string> table;
  std::optional<std::string> schema;
};

struct OpenScene {
  std::int64_t number;  ///< equal for equal tables
  std::shared_ptr<const Scene> scene;
};

/// Throws Error where no such table is to be found or where the choice is not clear; it lists what there is.
OpenScene open_scene(Connection& connection, const AskedTable& name);

}  // namespace foresee
