// Plans of a table in memory: their chunks, and the tree of them. A part of MemoryTable (memory_table.h).
//
//   MemoryPlans plans(layout, 60, find_record);
//   plans.put(7, record, legs);                     // sets plan and chunks of the record
//   plans.erase(record);
//
// Guarantee: the numbers of the chunks of one object are consecutive, in order of time, and never used again.
// Cost: an insertion into the tree per chunk.
#pragma once

#include <functional>
#include <unordered_map>

#include "index/chunk_source.h"
#include "index/memory_pages.h"
#include "index/tpr_tree/tpr_tree.h"

namespace foresee {

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
  void read_chunk(std::int64_t number, Chunk& chunk) override { chunk = chunks_.at(number); }
  std::span<const double> find_object(std::int64_t id) override { return find_record_(id); }

 private:
  /// One past the last one is first + count.
  struct Numbers {
    std::int64_t first, count;
  };
  Numbers numbers_of(std::span<const double> record) const;

  Layout layout_;
  Offsets at_;
  MemoryPages pages_;
  std::unique_ptr<TprTree> tree_;
  FindRecord find_record_;
  std::unordered_map<std::int64_t, Chunk> chunks_;
  std::int64_t next_ = 1;
};

}  // namespace foresee
