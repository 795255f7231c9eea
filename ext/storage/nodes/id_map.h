// Id map of a tree: the leaf of each object, as it is stored and with what this transaction changes.
//
//   ids.place(ids_of_leaf, 7);                  // or erase(42)
//   ids.find_unwritten(42) == 7
//   ids.write(interrupt);                       // all changes, in key order
//   IdWalk walk(ids, {.first = 40}, IdOrder::ascending);        // then walk.next(some)
//
// Changes wait in memory until they are written. After a mark each is logged, so that a rollback restores it; a
// write of the map is logged too: when SQLite restores the rows, the changes are unwritten again. Of the rows
// the map keeps the block read last, and a filter of all ids, which rejects new ones, if it has seen the table empty
// or packed.
#pragma once

#include <memory>
#include <optional>

#include "base/error.h"
#include "database/id_filter.h"
#include "database/journal.h"
#include "storage/nodes/placed_ids.h"
#include "storage/rows/tree_rows.h"

namespace foresee {

class IdMap final : public Journal::Participant {
 public:
  static constexpr std::int64_t erased = 0;  ///< the id is gone
  static constexpr std::int64_t unknown = IdHashMap::unknown;
  /// About: the hash table and the log.
  static constexpr std::size_t bytes_per_change = 4 * sizeof(IdHashMap::Entry);

  /// `name` is the table name in messages.
  IdMap(Journal& journal, const QualifiedName& name) : Participant(journal, Scope::marks), name_(name) {}
  /// Reads and writes these rows from now on.
  void connect(TreeRows& rows) { rows_ = &rows; }

  /// A leaf's number; erased; or unknown: look it up in the stored map.
  std::int64_t find_unwritten(std::int64_t id) const noexcept {
    const std::int64_t leaf = leaves_.find(id);
    return leaf == unknown && stored_is_void_ ? erased : leaf;
  }
  /// False only if the stored map does not have the id.
  bool may_be_stored(std::int64_t id) const noexcept { return !filter_ || filter_->may_have(id); }
  /// From the smallest id to the largest, and perhaps beyond; nothing without ids.
  std::optional<IdRange> extent();
  bool has_block(std::int64_t id) const { return last_block_ && last_block_->base() == IdBlock::base_of(id); }
  /// The stored block of an id, read unless it was read last.
  const IdBlock& block(std::int64_t id);

  /// From now on these objects are in `leaf`.
  void place(std::span<const std::int64_t> ids, std::int64_t leaf);
  void erase(std::int64_t id) { set(id, erased); }
  /// The stored map is no longer valid, for any id.
  void void_stored();
  bool has_unwritten() const { return !leaves_.none_known() || stored_is_void_; }
  void write(Interrupt& interrupt);
  /// Changes with every write of rows, also with one that fails.
  std::uint64_t writes() const { return writes_; }

  /// From now on place() only lists the ids, until one of the other two or a rewind. Of these ids only `new_ids` are
  /// new to the map; or all are, `count` of them.
  void start_list(std::span<const std::int64_t> new_ids);
  void start_list_of_new(std::size_t count);
  /// The listed ids are like all others.
  void keep_list(Interrupt& interrupt);
  /// Writes all changes, and then the listed ids. Throws before if they are not those expected.
  void write_list(const std::optional<IdSum>& expected, Interrupt& interrupt);
  std::size_t listed() const { return list_ ? list_->sum().count() : 0; }

  /// Bytes in use beyond those left by the last write: what another write would release.
  std::size_t memory() const { return held() - held_after_writing_; }
  /// Rows may have changed: forgets what was read.
  void forget_stored() noexcept {
    last_block_.reset();
    filter_.reset();
  }
  /// Drops all changes too.
  void clear() noexcept;

 private:
  friend class IdWalk;
  using Ids = std::vector<std::int64_t>;
  /// The ids that are placed and not written, ascending. Cost: a sort after the last change.
  std::shared_ptr<const Ids> unwritten_ids();
  std::size_t keep() override;
  void rewind(std::size_t position) noexcept override;
  void forget() noexcept override;
  void end(Journal::Ended how) noexcept override;

  struct Log {
    std::vector<IdHashMap::Entry> old;    ///< values, oldest first
    bool started_empty = true;            ///< nothing was unwritten when the log was empty
    std::optional<std::size_t> empty_at;  ///< the last position at which nothing was unwritten
  };

  bool has_no_ids() const { return leaves_.none_known() && (stored_is_void_ || rows_->map().is_empty()); }
  void set(std::int64_t id, std::int64_t leaf);
  void log_all(bool voids);
  void log_write();
  void add_to_filter(std::span<const IdHashMap::Entry> changes);
  void note_written();
  std::size_t held() const { return leaves_.memory() + log_.old.size() * sizeof(IdHashMap::Entry); }

  const QualifiedName& name_;
  TreeRows* rows_ = nullptr;
  IdHashMap leaves_;
  std::shared_ptr<const Ids> unwritten_ids_;  ///< of leaves_; null: not known
  bool stored_is_void_ = false;
  Log log_;
  std::size_t held_after_writing_ = 0;
  std::uint64_t writes_ = 0;
  std::optional<IdBlock> last_block_;
  std::optional<IdFilter> filter_;  ///< of the stored ids, and some that are gone
  std::optional<PlacedIds> list_;   ///< in place of leaves_ during a large load or merge
  bool lists_new_ = false;          ///< the filter lacks the listed ids
};

/// The ids of a range in order, some at once: few at first. Writing the map does not change what follows. Before any
/// other change the owner reads on to the end; after a rollback it stops (table_cursor.h).
class IdWalk {
 public:
  /// The map must outlive it. Requires: none of its ids is listed.
  IdWalk(IdMap& map, const IdRange& range, IdOrder order)
      : map_(&map), rest_(range), order_(order), placed_(map.unwritten_ids()) {}

  /// Replaces `ids` by the next ones; false at the end. Cost: a row per 64 ids.
  bool next(std::vector<std::int64_t>& ids);

 private:
  IdMap* map_;
  IdRange rest_;
  IdOrder order_;
  std::int64_t rows_ = 1;                                    ///< of the next batch
  std::shared_ptr<const std::vector<std::int64_t>> placed_;  ///< unwritten at the start, ascending
};

}  // namespace foresee
