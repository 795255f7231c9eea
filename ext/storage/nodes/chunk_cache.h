// Stored chunks of plans in memory, opened and checked, with the records of their objects, as long as the stamp of
// their table does not change, but for own commits.
//
//   ChunkCache cache(memory);
//   const ChunkCache::Entry* known = cache.find(stamp, 8);
//   if (!known) cache.add(8, blob, opened);              // opened: the chunk of this blob
//   cache.add_record(8, record);                         // of its object, whose plan has this chunk
//   cache.note_commit(stamp, next, changed);             // all but these chunks are valid under the next stamp, too
//
// It holds committed rows only: a transaction that has written must read the rows themselves, so no rollback concerns
// it. Its memory counts as that of clean nodes (memory_budget.h); when it is full, the chunks that no query has used
// since the last time are dropped.
// Cost: a look-up in a hash table, where a row costs a statement, a checksum and the checks of its header.
#pragma once

#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "storage/format/chunk_blob.h"
#include "storage/nodes/memory_budget.h"

namespace foresee {

/// Numbers of chunks that a transaction removes, or whose object it changes.
class ChangedChunks {
 public:
  /// Adds the numbers from `first` to `last`.
  void add(std::int64_t first, std::int64_t last) {
    if (are_all_) return;
    count_ += last - first + 1;
    if (count_ > max_numbers) return add_all();
    ranges_.emplace_back(first, last);
  }
  void add_all() noexcept {
    are_all_ = true;
    ranges_.clear();
  }
  void clear() noexcept {
    are_all_ = false;
    ranges_.clear();
    count_ = 0;
  }

  bool are_all() const { return are_all_; }
  template <class Each>
  void for_each(Each each) const {
    for (const auto& [first, last] : ranges_)
      for (std::int64_t number = first; number <= last; ++number) each(number);
  }

 private:
  /// A commit of more costs more than reading chunks again.
  static constexpr std::int64_t max_numbers = 10000;

  std::vector<std::pair<std::int64_t, std::int64_t>> ranges_;
  std::int64_t count_ = 0;
  bool are_all_ = false;
};

class ChunkCache final : private MemoryHolder {
 public:
  struct Entry {
    std::vector<std::byte> blob;
    StoredChunk chunk;
    std::vector<double> record = {};  ///< of the object; empty: not known
    bool is_used = true;
  };

  /// The budget must outlive it.
  explicit ChunkCache(MemoryBudget& memory) : share_(memory, *this) {}

  /// Null if the chunk is not in memory. Drops all chunks first if they are of another stamp. Valid until the next
  /// call.
  const Entry* find(std::int64_t stamp, std::int64_t number) {
    if (stamp_ != stamp) {
      drop_nodes(true);
      stamp_ = stamp;
    }
    const auto found = chunks_.find(number);
    if (found == chunks_.end()) return nullptr;
    found->second.is_used = true;
    return &found->second;
  }

  /// Adds a chunk of the stamp of the last find(), which has not found it. `chunk`: of the blob, which is copied.
  /// Requires: check_legs() accepts the chunk.
  void add(std::int64_t number, std::span<const std::byte> blob, const StoredChunk& chunk) {
    share_.budget().evict();
    Entry made{{blob.begin(), blob.end()}, chunk};
    const auto moved = [&](const std::byte* at) { return at ? made.blob.data() + (at - blob.data()) : at; };
    made.chunk.starts = moved(chunk.starts);
    made.chunk.numbers = moved(chunk.numbers);
    const Entry& entry = chunks_.insert_or_assign(number, std::move(made)).first->second;
    bytes_ += size_of(entry);
    note_memory();
  }

  /// A transaction of this connection has replaced stamp `before` by `after`. Keeps the chunks of `before` that it has
  /// not changed.
  void note_commit(std::optional<std::int64_t> before, std::int64_t after,
                   const ChangedChunks& changed) noexcept {
    if (!before || stamp_ != before || changed.are_all()) return;  // the next find() drops them
    changed.for_each([this](std::int64_t number) {
      const auto found = chunks_.find(number);
      if (found == chunks_.end()) return;
      bytes_ -= size_of(found->second);
      chunks_.erase(found);
    });
    stamp_ = after;
    note_memory();
  }

  /// Adds the record to a chunk, if it is in memory.
  void add_record(std::int64_t number, std::span<const double> record) {
    const auto found = chunks_.find(number);
    if (found == chunks_.end()) return;
    Entry& entry = found->second;
    const std::size_t before = size_of(entry);
    entry.record.assign(record.begin(), record.end());
    bytes_ += size_of(entry) - before;
    note_memory();
  }

 private:
  /// With what the hash table and the heap add.
  static std::size_t size_of(const Entry& entry) {
    return entry.blob.size() + entry.record.size() * sizeof(double) + sizeof(Entry) + 80;
  }
  void note_memory() noexcept { share_.hold_nodes(0, 0, bytes_); }

  void write_out() override {}
  void drop_nodes(bool all) override {
    for (auto one = chunks_.begin(); one != chunks_.end();) {
      Entry& entry = one->second;
      if (!all && std::exchange(entry.is_used, false)) {
        ++one;
        continue;
      }
      bytes_ -= size_of(entry);
      one = chunks_.erase(one);
    }
    note_memory();
  }

  MemoryShare share_;
  std::unordered_map<std::int64_t, Entry> chunks_;
  std::size_t bytes_ = 0;
  std::optional<std::int64_t> stamp_;
};

}  // namespace foresee
