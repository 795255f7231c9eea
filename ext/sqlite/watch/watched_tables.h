// The watched tables of a watch, and contact queries for pairs of their objects.
//
//   const WatchedTables tables = watched_tables(connection, "main", state);
//   const auto rows = contacts_of(connection, tables, question_of(tables, state, {clock, h}), pairs);
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "query/join/question.h"
#include "sqlite/connection.h"
#include "storage/watch/watch_state.h"

namespace foresee {

struct WatchedTables {
  Connection::OpenTable a;
  std::optional<Connection::OpenTable> b = {};  ///< nothing: pairs within a

  /// Whether both are the same table: then pairs occur in both orders.
  bool are_one() const { return b && b->store == a.store; }
};

/// The tables with the declared names in the schema of the watch. Throws Error if one does not exist.
WatchedTables watched_tables(Connection& connection, const std::string& schema,
                             const WatchDeclaration& declaration);

/// The join query of the watch during `horizon`, with empty scenes.
JoinQuestion question_of(const WatchedTables& tables, const WatchDeclaration& declaration,
                         const Horizon& horizon);
/// The same query with the scenes of all objects.
JoinQuestion question_of_all(Connection& connection, const WatchedTables& tables,
                             const WatchDeclaration& declaration, const Horizon& horizon);

/// The existing objects among these ids. Requires: ids in rising order.
std::shared_ptr<Scene> scene_of(Connection& connection, const Connection::OpenTable& table,
                                std::span<const std::int64_t> ids);

struct PairIds {
  std::int64_t a, b;

  friend auto operator<=>(const PairIds&, const PairIds&) = default;
};

/// One row for each of the pairs that is in contact within the horizon of `question`, with the fields that it
/// wants. Cost: a look-up in memory per object, and a contact computation per pair.
std::vector<JoinRow> contacts_of(Connection& connection, const WatchedTables& tables,
                                 const JoinQuestion& question, std::span<const PairIds> pairs);

}  // namespace foresee
