// A table of moving objects in memory: for applications that embed the core without SQLite, and for tests.
//
//   MemoryTable ships("ships", {.axes = 2, .law = Law::uniform, .shape = Shape::ball});
//   ships.put(7, std::vector<double>{0, 0, 6, 0, 30});        // record_offsets(layout)
//   ships.commit();
//
//   MemoryTable robots("robots", with_plans);                  // .has_plan
//   robots.put(1, record, legs_of(plan));                      // one object of many legs
//
// Between two commits the table knows which objects changed. Guarantee: scenes and the tree hold the same
// doubles as the records that were put. Cost: an update of the tree per put, and per chunk of a plan; all() copies
// every object once per change. Outlines and meshes are not kept: a layout with `shape` needs a database.
#pragma once

#include <functional>
#include <set>
#include <unordered_map>

#include "index/chunk_source.h"
#include "index/memory_pages.h"
#include "index/tpr_tree/tpr_tree.h"
#include "query/table_source.h"

namespace foresee {

// The plans of a table in memory: their chunks, and the tree of them. A part of MemoryTable.
//
//   MemoryPlans plans(layout, 60, find_record);
//   plans.put(7, record, legs);                     // sets plan and chunks of the record
//   plans.erase(record);
//
// Guarantee: the numbers of the chunks of one object are consecutive, in order of time, and never used again.
// Cost: an insertion into the tree per chunk.
class MemoryPlans final : public ChunkSource {
 public:
  using FindRecord = std::function<std::span<const double>(std::int64_t id)>;

  /// Requires: a layout with plans.
  MemoryPlans(const Layout& layout, double horizon, FindRecord find_record);

  /// Stores the legs and sets `plan` and `chunks` of the record; without legs both are 0.
  void put(std::int64_t id, std::span<double> record, std::span<const Leg> legs);
  /// Removes the chunks that the record names.
  void erase(std::span<const double> record);
  /// Replaces `legs` by those of the plan; empty: the record has none.
  void read_legs(std::span<const double> record, std::vector<Leg>& legs) const;

  NodeSource& tree() override { return pages_; }
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
  MemoryPages pages_;
  std::unique_ptr<TprTree> tree_;
  FindRecord find_record_;
  std::unordered_map<std::int64_t, OfChunk> chunks_;
  std::int64_t next_ = 1;
};

class MemoryTable final : public TableSource {
 public:
  /// `horizon`: the look-ahead for which the tree is arranged. Requires: a layout without outlines and meshes.
  MemoryTable(std::string name, const Layout& layout, double horizon = 60);

  /// Inserts the object, or replaces the one with this id. Requires: a valid record.
  void put(std::int64_t id, std::span<const double> record) { put(id, record, {}); }
  /// put() of an object with a plan; t, x, v, a of the record are set to those of its first leg. Requires: a layout
  /// with plans and check_plan(), or no legs.
  void put(std::int64_t id, std::span<const double> record, std::span<const Leg> legs);
  bool erase(std::int64_t id);
  /// Ends a transaction: later changes count from here on.
  void commit();

  const std::string& name() const override { return name_; }
  const Layout& layout() const override { return pages_.layout(); }
  double likely_objects() const override { return static_cast<double>(pages_.object_count()); }
  double newest_t() override;
  std::shared_ptr<const Scene> all(const SceneNeeds& needs = {}) override;
  bool is_loaded() override { return all_ != nullptr; }
  std::shared_ptr<const Scene> objects(std::span<const std::int64_t> ids, const LegTimes& times) override;
  /// Valid until the next change.
  std::shared_ptr<NodeSource> tree() override { return {std::shared_ptr<void>(), &pages_}; }
  /// Valid until the next change.
  std::shared_ptr<ChunkSource> chunks() override { return {std::shared_ptr<void>(), plans_.get()}; }
  std::optional<std::int64_t> stamp() override { return stamp_; }
  ChangedObjects changes_since(const std::optional<std::int64_t>& stamp) override;

 private:
  void changed(std::int64_t id);
  /// Valid until the next change; null if the object does not exist.
  const double* find(std::int64_t id);
  /// As above; empty if the object does not exist.
  std::span<const double> find_record(std::int64_t id);
  std::shared_ptr<const Scene> read_objects(const LegTimes& times);

  std::string name_;
  MemoryPages pages_;
  std::unique_ptr<TprTree> tree_;
  std::unique_ptr<MemoryPlans> plans_;          ///< null: a layout without
  std::shared_ptr<const Scene> all_ = nullptr;  ///< of the current contents, once they are read
  std::set<std::int64_t> changed_ids_;          ///< since the last commit
  std::int64_t stamp_ = 0, committed_ = 0;
};

}  // namespace foresee
