// Stored chunks of plans in memory, opened and checked, with the records of their objects, as long as the stamp of
// their table does not change, but for own commits.
//
//   ChunkCache cache(memory, 9);                         // 9: doubles in the record of an object
//   const ChunkCache::Entry* known = cache.find(stamp, 8);
//   if (!known) cache.add(8, blob, opened);              // opened: the chunk of this blob
//   cache.add_record(8, record);                         // of its object, whose plan has this chunk
//   cache.note_commit(stamp, next, changed);             // all but these chunks are valid under the next stamp, too
//
// It holds committed rows only: a transaction that has written must read the rows themselves, so no rollback concerns
// it. Its memory counts as that of clean nodes (memory_budget.h); when it is full, the chunks that no query has used
// since the last time are dropped.
// Cost: a look-up in a hash table, most of it memory latency, which prefetch() hides. A row costs a statement, a
// checksum and the checks of its header.
#pragma once

#include <cstring>
#include <memory>
#include <new>
#include <optional>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

#include "database/memory_budget.h"
#include "format/chunk_blob.h"
#include "storage/nodes/node_slots.h"

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
  /// A chunk, the record of its object, and the bytes of its row, one behind the other in memory.
  class Entry {
   public:
    const StoredChunk& chunk() const { return chunk_; }
    /// Of the object; empty: not known.
    std::span<const double> record() const { return {record_numbers(), has_record_ ? record_size_ : 0}; }

   private:
    friend class ChunkCache;

    const double* record_numbers() const { return reinterpret_cast<const double*>(this + 1); }
    std::byte* memory() { return reinterpret_cast<std::byte*>(this + 1); }

    StoredChunk chunk_;
    std::size_t record_size_ = 0, bytes_ = 0;  ///< bytes_: of all
    bool has_record_ = false, is_used_ = true;
  };

  /// The budget must outlive it. `record_size`: doubles in the record of an object.
  ChunkCache(MemoryBudget& memory, std::size_t record_size)
      : share_(memory, *this), record_size_(record_size) {}

  /// Null if the chunk is not in memory. Drops all chunks first if they are of another stamp. Valid until the next
  /// add() or note_commit().
  const Entry* find(std::int64_t stamp, std::int64_t number) {
    if (stamp_ != stamp) {
      drop_nodes(true);
      stamp_ = stamp;
    }
    Entry* const known = at(number);
    if (known) known->is_used_ = true;
    return known;
  }
  /// Hides the memory latency of a following find(), and of reading its chunk.
  void prefetch(std::int64_t number) {
    constexpr std::size_t line = 64, lines = 9;  // of a chunk of 16 legs on a plane
    const std::byte* const known = reinterpret_cast<const std::byte*>(at(number));
    for (std::size_t i = 0; known && i < lines; ++i) __builtin_prefetch(known + i * line);
  }

  /// Adds a chunk of the stamp of the last find(), which has not found it. `chunk`: of the blob, which is copied.
  /// Requires: check_legs() accepts the chunk.
  void add(std::int64_t number, std::span<const std::byte> blob, const StoredChunk& chunk) {
    share_.budget().evict();
    Owned made = make(blob, chunk);
    Owned& place = chunks_[number];
    places_.forget(number);
    if (place) bytes_ -= size_of(*place);
    bytes_ += size_of(*made);
    place = std::move(made);
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
      places_.forget(number);
      bytes_ -= size_of(*found->second);
      chunks_.erase(found);
    });
    stamp_ = after;
    note_memory();
  }

  /// Adds the record to a chunk, if it is in memory.
  void add_record(std::int64_t number, std::span<const double> record) {
    Entry* const known = at(number);
    if (!known) return;
    std::memcpy(known->memory(), record.data(), record.size_bytes());
    known->has_record_ = true;
  }

 private:
  struct Free {
    void operator()(Entry* entry) const noexcept { ::operator delete(entry); }
  };
  using Owned = std::unique_ptr<Entry, Free>;
  static_assert(std::is_trivially_destructible_v<Entry> && sizeof(Entry) % alignof(double) == 0);

  Entry* at(std::int64_t number) {
    return places_.find(number, chunks_.size(), [this](std::int64_t wanted) {
      const auto found = chunks_.find(wanted);
      return found == chunks_.end() ? nullptr : found->second.get();
    });
  }

  Owned make(std::span<const std::byte> blob, const StoredChunk& chunk) const {
    const std::size_t record_bytes = record_size_ * sizeof(double);
    const std::size_t bytes = sizeof(Entry) + record_bytes + blob.size();
    Owned made(new (::operator new(bytes)) Entry());
    std::byte* const copy = made->memory() + record_bytes;
    std::memcpy(copy, blob.data(), blob.size());
    const auto moved = [&](const std::byte* from) { return from ? copy + (from - blob.data()) : from; };
    made->chunk_ = chunk;
    made->chunk_.starts = moved(chunk.starts);
    made->chunk_.numbers = moved(chunk.numbers);
    made->record_size_ = record_size_;
    made->bytes_ = bytes;
    return made;
  }

  /// With what both tables and the heap add.
  static std::size_t size_of(const Entry& entry) { return entry.bytes_ + 112; }
  void note_memory() noexcept { share_.hold_nodes(0, 0, bytes_); }

  void write_out() override {}
  void drop_nodes(bool all) override {
    places_.clear();
    for (auto one = chunks_.begin(); one != chunks_.end();) {
      Entry& entry = *one->second;
      if (!all && std::exchange(entry.is_used_, false)) {
        ++one;
        continue;
      }
      bytes_ -= size_of(entry);
      one = chunks_.erase(one);
    }
    note_memory();
  }

  MemoryShare share_;
  std::size_t record_size_;
  std::unordered_map<std::int64_t, Owned> chunks_;
  NumberPlaces<Entry> places_;
  std::size_t bytes_ = 0;
  std::optional<std::int64_t> stamp_;
};

}  // namespace foresee
