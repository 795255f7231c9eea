// Plans of one table: the legs of each object in chunks, one row each, and a second TPR-tree with a box per chunk.
//
//   StoredPlans plans(db, format, name, 60, journal, memory, [] {});
//   plans.connect(tables, meta);
//   StoredPlans::Change change(plans, rolled_back);
//   use(change.add(42, record, plan));                   // the record to store, with the numbers of its chunks
//   change.write();                                      // rows; if the change fails, they are removed again
//   change.finish();
//
// A new plan has new numbers, above all that this object has seen, so the record of an object differs after each
// change of its plan. Rows are written at once; items of the tree wait as objects do (tree_store.h). SQLite restores
// the rows at a rollback, the journal everything in memory. An item is a box that contains the object with its whole
// shape while the legs of the chunk last. Its life is that of the legs, up to the `until` of the object.
// Errors: SQLITE_CORRUPT_VTAB for chunks that are damaged, missing, or those of another object.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/interrupt_steps.h"
#include "database/blob_rows.h"
#include "format/chunk_blob.h"
#include "index/chunk_source.h"
#include "storage/nodes/chunk_cache.h"
#include "storage/tree/tree_store.h"

namespace foresee {

/// The format of the tree of chunks beside a tree of this format.
NodeFormat chunk_node_format(const NodeFormat& objects);

class StoredPlans final : public Journal::Participant {
 public:
  /// An object with a plan, as its record says.
  struct Head {
    std::int64_t object;
    std::int64_t first, chunks;  ///< the numbers of its chunks
    std::size_t record = 0;      ///< its place among the records of a caller

    std::int64_t last() const { return first + chunks - 1; }
    bool has(std::int64_t number) const { return first <= number && number <= last(); }
  };

  /// As in TreeStore. `format`: of the table's objects.
  StoredPlans(sqlite3* db, const NodeFormat& format, const QualifiedName& name, double horizon,
              Journal& journal, MemoryBudget& memory, std::function<void()> write_out);
  /// Uses these tables from now on, after a rename too.
  void connect(const ShadowTables& tables, MetaRows& meta);

  TreeStore& tree() { return tree_; }
  TreeRows& tree_rows() { return *tree_rows_; }
  const QualifiedName& name() const { return name_; }
  const QualifiedName& tree_name() const { return tree_name_; }
  const Layout& layout() const { return layout_; }  ///< of the table's objects

  /// Requires: a record with a plan.
  Head head_of(std::int64_t object, const double* record, std::size_t place = 0) const;
  /// The plan as it was written.
  Plan read(const Head& head);
  /// The legs of these times, in order. `stamp`: as for read_chunk(). Cost: two look-ups, a row per chunk.
  void read_legs(const Head& head, const LegTimes& times, std::optional<std::int64_t> stamp,
                 std::vector<Leg>& legs);
  /// Fills the chunk, with the legs of these times; returns false if the number does not exist. The record is empty
  /// until add_record() has added it to a chunk in memory.
  /// `stamp`: of the committed rows, whose chunks are kept in memory; nothing: this transaction has written.
  bool read_chunk(std::int64_t number, const LegTimes& times, std::optional<std::int64_t> stamp,
                  Chunk& chunk);
  /// As ChunkSource says.
  void prefetch_chunk(std::int64_t number) { cache_.prefetch(number); }
  /// Adds the record of its object to a chunk that read_chunk() has read last, with a stamp.
  void add_record(std::int64_t number, std::span<const double> record) { cache_.add_record(number, record); }

  using EachPlan = std::function<void(const Head&, std::span<const Leg>)>;
  /// Calls each(head, legs) for the objects with legs from `from` to `until`. Sorts the heads by number.
  /// Cost: a scan of all rows, or a look-up per chunk if few chunks exist at these times.
  void read_all(std::vector<Head>& heads, double from, double until, const EachPlan& each,
                Interrupt& interrupt);

  // plans_check.cpp; `records`: of the heads
  /// Replaces the tree by the items of these plans, and deletes all other chunks. Requires: in a change.
  void rebuild(std::vector<Head>& heads, std::span<const double> records, Interrupt& interrupt);
  using Say = std::function<void(const std::string&)>;
  /// Says what is wrong with chunks, heads and items, one sentence each. Requires: a sound tree.
  void check(std::vector<Head>& heads, std::span<const double> records, const Say& say, Interrupt& interrupt);

  class Change;
  /// Call it when a transaction that has replaced stamp `before` by `after` is committed, before the journal ends.
  void note_commit(std::optional<std::int64_t> before, std::int64_t after) noexcept {
    cache_.note_commit(before, after, changed_);
  }

 private:
  std::size_t keep() override { return 0; }
  void rewind(std::size_t) noexcept override {}
  void end(Journal::Ended) noexcept override { changed_.clear(); }

  /// Opens a stored chunk of this object; throws for damage.
  StoredChunk opened(std::int64_t number, std::span<const std::byte> blob, const Head* head) const;
  void require_of(const Head& head, std::int64_t number, const StoredChunk& chunk) const;
  /// Calls use(chunk, record) if the number exists; returns whether it does. The record is empty if it is not known.
  template <class Use>
  bool with_chunk(std::int64_t number, std::optional<std::int64_t> stamp, Use use);
  void require(const char* fault, std::int64_t number) const;
  using EachRow = std::function<void(const Head&, std::int64_t number, std::span<const std::byte>)>;
  using EachStray = std::function<void(std::int64_t number)>;
  /// Reads every row, or those of `numbers`, ascending, by a look-up each; stray() gets the numbers that no head has.
  /// Sorts the heads by number. Throws for a number without a row.
  void scan(std::vector<Head>& heads, const EachRow& each, const EachStray& stray, Interrupt& interrupt,
            const std::vector<std::int64_t>* numbers = nullptr);
  /// The numbers of the chunks that exist at these times, ascending.
  std::vector<std::int64_t> chunks_during(double from, double until, Interrupt& interrupt);
  /// The largest number so far.
  std::int64_t last_number();

  sqlite3* db_;
  const QualifiedName& name_;
  QualifiedName tree_name_;  ///< in messages
  Layout layout_;
  Offsets at_, item_at_;
  TreeStore tree_;
  ChunkCache cache_;
  ChangedChunks changed_;  ///< by this transaction; those of rolled-back changes stay in it
  std::optional<BlobRows> rows_;
  std::optional<TreeRows> tree_rows_;
  std::int64_t last_number_ = 0;  ///< of those that this object has written or deleted
};

/// The plans that one change of the table adds, keeps and removes. Unless it is finished, its end removes the rows that
/// it has added; the journal restores the rest.
class StoredPlans::Change {
 public:
  /// `rolled_back`: becomes true if SQLite rolls everything back during the change.
  Change(StoredPlans& plans, const bool& rolled_back) : plans_(&plans), rolled_back_(rolled_back) {}
  ~Change();
  Change(const Change&) = delete;
  Change& operator=(const Change&) = delete;

  /// Adds the plan, which outlives this; returns the record with its first leg and the numbers of its chunks.
  /// Valid as long as this. `before`: a plan that is removed.
  std::span<const double> add(std::int64_t id, std::span<const double> record, const Plan& plan,
                              const Head* before = nullptr);
  /// For a change without a new plan: returns the record likewise. `before`: the object's record, if it exists. Its
  /// plan is kept if `record` has its number; then the first leg is that of `before`.
  std::span<const double> keep(std::int64_t id, std::int64_t new_id, std::span<const double> before,
                               std::span<const double> record);
  /// Removes the plan of an object, if it has one.
  void remove(std::int64_t id, std::span<const double> record);

  /// Writes the rows of the new plan.
  void write();
  /// Writes the rest. If it throws, only a rollback of SQLite restores the rows.
  void finish();

 private:
  void add_items(const Head* before, Steps& steps);
  void erase_item(std::int64_t number);
  void note_removed(const Head& head);

  StoredPlans* plans_;
  const bool& rolled_back_;
  std::vector<double> record_;
  std::optional<ChunkWriter> added_;
  std::int64_t first_ = 0, written_ = 0;  ///< of the new plan: its first number, and the rows written
  std::vector<Head> removed_;
  std::optional<Head> moved_;  ///< whose chunks become those of another object
  bool finished_ = false;
};

}  // namespace foresee
