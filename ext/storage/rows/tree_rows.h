// Shadow tables of one tree: its nodes, its id map, and its root in `_meta`.
//
//   TreeRows rows(tables, meta);                // ships_node, ships_map, and the key `root` of ships_meta
//   rows.nodes().write(7, blob);
//   rows.write_root(7);
//
// A table may have another tree with the prefix "chunk": ships_chunknode, ships_chunkmap and the key `chunk_root`.
// SQLite takes a table for a shadow table by what follows the last underscore, so the prefix has none.
// Cost: that of the rows (blob_rows.h, id_map_rows.h).
#pragma once

#include <vector>

#include "database/blob_rows.h"
#include "database/meta_rows.h"
#include "format/features.h"
#include "storage/rows/id_map_rows.h"

namespace foresee {

class TreeRows {
 public:
  static std::vector<ShadowTable> tables(const std::string& prefix = "") {
    return {BlobRows::table(prefix + "node", "nodeno"), MapRows::table(prefix)};
  }

  TreeRows(const ShadowTables& tables, MetaRows& meta, const std::string& prefix = "")
      : nodes_(tables, prefix + "node", "nodeno"),
        map_(tables, prefix),
        meta_(meta),
        root_(prefix.empty() ? "root" : prefix + "_root") {}

  BlobRows& nodes() { return nodes_; }
  MapRows& map() { return map_; }
  /// Stores the leaf of each id; 0 deletes the id. Requires: ids ascend.
  void write_map(std::span<const IdHashMap::Entry> changes);

  /// The node number of the root; nothing if it is missing or not an integer.
  std::optional<std::int64_t> read_root() { return meta_.read_integer(root_); }
  void write_root(std::int64_t root) { meta_.write(root_, root); }

 private:
  BlobRows nodes_;
  MapRows map_;
  MetaRows& meta_;
  std::string root_;  ///< the key of the root
};

inline void TreeRows::write_map(std::span<const IdHashMap::Entry> changes) {
  if (changes.empty()) return;
  map_.write(changes);
  // A table of version 0.1 now has blocks, which that version cannot read.
  if (const std::string features = meta_.read("features", max_features); !has_feature(features, map_blocks))
    meta_.write("features", features + (features.empty() ? "" : ",") + std::string(map_blocks));
}

}  // namespace foresee
