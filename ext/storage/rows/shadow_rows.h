// Every SQL statement that a store runs on its shadow tables (shadow_schema.h), as plain functions.
//
// Nothing is cached: each call sees the database as this connection sees it now. Blobs are not checked. Row
// numbers are integers that ascend strictly, else the call fails with SQLITE_CORRUPT_VTAB (ascending_rows.h).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "storage/rows/ascending_rows.h"
#include "storage/rows/id_map_rows.h"
#include "storage/rows/shadow_schema.h"
#include "storage/rows/statement.h"

namespace foresee {

class ShadowRows {
 public:
  ShadowRows(const ShadowTables& tables, const Declaration& declaration);

  // --- _node
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
    read(number_after(after, run, {table_, "node"}), run.blob(1));
    return true;
  }
  /// Calls read(number, blob) for every node, by ascending number.
  template <class Read>
  void read_all_nodes(Read read) {
    read_ascending(all_nodes_, {table_, "node"},
                   [&](std::int64_t number, Statement::Run& run) { read(number, run.blob(1)); });
  }
  /// Replaces the stored blob, if there is one.
  void write_node(std::int64_t number, std::span<const std::byte> blob);
  void erase_node(std::int64_t number);
  template <class Read>
  void read_node_numbers(Read read) {
    read_ascending(node_numbers_, {table_, "node"},
                   [&](std::int64_t number, Statement::Run&) { read(number); });
  }

  // --- _map
  MapRows& map() { return map_; }
  /// Stores the leaf of each id; 0 deletes the id. Requires: ids ascend.
  void write_map(std::span<const IdHashMap::Entry> changes);

  // --- _aux; requires: the table has auxiliary columns
  void insert_auxiliaries(std::int64_t id, std::span<sqlite3_value*> values);
  /// Values that did not change (sqlite3_value_nochange) stay. The row of another object with `new_id` is
  /// replaced.
  void update_auxiliaries(std::int64_t id, std::int64_t new_id, std::span<sqlite3_value*> values);
  void erase_auxiliaries(std::int64_t id);
  void result_auxiliary(sqlite3_context* context, std::int64_t id, int column);
  template <class Read>
  void read_auxiliary_ids(Read read) {
    read_ascending(auxiliary_ids_, {table_, "aux"}, [&](std::int64_t id, Statement::Run&) { read(id); });
  }
  /// Makes one row per object of the map: deletes surplus rows, adds missing ones with NULLs.
  void match_auxiliaries_to_map();

  // --- _meta
  MetaRows& meta() { return meta_; }
  /// Nothing if the stamp is missing or not an integer.
  std::optional<std::int64_t> read_stamp() { return meta_.read_integer("stamp"); }
  void write_stamp(std::int64_t stamp) { meta_.write("stamp", stamp); }
  /// The node number of the root; nothing if it is missing or not an integer.
  std::optional<std::int64_t> read_root() { return meta_.read_integer("root"); }
  void write_root(std::int64_t root) { meta_.write("root", root); }
  /// The number of objects; nothing if it is missing or out of range.
  std::optional<std::int64_t> read_objects() { return read_object_count(meta_); }
  void write_objects(std::int64_t objects) { meta_.write("objects", objects); }
  /// The names of the watches; each has a key of its own, `watch:` and its name.
  std::vector<std::string> read_watches();
  void write_watch(const std::string& name) { meta_.write("watch:" + name, std::int64_t{1}); }
  void erase_watch(const std::string& name);

 private:
  std::size_t variables() const;
  void require_variables(std::size_t needed) const;

  sqlite3* db_;
  std::string table_;
  Statement largest_node_, node_by_number_, nodes_after_, all_nodes_, write_node_, erase_node_, node_numbers_;
  Statement insert_auxiliaries_, update_auxiliaries_, erase_auxiliaries_, auxiliary_ids_, insert_missing_;
  std::vector<Statement> auxiliary_;
  Statement watches_, erase_watch_;
  MapRows map_;
  MetaRows meta_;
};

}  // namespace foresee
