#include "storage/rows/tree_rows.h"

#include "storage/format/features.h"

namespace foresee {

std::vector<ShadowTable> TreeRows::tables(const std::string& prefix) {
  return {{prefix + "node", "(nodeno INTEGER PRIMARY KEY, data BLOB)"}, MapRows::table(prefix)};
}

TreeRows::TreeRows(const ShadowTables& tables, MetaRows& meta, const std::string& prefix)
    : table_(tables.name().table),
      nodes_(prefix + "node"),
      root_(prefix.empty() ? "root" : prefix + "_root"),
      meta_(meta),
      map_(tables, prefix) {
  const std::string nodes = "{" + nodes_ + "}";
  const auto sql = [&](const std::string& before, const std::string& after = "") {
    return tables.statement(before + nodes + after);
  };
  largest_node_ = sql("SELECT max(nodeno) FROM ");
  node_by_number_ = sql("SELECT data FROM ", " WHERE nodeno = ?");
  nodes_after_ = sql("SELECT nodeno, data FROM ", " WHERE nodeno > ? ORDER BY nodeno LIMIT 1");
  all_nodes_ = sql("SELECT nodeno, data FROM ", " ORDER BY nodeno");
  write_node_ = sql("INSERT OR REPLACE INTO ", " VALUES(?, ?)");
  erase_node_ = sql("DELETE FROM ", " WHERE nodeno = ?");
  node_numbers_ = sql("SELECT nodeno FROM ", " ORDER BY nodeno");
}

std::int64_t TreeRows::read_largest_node() {
  Statement::Run run(largest_node_);
  return run.step() && run.is_integer(0) ? run.integer(0) : 0;
}

void TreeRows::write_node(std::int64_t number, std::span<const std::byte> blob) {
  Statement::Run run(write_node_);
  run.bind(1, number);
  run.bind(2, blob);
  run.step();
}

void TreeRows::erase_node(std::int64_t number) {
  Statement::Run run(erase_node_);
  run.bind(1, number);
  run.step();
}

void TreeRows::write_map(std::span<const IdHashMap::Entry> changes) {
  if (changes.empty()) return;
  map_.write(changes);
  // A table of version 0.1 now has blocks, which that version cannot read.
  if (const std::string features = meta_.read("features", max_features); !has_feature(features, map_blocks))
    meta_.write("features", features + (features.empty() ? "" : ",") + std::string(map_blocks));
}

}  // namespace foresee
