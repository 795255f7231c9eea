// The tables of a connection as queries read them: TableSource over a store and the connection's scenes.
//
//   const OpenTables tables{open_table(connection, ships), open_table(connection, ferries)};
//   const JoinedTables sources = sources_of(connection, tables);
//   PairUpdate(sources, state, rows, resources_of(connection)).run();
//
// Cost: as TableSource says; the scene of all objects is cached for one version of the contents.
#pragma once

#include <optional>

#include "query/table_source.h"
#include "sqlite/connection.h"

namespace foresee {

class StoredTable final : public TableSource {
 public:
  /// For one statement. Requires: the connection outlives this.
  StoredTable(Connection& connection, OpenTable table) : connection_(connection), table_(std::move(table)) {}

  const std::string& name() const override { return table_.table; }
  const Layout& layout() const override { return table_.store->declaration().layout; }
  double likely_objects() const override { return static_cast<double>(table_.store->likely_objects()); }
  double newest_t() override { return table_.store->read_newest_t(&statement_state_); }
  std::shared_ptr<const Scene> all(const SceneNeeds& needs) override {
    return connection_.load_scene(table_, needs);
  }
  bool is_loaded() override { return connection_.is_loaded(table_); }
  std::shared_ptr<const Scene> objects(std::span<const std::int64_t> ids, const LegTimes& times) override;
  std::shared_ptr<NodeSource> tree() override { return table_.store->take_snapshot(&statement_state_); }
  std::shared_ptr<ChunkSource> chunks() override { return table_.store->chunks(); }

  /// The stamp in the file. Changes in memory that are not written yet do not alter it.
  std::optional<std::int64_t> stamp() override { return table_.store->stored_stamp(); }
  /// Those that this transaction has changed, if its changes start from this stamp.
  ChangedObjects changes_since(const std::optional<std::int64_t>& stamp) override;

 private:
  Connection& connection_;
  OpenTable table_;
  StatementReadState statement_state_;
};

/// The tables of a join or of a watch.
struct OpenTables {
  OpenTable a;
  std::optional<OpenTable> b = {};  ///< nothing: pairs within a, each once

  /// Whether both are the same table: then pairs occur in both orders.
  bool are_one() const { return b && b->store == a.store; }
};

/// Requires: the connection outlives the result.
JoinedTables sources_of(Connection& connection, const OpenTables& tables);

/// Requires: the connection outlives the result.
JoinResources resources_of(Connection& connection);

}  // namespace foresee
