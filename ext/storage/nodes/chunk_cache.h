// Stored chunks of plans in memory, opened and checked, with the records of their objects, as long as the stamp of
// their table does not change.
//
//   ChunkCache cache(memory);
//   const ChunkCache::Entry* known = cache.find(stamp, 8);
//   if (!known) cache.add(8, blob, opened);              // opened: the chunk of this blob
//   cache.add_record(8, record);                         // of its object, whose plan has this chunk
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
    made.chunk.starts = moved(chunk.starts), made.chunk.numbers = moved(chunk.numbers);
    const Entry& entry = chunks_.insert_or_assign(number, std::move(made)).first->second;
    bytes_ += size_of(entry);
    note_memory();
  }

  /// Adds the record to a chunk, if it is in memory.
  void add_record(std::int64_t number, std::span<const double> record) {
    const auto found = chunks_.find(number);
    if (found == chunks_.end()) return;
    Entry& entry = found->second;
    bytes_ -= size_of(entry);
    entry.record.assign(record.begin(), record.end());
    bytes_ += size_of(entry);
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
