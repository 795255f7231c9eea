// Every SQL statement that a store runs on its shadow tables (shadow_schema.h) besides those of its tree
// (tree_rows.h), as plain functions.
//
// Nothing is cached: each call sees the database as this connection sees it now.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "database/ascending_rows.h"
#include "database/statement.h"
#include "storage/rows/shadow_schema.h"
#include "storage/rows/tree_rows.h"

namespace foresee {

class ShadowRows {
 public:
  ShadowRows(const ShadowTables& tables, const Declaration& declaration);

  TreeRows& tree() { return tree_; }

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
  Statement insert_auxiliaries_, update_auxiliaries_, erase_auxiliaries_, auxiliary_ids_, insert_missing_;
  std::vector<Statement> auxiliary_;
  Statement watches_, erase_watch_;
  MetaRows meta_;
  TreeRows tree_;
};

}  // namespace foresee
