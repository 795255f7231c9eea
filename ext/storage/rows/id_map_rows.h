// Stored id map: the leaf of every object, in <name>_map(id INTEGER PRIMARY KEY, leaf).
//
//   MapRows map(tables);
//   map.write(changes);                        // ids ascending; leaf 0 deletes the id
//   map.find(42).leaf_of(42) == 7
//
// A row is a block: a blob with the leaves of 64 consecutive ids (format/id_block.h), stored under the first
// of them. In tables of version 0.1 a row is one id with the number of its leaf. A write converts the rows
// that it changes to blocks, so such a table is migrated gradually; no id is in rows of both kinds.
//
// Rows may be damaged: SQLITE_CORRUPT_VTAB for a blob that is not a block, a number that cannot be a leaf, or
// an id in two rows. Cost: find() is one look-up for 64 ids. write() takes a write per block, and reads each by a scan
// if most blocks change, else by a look-up.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "database/id_hash_map.h"
#include "database/shadow_tables.h"
#include "database/statement.h"
#include "format/id_block.h"

namespace foresee {

/// A closed interval of ids.
struct IdRange {
  std::int64_t first = std::numeric_limits<std::int64_t>::min();
  std::int64_t last = std::numeric_limits<std::int64_t>::max();

  bool is_empty() const { return first > last; }
  bool has(std::int64_t id) const { return first <= id && id <= last; }
};

enum class IdOrder : std::uint8_t { ascending, descending };

class MapRows {
 public:
  static ShadowTable table(const std::string& prefix = "") {
    return {prefix + "map", "(id INTEGER PRIMARY KEY, leaf INTEGER)"};
  }

  /// `prefix`: of the suffix `map`.
  explicit MapRows(const ShadowTables& tables, const std::string& prefix = "");

  /// The block of `id`.
  IdBlock find(std::int64_t id);
  std::optional<std::int64_t> find_leaf(std::int64_t id);
  std::optional<std::int64_t> read_largest_id() { return read_end(IdOrder::descending); }
  /// From the smallest id to the largest; nothing without ids.
  std::optional<IdRange> read_extent();
  /// Appends the ids of a range in order, those of at most `rows` rows. Returns the rest of the range. Requires: the
  /// range is not empty, and rows > 0.
  IdRange read_ids(const IdRange& range, IdOrder order, std::int64_t rows, std::vector<std::int64_t>& ids);
  /// Reads every row.
  std::int64_t count_ids();
  bool is_empty();

  /// Calls read(id, leaf) for every object, ids ascending.
  template <class Read>
  void read(Read read) {
    Statement::Run run(all_);
    for (std::optional<std::int64_t> last; run.step();) row_after(last, run).for_each(read);
  }

  /// Stores the leaf of each id; 0 deletes the id. Requires: ids ascend.
  void write(std::span<const IdHashMap::Entry> changes);
  void erase_all();

 private:
  /// The first id in this order.
  std::optional<std::int64_t> read_end(IdOrder order);
  /// A block that changes, and what is stored of it.
  struct ChangedBlock {
    IdBlock block;
    std::span<const IdHashMap::Entry> changes;
    bool is_stored = false;
    bool has_others = false;  ///< rows of version 0.1
  };

  /// Adds the current row of `run`, which is of this block, to it.
  void add_row(Statement::Run& run, IdBlock& block) const;
  /// The current row of `run`.
  IdBlock row_of(Statement::Run& run) const;
  /// row_of() `run`. Throws unless its ids are larger than `last`, which becomes the last id of this row.
  IdBlock row_after(std::optional<std::int64_t>& last, Statement::Run& run) const;
  /// Reads what is stored of these blocks, which ascend.
  void read_blocks(std::span<ChangedBlock> blocks);
  void write_block(ChangedBlock& changed);
  [[noreturn]] void damaged(std::int64_t row, const char* what) const;

  std::string table_, map_;  ///< the table; the suffix of its map
  Statement between_, last_rows_, any_, all_, write_, erase_between_, erase_all_;
};

}  // namespace foresee
