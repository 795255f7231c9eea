// The tables of a watch, and what contact says of pairs of their objects.
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
  std::optional<Connection::OpenTable> b = {};  ///< none: pairs within a

  /// The same table twice: pairs in both orders.
  bool are_one() const { return b && b->store == a.store; }
};

/// As SQLite finds them in the schema of the watch. Throws Error where there is no such table.
WatchedTables watched_tables(Connection& connection, const std::string& schema,
                             const WatchDeclaration& declaration);

/// What the watch asks, during `horizon`; scenes without objects.
JoinQuestion question_of(const WatchedTables& tables, const WatchDeclaration& declaration,
                         const Horizon& horizon);
/// The same about all objects.
JoinQuestion question_of_all(Connection& connection, const WatchedTables& tables,
                             const WatchDeclaration& declaration, const Horizon& horizon);

/// The objects of these ids, as many as there are; ids rise.
std::shared_ptr<Scene> scene_of(Connection& connection, const Connection::OpenTable& table,
                                std::span<const std::int64_t> ids);

struct PairIds {
  std::int64_t a, b;

  friend auto operator<=>(const PairIds&, const PairIds&) = default;
};

/// A row for each of the pairs that touches during the question's horizon, with what it wants. Cost: looking
/// up each object in memory, and contact.
std::vector<JoinRow> contacts_of(Connection& connection, const WatchedTables& tables,
                                 const JoinQuestion& question, std::span<const PairIds> pairs);

}  // namespace foresee
