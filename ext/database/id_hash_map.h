// Hash map from object id to a number, with a look-up of some nanoseconds and an assignment that cannot fail.
//
//   map.prepare(42);             // may throw; 42 is still unknown
//   map.set(42, 7);              // cannot fail: the second half of an atomic change
//   map.find(42) == 7
//
// Open addressing with linear probing, at most half full. The hash has a random key, so no choice of ids
// makes it slow. Cost: 16 bytes per slot.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace foresee {

class IdHashMap {
 public:
  static constexpr std::int64_t unknown = -1;  ///< find() of an id without a value

  struct Entry {
    std::int64_t id, value;
  };

  IdHashMap();

  std::int64_t find(std::int64_t id) const noexcept;
  /// Hides the memory latency of a following call for `id`.
  void prefetch(std::int64_t id) const noexcept {
    if (!slots_.empty()) __builtin_prefetch(&slots_[home_of(id)]);
  }
  /// Reserves a slot for `id`.
  void prepare(std::int64_t id);
  /// Requires: prepared since the last clear(), or value is unknown.
  void set(std::int64_t id, std::int64_t value) noexcept;
  /// prepare(), find() and set() at once: returns the value before. If it throws, nothing has changed.
  std::int64_t exchange(std::int64_t id, std::int64_t value);
  /// All ids become unknown, but stay prepared.
  void reset() noexcept;
  /// Releases all memory.
  void clear() noexcept;

  /// The number of prepared ids.
  std::size_t size() const noexcept { return size_; }
  /// True if no id has a value.
  bool none_known() const noexcept { return known_ == 0; }
  std::size_t memory() const noexcept { return slots_.capacity() * sizeof(Entry); }
  /// All ids with a value, in no order.
  std::vector<Entry> known() const;

 private:
  static constexpr std::int64_t free_slot = std::numeric_limits<std::int64_t>::min();

  /// Where the search for an id starts.
  std::size_t home_of(std::int64_t id) const noexcept;
  std::size_t slot_of(std::int64_t id) const noexcept;
  void grow();

  std::vector<Entry> slots_;  // empty, or a power of two; at least half of them free
  std::size_t size_ = 0;
  std::size_t known_ = 0;  // prepared ids with a value
  std::uint64_t key_;
};

}  // namespace foresee
