#include "storage/rows/id_map_rows.h"

#include <algorithm>

#include "database/ascending_rows.h"
#include "database/sqlite_api.h"

namespace foresee {

MapRows::MapRows(const ShadowTables& tables, const std::string& prefix)
    : table_(tables.name().table), map_(prefix + "map") {
  const std::string map = "{" + map_ + "}";
  const auto sql = [&](const std::string& before, const std::string& after = "") {
    return tables.statement(before + map + after);
  };
  const std::string some = " WHERE id BETWEEN ?1 AND ?2 ORDER BY id";
  between_ = sql("SELECT id, leaf FROM ", some);
  last_rows_ = sql("SELECT id, leaf FROM ", some + " DESC");
  any_ = sql("SELECT id FROM ", " LIMIT 1");
  all_ = sql("SELECT id, leaf FROM ", " ORDER BY id");
  write_ = sql("INSERT OR REPLACE INTO ", " VALUES(?1, ?2)");
  erase_between_ = sql("DELETE FROM ", " WHERE id BETWEEN ?1 AND ?2");
  erase_all_ = sql("DELETE FROM ");
}

void MapRows::damaged(std::int64_t row, const char* what) const {
  throw StoreError(SQLITE_CORRUPT_VTAB, table_ + ": " + table_ + "_" + map_ + " is damaged: row " +
                                            std::to_string(row) + ": " + what);
}

void MapRows::add_row(Statement::Run& run, IdBlock& block) const {
  const std::int64_t id = number_after(std::nullopt, run, {table_, map_.c_str()});
  if (run.is_blob(1)) {
    if (id != block.base()) damaged(id, "a block starts at a multiple of 64");
    if (const char* fault = block.decode(run.blob(1))) damaged(id, fault);
    return;
  }
  if (!run.is_integer(1) || run.integer(1) < 1) damaged(id, "a leaf's number is a positive integer");
  if (block.leaf_of(id) != 0) damaged(id, "an id is in two rows");
  block.set(id, run.integer(1));
}

IdBlock MapRows::row_of(Statement::Run& run) const {
  IdBlock block(IdBlock::base_of(run.integer(0)));
  add_row(run, block);
  return block;
}

IdBlock MapRows::row_after(std::optional<std::int64_t>& last, Statement::Run& run) const {
  IdBlock block = row_of(run);
  block.for_each([&](std::int64_t id, std::int64_t) {
    if (last && id <= *last) damaged(run.integer(0), "an id is in two rows");
    last = id;
  });
  return block;
}

IdBlock MapRows::find(std::int64_t id) {
  IdBlock block(IdBlock::base_of(id));
  Statement::Run run(between_);
  run.bind(1, block.base());
  run.bind(2, block.last());
  while (run.step()) add_row(run, block);
  return block;
}

std::optional<std::int64_t> MapRows::find_leaf(std::int64_t id) {
  const std::int64_t leaf = find(id).leaf_of(id);
  return leaf == 0 ? std::nullopt : std::optional(leaf);
}

std::optional<std::int64_t> MapRows::read_end(IdOrder order) {
  constexpr IdRange all;
  Statement::Run run(order == IdOrder::ascending ? between_ : last_rows_);
  run.bind(1, all.first);
  run.bind(2, all.last);
  std::optional<std::int64_t> end;
  if (run.step())
    row_of(run).for_each([&](std::int64_t id, std::int64_t) {
      if (!end || order == IdOrder::descending) end = id;
    });
  return end;
}

std::optional<IdRange> MapRows::read_extent() {
  const auto first = read_end(IdOrder::ascending), last = read_end(IdOrder::descending);
  return first && last ? std::optional(IdRange{*first, *last}) : std::nullopt;
}

// A table of version 0.1 has several rows in a block, and a write between two batches may join them. So a batch reads
// the block in which the range starts again, and skips the rows before the range.
IdRange MapRows::read_ids(const IdRange& range, IdOrder order, std::int64_t rows,
                          std::vector<std::int64_t>& ids) {
  constexpr IdRange nothing{1, 0};
  const bool ascend = order == IdOrder::ascending;
  IdRange rest = range;
  std::optional<IdRange> before;
  Statement::Run run(ascend ? between_ : last_rows_);
  run.bind(1, IdBlock::base_of(range.first));
  run.bind(2, range.last);
  while (rows > 0) {
    if (!run.step()) return nothing;
    const std::size_t known = ids.size();
    IdRange row{run.integer(0), run.integer(0)};
    row_of(run).for_each([&](std::int64_t id, std::int64_t) {
      row.last = id;
      if (rest.has(id)) ids.push_back(id);
    });
    if (before && (ascend ? row.first <= before->last : before->first <= row.last))
      damaged(row.first, "an id is in two rows");
    before = row;
    if (!ascend) std::reverse(ids.begin() + static_cast<std::ptrdiff_t>(known), ids.end());
    if (ascend ? range.last <= row.last : row.first <= range.first) return nothing;
    if (row.last < range.first) continue;
    (ascend ? rest.first : rest.last) = ascend ? row.last + 1 : row.first - 1;
    --rows;
  }
  return rest;
}

std::int64_t MapRows::count_ids() {
  Statement::Run run(all_);
  std::int64_t count = 0;
  for (std::optional<std::int64_t> last; run.step();)
    count += static_cast<std::int64_t>(row_after(last, run).count());
  return count;
}

bool MapRows::is_empty() {
  return !Statement::Run(any_).step();
}

// --- writing

void MapRows::write(std::span<const IdHashMap::Entry> changes) {
  constexpr std::size_t at_once = 64;
  const std::optional<std::int64_t> largest = read_largest_id();
  std::vector<ChangedBlock> blocks;
  blocks.reserve(std::min(at_once, changes.size()));
  while (!changes.empty()) {
    std::size_t may_be_stored = 0;
    for (blocks.clear(); !changes.empty() && blocks.size() < at_once;) {
      const IdBlock block(IdBlock::base_of(changes[0].id));
      std::size_t count = 1;
      while (count < changes.size() && changes[count].id <= block.last()) ++count;
      blocks.push_back({block, changes.first(count)});
      may_be_stored += largest && block.base() <= *largest;
      changes = changes.subspan(count);
    }
    read_blocks(std::span(blocks).first(may_be_stored));
    for (ChangedBlock& changed : blocks) write_block(changed);
  }
}

// The next row of a scan costs a fifth of a look-up. So a few rows of other blocks are skipped to reach the next block.
// Where they are too many it is looked up, and fewer are skipped from then on, until skipping succeeds again.
void MapRows::read_blocks(std::span<ChangedBlock> blocks) {
  constexpr int max_skipped = 4;
  int may_skip = max_skipped;
  for (auto next = blocks.begin(); next != blocks.end();) {
    Statement::Run run(between_);
    run.bind(1, next->block.base());
    run.bind(2, blocks.back().block.last());
    for (int skipped = 0; skipped <= may_skip;) {
      if (!run.step()) return;
      const std::int64_t id = run.integer(0);
      while (next != blocks.end() && next->block.last() < id) ++next;
      if (next == blocks.end()) return;
      if (id < next->block.base()) {
        ++skipped;
        continue;
      }
      if (skipped > 0) may_skip = max_skipped;
      skipped = 0;
      add_row(run, next->block);
      next->is_stored = true;
      next->has_others |= id != next->block.base();
    }
    may_skip /= 2;
  }
}

void MapRows::write_block(ChangedBlock& changed) {
  IdBlock& block = changed.block;
  for (const IdHashMap::Entry& change : changed.changes) block.set(change.id, change.value);
  if (changed.has_others || (block.count() == 0 && changed.is_stored)) {
    Statement::Run run(erase_between_);
    run.bind(1, block.base());
    run.bind(2, block.last());
    run.step();
  }
  if (block.count() == 0) return;
  const std::vector<std::byte> bytes = block.encode();
  Statement::Run run(write_);
  run.bind(1, block.base());
  run.bind(2, bytes);
  run.step();
}

void MapRows::erase_all() {
  Statement::Run(erase_all_).step();
}

}  // namespace foresee
