// Where is each object, for good? The leaf of every id, in <name>_map(id INTEGER PRIMARY KEY, leaf).
//
//   MapRows map(tables);
//   map.write(changes);                        // ids ascending; leaf 0: the id goes
//   map.find(42).leaf_of(42) == 7
//
// A row is a block: 64 ids with a blob of their leaves (format/id_block.h), under the first of them. In
// tables of version 0.1 a row is one id with the number of its leaf. A write leaves what it touches as
// blocks, so that such a table moves over bit by bit; no id has both.
//
// Rows are hostile: SQLITE_CORRUPT_VTAB for a blob that is no block, a number that is no leaf's, an id that
// is in two rows. Cost: a look-up for find(), and it knows of 64 ids; a look-up and a write for each block
// that write() touches.
#pragma once

#include <optional>
#include <span>

#include "storage/format/id_block.h"
#include "storage/rows/id_hash_map.h"
#include "storage/rows/shadow_tables.h"
#include "storage/rows/statement.h"

namespace foresee {

class MapRows {
 public:
  static ShadowTable table() { return {"map", "(id INTEGER PRIMARY KEY, leaf INTEGER)"}; }

  explicit MapRows(const ShadowTables& tables);

  /// The block of `id`.
  IdBlock find(std::int64_t id) { return read_block(IdBlock::base_of(id), nullptr); }
  std::optional<std::int64_t> find_leaf(std::int64_t id);
  std::optional<std::int64_t> read_largest_id();
  /// Reads every row.
  std::int64_t count_ids();
  bool is_empty();

  /// Calls read(id, leaf) with every object, ids ascending.
  template <class Read>
  void read(Read read) {
    Statement::Run run(all_);
    for (std::optional<std::int64_t> last; run.step();) row_after(last, run).for_each(read);
  }

  /// Each id's leaf; 0: the id goes. Requires: ids ascend.
  void write(std::span<const IdHashMap::Entry> changes);
  void erase_all();

 private:
  /// The row on which `run` stands.
  IdBlock row_of(Statement::Run& run) const;
  /// The same, behind the id `last`, which becomes the last one of this row.
  IdBlock row_after(std::optional<std::int64_t>& last, Statement::Run& run) const;
  /// What is stored of the block with this base, and, if wanted, the numbers of its rows.
  IdBlock read_block(std::int64_t base, std::vector<std::int64_t>* rows);
  /// Stores a block of which `changes` are new; `is_new`: nothing of it is stored.
  void write_block(std::span<const IdHashMap::Entry> changes, bool is_new);
  [[noreturn]] void damaged(std::int64_t row, const char* what) const;

  std::string table_;
  Statement between_, largest_, all_, write_, erase_between_, erase_all_;
};

}  // namespace foresee
