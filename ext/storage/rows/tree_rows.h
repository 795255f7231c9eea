// Every SQL statement that a store runs on the shadow tables of one tree: its nodes, its id map, its root.
//
//   TreeRows rows(tables, meta);                // ships_node, ships_map, and the key `root` of ships_meta
//   rows.write_node(7, blob);
//   rows.write_root(7);
//
// A table may have another tree with the prefix "chunk": ships_chunknode, ships_chunkmap and the key `chunk_root`.
// SQLite takes a table for a shadow table by what follows the last underscore, so the prefix has none.
// Nothing is cached: each call sees the database as this connection sees it now. Blobs are not checked. Node
// numbers are integers that ascend strictly, else the call fails with SQLITE_CORRUPT_VTAB (ascending_rows.h).
#pragma once

#include <vector>

#include "storage/rows/ascending_rows.h"
#include "storage/rows/id_map_rows.h"
#include "storage/rows/meta_rows.h"

namespace foresee {

class TreeRows {
 public:
  static std::vector<ShadowTable> tables(const std::string& prefix = "");

  TreeRows(const ShadowTables& tables, MetaRows& meta, const std::string& prefix = "");

  // --- nodes
  std::int64_t read_largest_node();  ///< 0: no nodes
  /// Calls read(blob) if the node exists; returns whether it does.
  template <class Read>
  bool read_node(std::int64_t number, Read read) {
    Statement::Run run(node_by_number_);
    run.bind(1, number);
    if (!run.step()) return false;
    read(run.blob(0));
    return true;
  }
  /// Calls read(number, blob) for the first node after number `after`; returns whether there is one.
  template <class Read>
  bool read_node_after(std::int64_t after, Read read) {
    Statement::Run run(nodes_after_);
    run.bind(1, after);
    if (!run.step()) return false;
    read(number_after(after, run, {table_, nodes_.c_str()}), run.blob(1));
    return true;
  }
  /// Calls read(number, blob) for every node, by ascending number.
  template <class Read>
  void read_all_nodes(Read read) {
    read_ascending(all_nodes_, {table_, nodes_.c_str()},
                   [&](std::int64_t number, Statement::Run& run) { read(number, run.blob(1)); });
  }
  /// Replaces the stored blob, if there is one.
  void write_node(std::int64_t number, std::span<const std::byte> blob);
  void erase_node(std::int64_t number);
  template <class Read>
  void read_node_numbers(Read read) {
    read_ascending(node_numbers_, {table_, nodes_.c_str()},
                   [&](std::int64_t number, Statement::Run&) { read(number); });
  }

  // --- map
  MapRows& map() { return map_; }
  /// Stores the leaf of each id; 0 deletes the id. Requires: ids ascend.
  void write_map(std::span<const IdHashMap::Entry> changes);

  // --- root
  /// The node number of the root; nothing if it is missing or not an integer.
  std::optional<std::int64_t> read_root() { return meta_.read_integer(root_); }
  void write_root(std::int64_t root) { meta_.write(root_, root); }

 private:
  std::string table_, nodes_, root_;  ///< the table; the suffix of its nodes and the key of its root
  MetaRows& meta_;
  MapRows map_;
  Statement largest_node_, node_by_number_, nodes_after_, all_nodes_, write_node_, erase_node_, node_numbers_;
};

}  // namespace foresee
