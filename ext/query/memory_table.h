// A table of moving objects in memory: for applications that embed the core without SQLite, and for tests.
//
//   MemoryTable ships("ships", {.axes = 2, .law = Law::uniform, .shape = Shape::ball});
//   ships.put(7, std::vector<double>{0, 0, 6, 0, 30});        // record_offsets(layout)
//   ships.put(8, record_of(ships.layout(), {{"x", 900}, {"y", 0}, {"vx", -6}, {"r", 30}}));
//   ships.commit();
//
//   MemoryTable robots("robots", with_plans);                  // .has_plan
//   robots.put(1, record, legs_of(plan));                      // one object of many legs
//
// Between two commits the table knows which objects changed. Guarantee: scenes and the tree hold the same
// doubles as the records that were put; a put() that throws Error changes nothing. Requires: numbers as
// check_numbers() has them, which put() checks.
//
// Cost: about a microsecond per put. Changes wait until all(), newest_t(), tree() or chunks() reads the tree; then
// they are merged into it together. all() copies every object once per change. Outlines and meshes are not kept: a
// layout with `shape` needs a database.
#pragma once

#include <functional>
#include <initializer_list>
#include <set>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "base/error.h"
#include "index/chunk_source.h"
#include "index/memory_pages.h"
#include "index/tpr_tree/tpr_tree.h"
#include "query/input_checks.h"
#include "query/table_source.h"

namespace foresee {

/// A record by the names of its numbers: t, x, y, z, vx, ax, fx, m, hx, r, hz, growth, growth_z, until, category, mask.
/// Numbers that are not given are 0, `until` +infinity, `m` and `category` 1, and `mask` every bit. Throws Error for a
/// name that the layout does not have.
std::vector<double> record_of(const Layout& layout,
                              std::initializer_list<std::pair<std::string_view, double>> numbers);

// A TPR-tree in memory whose changes wait until it is read. A part of MemoryTable.
//
//   PendingTree tree(layout, 60);
//   tree.put(7, record);
//   tree.find(7).size() == 5;                          // of this layout
//   tree.pages().find_root() != 0;                     // merges what waits: then 7 is in a leaf
//
// Cost: a look-up per change, and its share of a merge.
class PendingTree {
 public:
  PendingTree(const Layout& layout, double horizon);
  PendingTree(const PendingTree&) = delete;
  PendingTree& operator=(const PendingTree&) = delete;

  const Layout& layout() const { return pages_.layout(); }
  std::size_t size() const { return size_; }
  /// Requires: a record of this layout.
  void put(std::int64_t id, std::span<const double> record);
  bool erase(std::int64_t id);
  /// Valid until the next change, and until pages(); empty if the object does not exist.
  std::span<const double> find(std::int64_t id);
  /// The tree with all changes.
  MemoryPages& pages();

 private:
  bool is_stored(std::int64_t id) { return !erased_.contains(id) && pages_.find_leaf(id).has_value(); }
  /// Of the record of a slot.
  std::ptrdiff_t offset_of(std::size_t slot) const {
    return static_cast<std::ptrdiff_t>(slot * record_size_);
  }
  void drop_waiting(std::size_t slot);
  void merge_waiting();
  /// Appends the stored objects that do not wait.
  void collect_others(std::vector<std::int64_t>& ids, std::vector<double>& records);

  MemoryPages pages_;
  std::unique_ptr<TprTree> tree_;
  std::size_t record_size_, size_ = 0;
  std::unordered_map<std::int64_t, std::size_t> slots_;  ///< of the objects that wait
  std::vector<std::int64_t> ids_;                        ///< by slot
  std::vector<double> records_;
  std::unordered_set<std::int64_t> erased_;  ///< in the tree still
};

// The plans of a table in memory: their chunks, and the tree of them. A part of MemoryTable.
//
//   MemoryPlans plans(layout, 60, find_record);
//   plans.put(7, record, legs);                     // sets plan and chunks of the record
//   plans.erase(record);
//
// Guarantee: the numbers of the chunks of one object are consecutive, in order of time, and never used again.
// Cost: as PendingTree, per chunk.
class MemoryPlans final : public ChunkSource {
 public:
  using FindRecord = std::function<std::span<const double>(std::int64_t id)>;

  /// Requires: a layout with plans.
  MemoryPlans(const Layout& layout, double horizon, FindRecord find_record);
  MemoryPlans(const MemoryPlans&) = delete;
  MemoryPlans& operator=(const MemoryPlans&) = delete;

  /// Stores the legs and sets `plan` and `chunks` of the record; without legs both are 0.
  void put(std::int64_t id, std::span<double> record, std::span<const Leg> legs);
  /// Removes the chunks that the record names.
  void erase(std::span<const double> record);
  /// Replaces `legs` by those of the plan; empty: the record has none.
  void read_legs(std::span<const double> record, std::vector<Leg>& legs) const;

  NodeSource& tree() override { return tree_.pages(); }
  void read_chunk(std::int64_t number, const LegTimes& times, Chunk& chunk) override;

 private:
  /// One past the last one is first + count.
  struct Numbers {
    std::int64_t first, count;
  };
  struct OfChunk {
    std::int64_t object;
    std::vector<Leg> legs;
  };
  Numbers numbers_of(std::span<const double> record) const;

  Layout layout_;
  Offsets at_;
  PendingTree tree_;
  FindRecord find_record_;
  std::unordered_map<std::int64_t, OfChunk> chunks_;
  std::int64_t next_ = 1;
};

class MemoryTable final : public TableSource {
 public:
  /// `horizon`: the look-ahead for which the tree is arranged. Throws Error for a layout that queries do not know, for
  /// one with outlines or meshes, and for a horizon that is negative or not finite.
  MemoryTable(std::string name, const Layout& layout, double horizon = 60);
  MemoryTable(const MemoryTable&) = delete;
  MemoryTable& operator=(const MemoryTable&) = delete;

  /// Inserts the object, or replaces the one with this id. Throws Error for a record of another size, or with a number
  /// that a table refuses.
  void put(std::int64_t id, std::span<const double> record) { put(id, record, {}); }
  /// put() of an object with a plan; t, x, v, a of the record are set to those of its first leg. Throws Error as above,
  /// for legs that are not finite or do not follow each other in time, and for legs in a layout without plans.
  void put(std::int64_t id, std::span<const double> record, std::span<const Leg> legs);
  bool erase(std::int64_t id);
  /// Ends a transaction: later changes count from here on.
  void commit();

  const std::string& name() const override { return name_; }
  const Layout& layout() const override { return objects_.layout(); }
  double likely_objects() const override { return static_cast<double>(objects_.size()); }
  double newest_t() override;
  std::shared_ptr<const Scene> all(const SceneNeeds& needs = {}) override;
  bool is_loaded() override { return all_ != nullptr; }
  std::shared_ptr<const Scene> objects(std::span<const std::int64_t> ids, const LegTimes& times) override;
  /// Valid until the next change.
  std::shared_ptr<NodeSource> tree() override { return {std::shared_ptr<void>(), &objects_.pages()}; }
  /// Valid until the next change.
  std::shared_ptr<ChunkSource> chunks() override { return {std::shared_ptr<void>(), plans_.get()}; }
  std::optional<std::int64_t> stamp() override { return stamp_; }
  ChangedObjects changes_since(const std::optional<std::int64_t>& stamp) override;

 private:
  void changed(std::int64_t id);
  /// Throws Error unless legs are finite and follow each other.
  void require_legs(std::int64_t id, std::span<const Leg> legs) const;
  [[noreturn]] void reject(std::int64_t id, const std::string& what) const;
  std::shared_ptr<const Scene> read_objects(const LegTimes& times);

  std::string name_;
  PendingTree objects_;
  Offsets at_;  ///< of records
  std::vector<NumberColumn> columns_;
  std::unique_ptr<MemoryPlans> plans_;          ///< null: a layout without
  std::shared_ptr<const Scene> all_ = nullptr;  ///< of the current contents, once they are read
  std::set<std::int64_t> changed_ids_;          ///< since the last commit
  std::int64_t stamp_ = 0, committed_ = 0;
};

}  // namespace foresee
